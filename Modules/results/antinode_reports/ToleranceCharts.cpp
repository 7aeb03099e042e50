#include "ToleranceCharts.h"

#include <algorithm>
#include <array>
#include <limits>

namespace antinode
{
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
