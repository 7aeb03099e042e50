#include "BankCharts.h"

#include "PlateCharts.h"
#include "Ticks.h"

#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace antinode
{
namespace
{
constexpr auto missing = std::numeric_limits<double>::quiet_NaN();

double orMissing (double volts)
{
    return volts > 0 ? volts : missing;
}

Eigen::Index columnsOf (const BankVolts& volts)
{
    const auto next = std::find_if (volts.places.begin(), volts.places.end(),
                                    [&] (const auto& place) { return place.second > volts.places.front().second; });
    return next - volts.places.begin();
}

/** Each place fills a cell, also where one of them was moved to the focus's own place. */
HeatMap mapOf (const ModalModel& model, const BankVolts& volts)
{
    const auto count = static_cast<Eigen::Index> (volts.places.size());
    const auto columns = std::max<Eigen::Index> (columnsOf (volts), 1), rows = (count + columns - 1) / columns;
    HeatMap chart;
    chart.values.setConstant (rows, columns, missing);

    for (Eigen::Index i = 0; i < count; ++i)
        chart.values (i / columns, i % columns) = orMissing (volts.peaks[static_cast<std::size_t> (i)]);

    const auto& surface = model.surface;
    chart.x = { surface.xMinimum * milli, surface.xMaximum * milli };
    chart.y = { surface.yMinimum * milli, surface.yMaximum * milli };
    chart.xLabel = "x (mm)";
    chart.yLabel = "y (mm)";
    chart.valueLabel = "peak voltage (V)";
    chart.equalAspect = true;
    chart.rectangles = ceramicRectangles (model);

    // Numbers of ceramics would hide what the places near them need.
    for (auto& rectangle : chart.rectangles)
        rectangle.label.clear();

    return chart;
}

/** From left to right: one of them may have been moved to the focus's own place. */
std::vector<std::size_t> alongX (const BankVolts& volts)
{
    std::vector<std::size_t> order (volts.places.size());
    std::iota (order.begin(), order.end(), std::size_t { 0 });
    std::stable_sort (order.begin(), order.end(),
                      [&] (std::size_t one, std::size_t other)
                      { return volts.places[one].first < volts.places[other].first; });
    return order;
}

LineChart curvesOf (const BankVolts& volts)
{
    const auto order = alongX (volts);
    const auto count = static_cast<Eigen::Index> (volts.places.size());
    Series peaks, bounds;
    peaks.name = "peak voltage";
    bounds.name = "no waveform needs less";
    bounds.style = LineStyle::dashed;
    peaks.x.resize (count);
    peaks.y.resize (count);
    bounds.y.resize (count);

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto at = order[static_cast<std::size_t> (i)];
        peaks.x[i] = volts.places[at].first * milli;
        peaks.y[i] = orMissing (volts.peaks[at]);
        bounds.y[i] = orMissing (volts.bounds[at]);
    }

    bounds.x = peaks.x;
    LineChart chart;
    chart.xLabel = "x (mm)";
    chart.yLabel = "peak voltage (V)";
    chart.series = { peaks };

    if (! bounds.y.array().isNaN().all())
        chart.series.push_back (bounds);

    // A limit far above what is needed would leave nothing to see.
    if (const auto highest = *std::max_element (volts.peaks.begin(), volts.peaks.end());
        highest > 0 && volts.limit < 2 * highest)
        chart.limits = { { volts.limit, "limit" } };

    return chart;
}
} // namespace

Chart bankVoltsChart (const ModalModel& model, const BankVolts& volts)
{
    if (model.surface.kind == SurfaceKind::plate)
        return mapOf (model, volts);

    return curvesOf (volts);
}

BarChart methodVoltsChart (const std::vector<MethodVolts>& volts, double bound, double limit)
{
    BarChart chart;
    chart.yLabel = "peak voltage (V)";
    chart.legend = LegendPlace::none;
    BarSeries peaks;
    peaks.values.resize (static_cast<Eigen::Index> (volts.size()));
    double highest = 0;

    for (std::size_t i = 0; i < volts.size(); ++i)
    {
        chart.categories.push_back (volts[i].method);
        peaks.values[static_cast<Eigen::Index> (i)] = orMissing (volts[i].peak);
        highest = std::max (highest, volts[i].peak);
    }

    chart.series = { peaks };

    if (bound > 0)
        chart.limits.push_back ({ bound, "bound" });

    if (limit < 2 * highest)
        chart.limits.push_back ({ limit, "limit" });

    return chart;
}
} // namespace antinode
