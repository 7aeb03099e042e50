#include "MapReport.h"

#include "PlateCharts.h"
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

namespace antinode
{
namespace
{
constexpr double percents = 100;
constexpr auto noValue = std::numeric_limits<double>::quiet_NaN();

/** One number of all places, with how it is told. */
struct MappedNumber
{
    std::string label;    ///< With its unit.
    std::string sentence; ///< What it is.
    std::function<std::optional<double> (const MapPlace&)> value;
};

std::vector<MappedNumber> mappedNumbers (const FocusMap& map)
{
    return {
        { "captured", "Captured: the root of the energy that the controlled modes represent, 1 is best.",
          [] (const MapPlace& place) { return place.captured; } },
        { "v-score", "V-score: correlation of the field at the focus with the wanted one, 1 is best.",
          [] (const MapPlace& place) { return place.vScore; } },
        { "peak voltage (V)",
          "Peak voltage that the focus needs there; " + inWords (map.voltageLimit) + " V are allowed.",
          [] (const MapPlace& place) { return place.peakVoltage; } },
        { "felt contrast (dB)", "Felt contrast: sensation level at the focus over the strongest place farther away.",
          [] (const MapPlace& place) { return place.contrast; } },
        { "modes beyond (%)", "Part of the field in modes beyond the device's own.",
          [] (const MapPlace& place) { return percents * place.spillOver; } },
    };
}

Eigen::VectorXd valuesOf (const FocusMap& map, const MappedNumber& number)
{
    Eigen::VectorXd values (static_cast<Eigen::Index> (map.places.size()));
    std::transform (map.places.begin(), map.places.end(), values.begin(),
                    [&] (const MapPlace& place)
                    { return place.error.empty() ? number.value (place).value_or (noValue) : noValue; });
    return values;
}

/** The values that there are, in order. */
std::vector<double> sortedValues (const Eigen::VectorXd& values)
{
    std::vector<double> sorted;
    std::copy_if (values.begin(), values.end(), std::back_inserter (sorted), [] (double v) { return v == v; });
    std::sort (sorted.begin(), sorted.end());
    return sorted;
}

ReportFigure plateFigure (const FocusMap& map, const MappedNumber& number, const ModalModel& model)
{
    HeatMap chart;
    chart.values = valuesOf (map, number).reshaped (map.columns, map.rows).transpose();
    chart.xLabel = "x (mm)";
    chart.yLabel = "y (mm)";
    chart.valueLabel = number.label;
    chart.x = { map.xMinimum * milli, map.xMaximum * milli };
    chart.y = { map.yMinimum * milli, map.yMaximum * milli };
    chart.equalAspect = true;
    chart.rectangles = ceramicRectangles (model);
    constexpr int height = 480;
    return { number.sentence, {}, std::move (chart), reportFigureWidth, height };
}

ReportFigure lineFigure (const FocusMap& map, const MappedNumber& number, const ModalModel& model)
{
    Eigen::VectorXd places (static_cast<Eigen::Index> (map.places.size()));
    std::transform (map.places.begin(), map.places.end(), places.begin(), [] (const auto& p) { return p.x * milli; });
    LineChart chart;
    chart.xLabel = "position of the focus (mm)";
    chart.yLabel = number.label;
    chart.series = { { number.label, places, valuesOf (map, number) } };
    chart.legend = LegendPlace::none;

    for (const auto& ceramic : model.ceramics)
        chart.spans.push_back ({ ceramic.xMinimum * milli, ceramic.xMaximum * milli, ceramic.name });

    constexpr int height = 260;
    return { number.sentence, {}, std::move (chart), reportFigureWidth, height };
}
} // namespace

ReportPage mapReport (const FocusMap& map, const ModalModel& model)
{
    ReportPage page;
    page.title = map.focus + ": map";
    page.subtitle = map.device + ", " + std::to_string (map.places.size()) + " places";
    ReportSection section;
    section.heading = "The focus at every place";
    section.paragraphs = {
        "Each value is that of a design of its own, with its target at that place. Fields are computed "
        "in closed form at the focus time."
    };
    ReportTable table { "Over all places", { "", "least", "median", "largest" }, {} };

    for (const auto& number : mappedNumbers (map))
    {
        const auto sorted = sortedValues (valuesOf (map, number));

        if (sorted.empty())
            continue;

        section.figures.push_back (map.rows == 1 ? lineFigure (map, number, model) : plateFigure (map, number, model));
        const auto median = inWords (sorted[sorted.size() / 2]);
        table.rows.push_back ({ number.label, inWords (sorted.front()), median, inWords (sorted.back()) });
        page.scores.push_back ({ number.label, median, "Median over the places." });
    }

    const auto failed =
        std::count_if (map.places.begin(), map.places.end(), [] (const auto& place) { return ! place.error.empty(); });

    if (failed > 0)
        page.warnings.push_back (std::to_string (failed) + " places have no design; map.csv says why.");

    section.tables.push_back (std::move (table));
    page.sections = { std::move (section) };
    page.links = { { "map.csv", "map.csv" } };
    page.footer = "Antinode " ANTINODE_VERSION ".";
    return page;
}
} // namespace antinode
