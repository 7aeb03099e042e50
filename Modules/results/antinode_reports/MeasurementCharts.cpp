#include "MeasurementCharts.h"

#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace antinode
{
namespace
{
constexpr std::size_t maximumCurves = 6;

/** Rows' means of what is known. */
Eigen::VectorXd meansOfKnown (const Eigen::ArrayXXd& values)
{
    const auto known = values.isFinite();
    const Eigen::ArrayXd sums = known.select (values, 0.0).rowwise().sum();
    return sums / known.cast<double>().rowwise().sum();
}

Eigen::VectorXd effectiveVelocity (const SurfaceMeasurement& measurement, std::size_t ceramic)
{
    return meansOfKnown (measurement.responses.values[ceramic].cwiseAbs2().array()).cwiseSqrt() * milli;
}

/** The ceramics that are shown, the strongest first; in the order of the ceramics where all are. */
std::vector<std::size_t> shownCeramics (const SurfaceMeasurement& measurement)
{
    std::vector<std::size_t> ceramics (measurement.responses.values.size());
    std::vector<double> strengths (ceramics.size());
    std::iota (ceramics.begin(), ceramics.end(), 0);
    std::transform (ceramics.begin(), ceramics.end(), strengths.begin(),
                    [&] (auto ceramic) { return effectiveVelocity (measurement, ceramic).norm(); });

    if (ceramics.size() > maximumCurves)
        std::stable_sort (ceramics.begin(), ceramics.end(),
                          [&] (auto one, auto other) { return strengths[one] > strengths[other]; });

    ceramics.resize (std::min (maximumCurves, ceramics.size()));
    return ceramics;
}

template <typename Values>
LineChart curves (const SurfaceMeasurement& measurement, const Values& values)
{
    LineChart chart;
    chart.xLabel = "frequency (Hz)";
    chart.logarithmicX = true;

    for (const auto ceramic : shownCeramics (measurement))
    {
        Series series;
        series.name = measurement.responses.references[ceramic].name;
        series.x = measurement.responses.frequencies;
        series.y = values (ceramic);
        chart.series.push_back (std::move (series));
    }

    return chart;
}
} // namespace

LineChart responseChart (const SurfaceMeasurement& measurement)
{
    auto chart = curves (measurement, [&] (auto ceramic) { return effectiveVelocity (measurement, ceramic); });
    chart.yLabel =
        measurement.responses.drive == DriveQuantity::force ? "RMS velocity (mm/s per N)" : "RMS velocity (mm/s per V)";
    chart.logarithmicY = true;
    return chart;
}

LineChart coherenceChart (const SurfaceMeasurement& measurement)
{
    auto chart =
        curves (measurement, [&] (auto ceramic) { return meansOfKnown (measurement.coherence[ceramic].array()); });
    chart.yLabel = "coherence";
    chart.yRange = AxisRange { 0, 1 };
    return chart;
}

HeatMap signalToNoiseChart (const SurfaceMeasurement& measurement)
{
    HeatMap chart;
    const auto coherence = meanCoherence (measurement);
    chart.xLabel = "point";
    chart.yLabel = measurement.responses.drive == DriveQuantity::force ? "hit point" : "ceramic";
    chart.valueLabel = "signal to noise (dB)";
    constexpr double best = 1 - 1e-12;
    const Eigen::ArrayXXd known = coherence.transpose().array().min (best).max (1e-12);
    chart.values = coherence.transpose().array().isFinite().select (10 * (known / (1 - known)).log10(),
                                                                    coherence.transpose().array());

    constexpr double usual = 40; // dB: less of a range would make a picture of differences that do not matter
    const auto largest = chart.values.array().isFinite().select (chart.values.array(), 0.0).maxCoeff();
    chart.valueRange = AxisRange { 0, std::max (usual, largest) };

    for (Eigen::Index p = 0; p < coherence.rows(); ++p)
        chart.columnNames.push_back (std::to_string (p + 1));

    for (const auto& reference : measurement.responses.references)
        chart.rowNames.push_back (reference.name);

    return chart;
}

LineChart forceChart (const Eigen::VectorXd& magnitude, double spacing, const Eigen::VectorXd& usedFrequencies)
{
    constexpr double lowest = 1e-4;          // of the largest line
    const auto lines = magnitude.size() - 1; // Without the first: a logarithmic axis has no 0.
    LineChart chart;
    chart.xLabel = "frequency (Hz)";
    chart.yLabel = "force (dB of the largest)";
    chart.logarithmicX = true;
    chart.series = { { {},
                       spacing * Eigen::VectorXd::LinSpaced (lines, 1, static_cast<double> (lines)),
                       20 * (magnitude.tail (lines) / magnitude.maxCoeff()).array().max (lowest).log10() } };
    chart.yRange = AxisRange { 20 * std::log10 (lowest), 0 };
    chart.spans = { { usedFrequencies[0], usedFrequencies[usedFrequencies.size() - 1], "used" } };
    return chart;
}
} // namespace antinode
