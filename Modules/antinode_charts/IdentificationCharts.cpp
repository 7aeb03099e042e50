#include "IdentificationCharts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/** Dots without a line between them: a gap stands behind each. */
Series dots (const std::string& name, const std::vector<StabilisationPoint>& points, bool stable, int colour)
{
    Series series;
    series.name = name;
    series.points = true;
    series.colour = colour;
    std::vector<double> x, y;

    for (const auto& point : points)
        if (point.stable == stable)
        {
            x.insert (x.end(), { point.frequency, point.frequency });
            y.insert (y.end(), { static_cast<double> (point.order), nothing });
        }

    series.x = Eigen::Map<const Eigen::VectorXd> (x.data(), static_cast<Eigen::Index> (x.size()));
    series.y = Eigen::Map<const Eigen::VectorXd> (y.data(), static_cast<Eigen::Index> (y.size()));
    return series;
}

/** Root of the mean square over points and references at each line. */
Eigen::VectorXd meanMagnitude (const FrequencyResponses& responses)
{
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero (responses.frequencies.size());

    for (const auto& values : responses.values)
        sum += values.cwiseAbs2()
                   .unaryExpr ([] (double square) { return std::isfinite (square) ? square : 0.0; })
                   .rowwise()
                   .sum()
                   .array();

    return sum.sqrt();
}

/** The magnitude in decades, stretched between two orders. */
Series magnitudeBehind (const FrequencyResponses& responses, double lowest, double highest)
{
    const Eigen::ArrayXd magnitude = meanMagnitude (responses);
    const auto largest = magnitude.maxCoeff();
    const Eigen::ArrayXd decades = (magnitude / largest).max (1e-12).log10();
    Series series;
    series.name = "mean magnitude (logarithmic, arbitrary scale)";
    series.x = responses.frequencies;
    series.y = lowest + (highest - lowest) * (decades - decades.minCoeff()) / std::max (-decades.minCoeff(), 1e-12);
    series.colour = series_colour::neutral;
    return series;
}

Eigen::VectorXd phaseDegrees (const Eigen::VectorXcd& values)
{
    constexpr double halfTurn = 180;
    return values.array().arg() * (halfTurn / std::numbers::pi);
}

LineChart comparison (const Eigen::VectorXd& frequencies, const Eigen::VectorXd& measured,
                      const Eigen::VectorXd& synthesised, const std::string& label)
{
    LineChart chart;
    chart.yLabel = label;
    chart.series = { { "measured", frequencies, measured, LineStyle::solid, false, false, series_colour::neutral },
                     { "synthesised from the modes", frequencies, synthesised, LineStyle::dashed, false, false, 0 } };
    return chart;
}
} // namespace

LineChart stabilisationChart (const IdentifiedModes& modes, const FrequencyResponses& measured)
{
    LineChart chart;
    chart.xLabel = "frequency (Hz)";
    chart.yLabel = "model order";
    chart.xRange = AxisRange { modes.minimumFrequency, modes.maximumFrequency };
    auto lowest = std::numeric_limits<int>::max(), highest = 0;

    for (const auto& point : modes.stabilisation)
    {
        lowest = std::min (lowest, point.order);
        highest = std::max (highest, point.order);
    }

    if (modes.stabilisation.empty())
        return chart;

    chart.series = { magnitudeBehind (measured, lowest, highest + 1), dots ("alone", modes.stabilisation, false, 1),
                     dots ("of a mode", modes.stabilisation, true, 0) };

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        chart.markers.push_back ({ modes.angularFrequencies[k] / (2 * std::numbers::pi), std::to_string (k + 1) });

    return chart;
}

ChartGrid responseChart (const FrequencyResponses& measured, const FrequencyResponses& synthesised, Eigen::Index point,
                         Eigen::Index reference)
{
    const auto perDrive = measured.drive == DriveQuantity::force ? "(m/s)/N" : "(m/s)/V";
    const Eigen::VectorXcd was = measured.values[static_cast<std::size_t> (reference)].col (point);
    const Eigen::VectorXcd is = synthesised.values[static_cast<std::size_t> (reference)].col (point);
    auto magnitude =
        comparison (measured.frequencies, was.cwiseAbs(), is.cwiseAbs(), std::string ("magnitude (") + perDrive + ")");
    auto phase = comparison (measured.frequencies, phaseDegrees (was), phaseDegrees (is), "phase (degrees)");
    magnitude.logarithmicY = true;
    phase.yRange = AxisRange { -180, 180 };
    phase.legend = LegendPlace::none;
    phase.xLabel = "frequency (Hz)";
    ChartGrid grid;
    grid.columns = 1;
    grid.sharedScale = false;
    grid.panels = { std::move (magnitude), std::move (phase) };
    return grid;
}

HeatMap assuranceChart (const Eigen::MatrixXd& assurance, const std::string& rowLabel, const std::string& columnLabel)
{
    HeatMap chart;
    chart.xLabel = columnLabel;
    chart.yLabel = rowLabel;
    chart.valueLabel = "MAC";
    chart.values = assurance;
    chart.valueRange = AxisRange { 0, 1 };

    for (Eigen::Index row = 0; row < assurance.rows(); ++row)
        chart.rowNames.push_back (std::to_string (row + 1));

    for (Eigen::Index column = 0; column < assurance.cols(); ++column)
        chart.columnNames.push_back (std::to_string (column + 1));

    return chart;
}
} // namespace antinode
