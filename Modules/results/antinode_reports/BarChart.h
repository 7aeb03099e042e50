#pragma once

#include "Annotations.h"
#include "Ticks.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
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
} // namespace antinode
