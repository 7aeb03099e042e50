#pragma once

#include "Ticks.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace antinode
{
/** A horizontal line at a value that must not, or should, be reached; its label stands outside the plot. */
struct LimitLine
{
    double value = 0; ///< In the unit of the y axis.
    std::string label;
};

/** A vertical line at an instant or a place; its label stands above the plot. */
struct Marker
{
    double position = 0; ///< In the unit of the x axis.
    std::string label;
};

/** A shaded part of the x axis, for example where a ceramic lies; its label stands above the plot. */
struct Span
{
    double from = 0, to = 0; ///< In the unit of the x axis.
    std::string label;
};

/** The position of the legend: never over data. */
enum class LegendPlace
{
    top,
    right,
    none
};

/** The style of a line. */
enum class LineStyle
{
    solid,
    dashed,
    dotted
};

/** A series' colour is an index into Theme::series, or one of these. */
namespace series_colour
{
constexpr int byOrder = -1; ///< The next of the theme's colours.
constexpr int neutral = -2; ///< The colour of text: for what others are compared with.
} // namespace series_colour

/** One bar for each category. Values that are not finite, or not positive on a logarithmic axis, have no bar. */
struct BarSeries
{
    std::string name;
    Eigen::VectorXd values; ///< One for each category, in the unit of the y axis.
    int colour = series_colour::byOrder;
};

/** Bars of each category side by side, for example a modal spectrum: wanted and achieved for each mode. Where they
   would be too thin for that, series are drawn over each other in their order, with marks at the ends of those below.
 */
struct BarChart
{
    std::string title, xLabel, yLabel; ///< Labels include the unit.
    std::vector<std::string> categories;
    std::vector<BarSeries> series;
    std::optional<AxisRange> yRange; ///< Chosen from the data where it is missing.
    bool logarithmic = false;
    std::vector<LimitLine> limits;
    LegendPlace legend = LegendPlace::top;
};

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

/** One curve. Values that are not finite leave a gap. */
struct Series
{
    std::string name;
    Eigen::VectorXd x, y; ///< As many x as y, in the units of the axes.
    LineStyle style = LineStyle::solid;
    bool filled = false; ///< The area down to zero is tinted.
    bool points = false; ///< Each value gets a dot.
    int colour = series_colour::byOrder;
};

/** Curves over a common x axis. A curve with more values than pixels keeps every extreme. */
struct LineChart
{
    std::string title, xLabel, yLabel; ///< Labels include the unit: "time (ms)".
    std::vector<Series> series;
    std::optional<AxisRange> xRange, yRange; ///< Chosen from the data where they are missing.
    bool logarithmicX = false, logarithmicY = false;
    std::vector<LimitLine> limits;
    std::vector<Marker> markers;
    std::vector<Span> spans;
    LegendPlace legend = LegendPlace::top;
};

/** A surface from above: where things lie on it. */
struct PlanView
{
    std::string title, xLabel,
        yLabel;             ///< Labels include the unit. Without a y label the y direction has no scale: a beam.
    AxisRange x, y;         ///< The surface.
    MapShape surface;       ///< Its outline where it does not fill the ranges; empty: it does.
    MapShape heldPieces;    ///< Open lines: the parts of the outline drawn hatched.
    MapShape elasticPieces; ///< The same, drawn as zigzags.
    std::vector<MapRectangle> rectangles;
    std::vector<MapPoint> points;
    bool heldLeft = false, heldRight = false, heldBottom = false, heldTop = false; ///< Edges drawn hatched.
};

/** Many signals over one time axis, a lane for each, all with the same scale: the voltages of all ceramics.
    At the right of each lane stands its peak value, in a warning colour where it exceeds the limit. */
struct StackedTraces
{
    std::string title, xLabel; ///< The label includes the unit of start and step.
    std::string unit;          ///< Of the values, for example "V".
    std::vector<std::string> names;
    double start = 0, step = 1; ///< x of the first sample, and from one sample to the next.
    Eigen::MatrixXd values;     ///< A row for each lane, a column for each sample.
    Eigen::VectorXd limits;     ///< One for each lane: drawn at plus and minus; empty if there is none.
    std::vector<Marker> markers;
};

/** A height at which every lane and its name are legible, in pixels at scale 1. [any] */
int comfortableHeight (const StackedTraces&);

/** One chart. */
using Panel = std::variant<LineChart, BarChart, HeatMap, StackedTraces>;

/** Small multiples: panels of the same kind side by side, row by row, to be compared. */
struct ChartGrid
{
    std::string title, xLabel, yLabel; ///< Labels of all panels together: leave those of the panels empty.
    int columns = 1;                   ///< 1 or more.
    std::vector<Panel> panels;
    std::vector<std::string> columnTitles, rowTitles; ///< Empty, or one for each.
    bool sharedScale = true;                          ///< Line charts and bar charts get one common y range.
    bool sharedLegend = true; ///< The legend of the first panel that has one stands once, above all.
};

/** Anything that can be drawn. */
using Chart = std::variant<LineChart, BarChart, HeatMap, StackedTraces, PlanView, ChartGrid>;
} // namespace antinode
