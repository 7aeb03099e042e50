#pragma once

#include "Annotations.h"
#include "Ticks.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
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
} // namespace antinode
