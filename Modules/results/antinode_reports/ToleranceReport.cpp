#include "ToleranceReport.h"

#include <antinode_base/MessageText.h>
#include <antinode_documents/ToleranceFile.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

namespace antinode
{
namespace
{
constexpr double toPercent = 100;
constexpr int shownModes = 16;
constexpr std::size_t shownSentences = 5, shownCauses = 30;
constexpr std::size_t median = 2, high = 4; // of the percentiles

std::vector<std::string> cells (const std::string& design, const std::string& name, const Percentiles& values,
                                double factor, int decimals)
{
    std::vector<std::string> row { design, name };

    for (const auto value : values)
        row.push_back (fixedText (factor * value, decimals));

    return row;
}

ReportTable percentileTable (const std::vector<DesignTolerance>& designs)
{
    ReportTable table { "Percentiles over the devices", { "design", "score" }, {} };

    for (const auto percentile : tolerancePercents)
        table.header.push_back (fixedText (percentile, 0) + " %");

    for (const auto& design : designs)
    {
        table.rows.push_back (cells (design.name, "v-score", design.tolerance.vScore, 1, 4));
        table.rows.push_back (cells (design.name, "field error (%)", design.tolerance.fieldError, toPercent, 2));
        table.rows.push_back (cells (design.name, "peak ratio", design.tolerance.peakRatio, 1, 4));
    }

    return table;
}

ReportSection fieldSection (const std::vector<DesignTolerance>& designs)
{
    ReportSection section;
    section.heading = "Field on other devices";
    section.figures.push_back (
        { "Histogram of the field error over the devices.", {}, toleranceHistogram (designs), reportFigureWidth, 320 });
    section.figures.push_back ({ "Cumulative distribution of the field error; dots are the percentiles 5, 25, 50, 75 "
                                 "and 95.",
                                 {},
                                 toleranceShares (designs),
                                 reportFigureWidth,
                                 320 });
    section.tables.push_back (percentileTable (designs));
    return section;
}

ReportTable causeTable (const ModalModel& model, const Tolerance& tolerance)
{
    ReportTable table { "Largest causes", { "mode", "frequency (Hz)", "deviation", "field error (%)" }, {} };

    for (std::size_t i = 0; i < std::min (shownCauses, tolerance.causes.size()); ++i)
    {
        const auto& cause = tolerance.causes[i];
        table.rows.push_back ({ cause.mode ? std::to_string (*cause.mode + 1) : "all",
                                cause.mode ? fixedText (model.frequencyHz (*cause.mode), 1) : "",
                                std::string (wordFor (toleranceKindWords, cause.kind)),
                                fixedText (toPercent * cause.fieldError, 3) });
    }

    return table;
}

ReportSection causeSection (const ModalModel& model, const Tolerance& tolerance)
{
    ReportSection section;
    section.heading = "Largest causes of error";
    section.paragraphs.emplace_back (
        "The effect of one deviation alone, everything else being nominal: the RMS change of "
        "the field over its spread, relative to the wanted field.");

    for (std::size_t i = 0; i < std::min (shownSentences, tolerance.causes.size()); ++i)
        section.paragraphs.push_back (causeSentence (tolerance.causes[i], model));

    section.figures.push_back ({ "The modes with the largest errors, ordered by their highest bar.",
                                 {},
                                 toleranceCauseChart (tolerance, shownModes),
                                 reportFigureWidth,
                                 340 });
    section.tables.push_back (causeTable (model, tolerance));
    return section;
}

std::string spreadInWords (const ToleranceOptions& options)
{
    const auto& spread = options.spread;
    return std::to_string (options.draws) + " devices, seed " + std::to_string (options.seed)
           + "; standard deviations: frequency " + inWords (toPercent * spread.frequency) + " %, damping "
           + inWords (toPercent * spread.damping) + " %, participation " + inWords (toPercent * spread.participation)
           + " %, drift of all frequencies " + inWords (toPercent * spread.drift) + " %";
}
} // namespace

ReportPage toleranceReport (const ModalModel& model, const std::string& focus,
                            const std::vector<DesignTolerance>& designs)
{
    const auto& reported = designs.back();
    const auto& tolerance = reported.tolerance;
    ReportPage page;
    page.title = focus + ": tolerance";
    page.subtitle = model.name + ", " + reported.name + " design. " + spreadInWords (tolerance.options);
    page.scores = { { "v-score", fixedText (tolerance.vScore[median], 4), "Median over the devices; 1 is best." },
                    { "Field error", fixedText (toPercent * tolerance.fieldError[median], 2) + " %",
                      "Median over the devices, against the field that the controlled modes represent." },
                    { "Field error, 95 %", fixedText (toPercent * tolerance.fieldError[high], 2) + " %",
                      "95 % of the devices have less." },
                    { "Peak voltage", inWords (reported.peakVoltage) + " V", "Of the " + reported.name + " design." } };

    for (const auto& design : designs)
        if (design.name != reported.name)
            page.scores.push_back ({ "Field error, " + design.name,
                                     fixedText (toPercent * design.tolerance.fieldError[median], 2) + " %",
                                     "Median of the " + design.name + " design on the same devices, at a peak of "
                                         + inWords (design.peakVoltage) + " V." });

    page.sections = { fieldSection (designs), causeSection (model, tolerance) };
    page.links = { { "design.json", "design.json" }, { "tolerance.json", "tolerance.json" } };
    page.footer = "Antinode " ANTINODE_VERSION ". Fields are computed in closed form at the focus time.";
    return page;
}

namespace
{
constexpr double percent = 100;

std::vector<double> fieldErrors (const Tolerance& tolerance)
{
    std::vector<double> errors;

    for (const auto& score : tolerance.draws)
        errors.push_back (percent * score.fieldError);

    std::sort (errors.begin(), errors.end());
    return errors;
}

double largestError (const std::vector<DesignTolerance>& designs)
{
    double largest = 0;

    for (const auto& design : designs)
        largest = std::max (largest, fieldErrors (design.tolerance).back());

    return largest;
}

/** Steps: each bin from its left to its right edge. */
Series binned (const std::vector<double>& errors, double width, int bins)
{
    Series series;
    series.filled = true;
    series.x = Eigen::VectorXd::Zero (2 * bins + 2);
    series.y = Eigen::VectorXd::Zero (2 * bins + 2);

    for (const auto error : errors)
    {
        const auto bin = std::clamp (static_cast<int> (error / width), 0, bins - 1);
        series.y[2 * bin + 1] += 1;
        series.y[2 * bin + 2] += 1;
    }

    for (int edge = 0; edge <= bins; ++edge)
        series.x.segment<2> (2 * edge).setConstant (edge * width);

    return series;
}

Series shareCurve (const DesignTolerance& design, int colour)
{
    const auto errors = fieldErrors (design.tolerance);
    const auto count = static_cast<Eigen::Index> (errors.size());
    Series series;
    series.name = design.name;
    series.colour = colour;
    series.x = Eigen::Map<const Eigen::VectorXd> (errors.data(), count);
    series.y = Eigen::VectorXd::LinSpaced (count, percent / static_cast<double> (count), percent);
    return series;
}

/** Dots with gaps between them, so that no line joins them. */
Series percentileDots (const Tolerance& tolerance, int colour)
{
    constexpr auto gap = std::numeric_limits<double>::quiet_NaN();
    constexpr auto count = static_cast<Eigen::Index> (tolerancePercents.size());
    Series series;
    series.points = true;
    series.colour = colour;
    series.x = Eigen::VectorXd::Constant (2 * count, gap);
    series.y = series.x;

    for (Eigen::Index i = 0; i < count; ++i)
    {
        series.x[2 * i] = percent * tolerance.fieldError[static_cast<std::size_t> (i)];
        series.y[2 * i] = tolerancePercents[static_cast<std::size_t> (i)];
    }

    return series;
}

/** The modes of the largest causes, each once. */
std::vector<int> worstModes (const Tolerance& tolerance, int count)
{
    std::vector<int> modes;

    for (const auto& cause : tolerance.causes)
        if (cause.mode && static_cast<int> (modes.size()) < count
            && std::find (modes.begin(), modes.end(), *cause.mode) == modes.end())
            modes.push_back (*cause.mode);

    return modes;
}
} // namespace

LineChart toleranceHistogram (const std::vector<DesignTolerance>& designs)
{
    constexpr int bins = 40;
    const auto width = std::max (largestError (designs), 1e-9) / bins;
    LineChart chart;
    chart.xLabel = "field error (%)";
    chart.yLabel = "devices";

    for (const auto& design : designs)
    {
        auto series = binned (fieldErrors (design.tolerance), width, bins);
        series.name = design.name;
        chart.series.push_back (std::move (series));
    }

    return chart;
}

LineChart toleranceShares (const std::vector<DesignTolerance>& designs)
{
    LineChart chart;
    chart.xLabel = "field error (%)";
    chart.yLabel = "devices with at most this error (%)";
    chart.xRange = AxisRange { 0, largestError (designs) };
    chart.yRange = AxisRange { 0, percent };

    for (const auto& design : designs)
    {
        const auto colour = static_cast<int> (chart.series.size() / 2);
        chart.series.push_back (shareCurve (design, colour));
        chart.series.push_back (percentileDots (design.tolerance, colour));
    }

    return chart;
}

BarChart toleranceCauseChart (const Tolerance& tolerance, int count)
{
    const auto modes = worstModes (tolerance, count);
    constexpr std::array<const char*, 3> names { "frequency", "damping", "participations" };
    BarChart chart;
    chart.xLabel = "mode";
    chart.yLabel = "field error (%)";

    for (const auto mode : modes)
        chart.categories.push_back (std::to_string (mode + 1));

    for (const auto* name : names)
        chart.series.push_back ({ name, Eigen::VectorXd::Zero (static_cast<Eigen::Index> (modes.size())) });

    for (const auto& cause : tolerance.causes)
        if (const auto found = cause.mode ? std::find (modes.begin(), modes.end(), *cause.mode) : modes.end();
            found != modes.end())
            chart.series[static_cast<std::size_t> (cause.kind)].values[found - modes.begin()] =
                percent * cause.fieldError;

    return chart;
}
} // namespace antinode
