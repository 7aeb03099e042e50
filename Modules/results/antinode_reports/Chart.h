#pragma once

#include "BarChart.h"
#include "HeatMap.h"
#include "LineChart.h"
#include "PlanView.h"
#include "StackedTraces.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace antinode
{
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
