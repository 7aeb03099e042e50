#pragma once

#include "Annotations.h"
#include "Ticks.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The colour scale. */
enum class ColourScale
{
    sequential, ///< From little to much.
    diverging   ///< Balanced about zero: the range is made symmetrical.
};

/** Closed lines, each back to its first place, in the units of the axes; inside is what an odd number of them encloses.
 */
using MapShape = std::vector<std::vector<Eigen::Vector2d>>;

/** A rectangle over a map, or a shape in it, for example a ceramic. */
struct MapRectangle
{
    double xMinimum = 0, xMaximum = 0, yMinimum = 0, yMaximum = 0; ///< In the units of the axes.
    std::string label;
    MapShape shape {}; ///< Empty: all of the rectangle.
};

/** A cross over a map, for example the focus. */
struct MapPoint
{
    double x = 0, y = 0; ///< In the units of the axes.
    std::string label;
};

/** Lines of equal values over a map. */
struct MapContours
{
    std::vector<double> levels; ///< In the unit of the values.
    std::optional<double>
        nodalLinesFrom; ///< Zero lines, thinner, where neighbouring values reach this; none: no such lines.
};

/** A matrix as colours: a spectrogram, or a field over the plane or over time. Values that are not finite stay empty.
 */
struct HeatMap
{
    std::string title, xLabel, yLabel, valueLabel; ///< Labels include the unit.
    Eigen::MatrixXd values;                        ///< A row for each y from below, a column for each x.
    AxisRange x, y;                                ///< The range between the outer edges of the matrix.
    std::optional<AxisRange> valueRange;           ///< Chosen from the data where it is missing.
    ColourScale scale = ColourScale::sequential;
    bool equalAspect = false; ///< One unit is as long in x as in y: for plates.
    std::vector<MapRectangle> rectangles;
    std::vector<MapPoint> points;
    std::vector<Marker> markers;
    MapContours contours;
    MapShape surface;                               ///< What of the map is shown; empty: all of it.
    std::vector<std::string> columnNames, rowNames; ///< A table: each value fills its cell, names stand at the axes.
    bool isBare = false;                            ///< Without axes and colour bar: a small map among others.
};
} // namespace antinode
