#include "IdentificationCharts.h"

#include <antinode_identification/FitDiagram.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

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
    Series series;
    series.name = "mean magnitude (logarithmic, arbitrary scale)";
    series.colour = series_colour::neutral;

    const Eigen::ArrayXd magnitude = meanMagnitude (responses);
    const Eigen::ArrayXd decades = (magnitude / magnitude.maxCoeff()).max (1e-12).log10();
    series.x = responses.frequencies;
    series.y = lowest + (highest - lowest) * (decades - decades.minCoeff()) / std::max (-decades.minCoeff(), 1e-12);
    return series;
}

/** Degrees over frequency without the delay; a gap stands at each leap from one end of the scale to the other, so that
   no line crosses it, and where the values are less than hidden. */
Series phaseCurve (const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& values, double delay,
                   const Eigen::VectorXd& hidden)
{
    constexpr double halfTurn = 180;
    std::vector<double> x, y;

    for (Eigen::Index n = 0; n < values.size(); ++n)
    {
        const auto turned = values[n] * std::polar (1.0, 2 * std::numbers::pi * frequencies[n] * delay);
        const auto degrees = std::abs (turned) > hidden[n] ? std::arg (turned) * halfTurn / std::numbers::pi : nothing;

        if (! y.empty() && std::abs (degrees - y.back()) > halfTurn)
        {
            x.push_back (frequencies[n]);
            y.push_back (nothing);
        }

        x.push_back (frequencies[n]);
        y.push_back (degrees);
    }

    Series series;
    series.x = Eigen::Map<const Eigen::VectorXd> (x.data(), static_cast<Eigen::Index> (x.size()));
    series.y = Eigen::Map<const Eigen::VectorXd> (y.data(), static_cast<Eigen::Index> (y.size()));
    return series;
}

/** Magnitudes over frequency. */
Series magnitudeCurve (const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& values)
{
    Series series;
    series.x = frequencies;
    series.y = values.cwiseAbs();
    return series;
}

LineChart comparison (Series measured, Series synthesised, const std::string& label)
{
    measured.name = "measured";
    measured.colour = series_colour::neutral;
    synthesised.name = "synthesised from the modes";
    synthesised.style = LineStyle::dashed;
    synthesised.colour = 0;
    LineChart chart;
    chart.yLabel = label;
    chart.series = { std::move (measured), std::move (synthesised) };
    return chart;
}
} // namespace

LineChart stabilisationChart (const IdentifiedModes& modes, const FrequencyResponses& measured)
{
    LineChart chart;
    chart.xLabel = "frequency (Hz)";
    chart.yLabel = "model order";
    chart.xRange = AxisRange { measured.frequencies[0], measured.frequencies[measured.frequencies.size() - 1] };
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
                         Eigen::Index reference, double delay)
{
    const auto perDrive = measured.drive == DriveQuantity::force ? "(m/s)/N" : "(m/s)/V";
    const auto& frequencies = measured.frequencies;
    const Eigen::VectorXcd was = measured.values[static_cast<std::size_t> (reference)].col (point);
    const Eigen::VectorXcd is = synthesised.values[static_cast<std::size_t> (reference)].col (point);
    auto magnitude = comparison (magnitudeCurve (frequencies, was), magnitudeCurve (frequencies, is),
                                 std::string ("magnitude (") + perDrive + ")");
    auto phase = comparison (phaseCurve (frequencies, was, delay, 2 * localNoise (was)),
                             phaseCurve (frequencies, is, delay, Eigen::VectorXd::Zero (is.size())), "phase (degrees)");
    magnitude.logarithmicY = true;
    phase.yRange = AxisRange { -180, 180 };
    phase.xRange = AxisRange { frequencies[0], frequencies[frequencies.size() - 1] };
    magnitude.xRange = phase.xRange;
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
