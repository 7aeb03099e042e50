#include "SurfaceMeasurement.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace antinode
{
namespace
{
constexpr double minimumCoherence = 0.9;
constexpr double maximumDistortion = 0.02;
constexpr double maximumWander = 0.1; // samples
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::string numbers (const std::vector<Eigen::Index>& places)
{
    constexpr std::size_t maximum = 12;
    std::string text;

    for (std::size_t i = 0; i < std::min (maximum, places.size()); ++i)
        text += (i == 0 ? "" : ", ") + std::to_string (places[i] + 1);

    return text + (places.size() > maximum ? " and " + std::to_string (places.size() - maximum) + " more" : "");
}

/** Which entries of a list are less than what is allowed; those that are not known are not. */
std::vector<Eigen::Index> weakOnes (const Eigen::VectorXd& values)
{
    std::vector<Eigen::Index> weak;

    for (Eigen::Index i = 0; i < values.size(); ++i)
        if (values[i] < minimumCoherence)
            weak.push_back (i);

    return weak;
}

void warnOfCoherence (std::vector<std::string>& warnings, const SurfaceMeasurement& measurement)
{
    const auto coherence = meanCoherence (measurement);

    if (const auto points = weakOnes (coherence.rowwise().maxCoeff()); ! points.empty())
        warnings.push_back (
            "The response of these points is too close to the noise for all ceramics; measure them again "
            "or leave them out: "
            + numbers (points) + ".");

    if (const auto ceramics = weakOnes (coherence.colwise().maxCoeff()); ! ceramics.empty())
        warnings.push_back (
            "The response of all points is too close to the noise for these ceramics; check their wires and levels: "
            + numbers (ceramics) + ".");
}

void warnOfLatency (std::vector<std::string>& warnings, const SurfaceMeasurement& measurement)
{
    for (Eigen::Index p = 0; p < measurement.latencies.cols(); ++p)
    {
        const auto latencies = measurement.latencies.col (p);

        if (latencies.maxCoeff() - latencies.minCoeff() > maximumWander)
        {
            warnings.push_back (formatted (
                "At point %td the latency varied from %.2f to %.2f samples: outputs and inputs do not share one clock, "
                "or samples were lost.",
                p + 1, latencies.minCoeff(), latencies.maxCoeff()));
            return;
        }
    }
}

void warnOfLinearity (std::vector<std::string>& warnings, const SurfaceMeasurement& measurement)
{
    double largest = 0;

    for (const auto& ceramic : measurement.distortion)
        for (const auto& distortion : ceramic)
        {
            largest = std::max ({ largest, distortion.even, distortion.odd });

            for (const auto harmonic : distortion.harmonics)
                largest = std::max (largest, harmonic);
        }

    if (largest > maximumDistortion)
        warnings.push_back (formatted (
            "Up to %.1f %% of the motion is distortion: identified modes depend on the level; choose a lower level.",
            100 * largest));
}
} // namespace

SurfaceMeasurement unmeasured (const Excitation& excitation, const std::vector<std::string>& ceramics,
                               const Eigen::MatrixX2d& points)
{
    SurfaceMeasurement measurement;
    auto& responses = measurement.responses;
    responses.frequencies = measuredFrequencies (excitation);
    responses.points = points;
    const auto lines = responses.frequencies.size();
    const Eigen::MatrixXd nothing = Eigen::MatrixXd::Constant (lines, points.rows(), missing);

    for (const auto& name : ceramics)
        responses.references.push_back ({ name, {} });

    responses.values.assign (ceramics.size(), nothing.cast<std::complex<double>>());
    responses.variances.assign (ceramics.size(), nothing);
    measurement.coherence.assign (ceramics.size(), nothing);
    measurement.distortion.assign (ceramics.size(),
                                   std::vector<NonlinearDistortion> (static_cast<std::size_t> (points.rows())));
    measurement.latencies =
        Eigen::MatrixXd::Constant (static_cast<Eigen::Index> (ceramics.size()), points.rows(), missing);
    return measurement;
}

void place (SurfaceMeasurement& measurement, Eigen::Index ceramic, Eigen::Index firstPoint, const RunResponses& run)
{
    const auto i = static_cast<std::size_t> (ceramic);
    const auto& estimated = run.responses;
    const auto sensors = estimated.values.cols();
    measurement.responses.values[i].middleCols (firstPoint, sensors) = estimated.values;
    measurement.latencies.row (ceramic).segment (firstPoint, sensors).setConstant (run.latency);

    if (estimated.variances.size() > 0)
    {
        measurement.responses.variances[i].middleCols (firstPoint, sensors) = estimated.variances;
        measurement.coherence[i].middleCols (firstPoint, sensors) = estimated.coherence;
    }

    std::copy (estimated.distortion.begin(), estimated.distortion.end(),
               measurement.distortion[i].begin() + firstPoint);
}

Eigen::MatrixXd meanCoherence (const SurfaceMeasurement& measurement)
{
    const auto points = measurement.responses.points.rows();
    Eigen::MatrixXd means (points, static_cast<Eigen::Index> (measurement.coherence.size()));

    for (Eigen::Index i = 0; i < means.cols(); ++i)
    {
        const auto& coherence = measurement.coherence[static_cast<std::size_t> (i)];
        const Eigen::ArrayXXd power = measurement.responses.values[static_cast<std::size_t> (i)].cwiseAbs2();
        means.col (i) = ((power * coherence.array()).colwise().sum() / power.colwise().sum().max (1e-300)).transpose();
    }

    return means;
}

std::vector<std::string> collectWarnings (const SurfaceMeasurement& measurement)
{
    std::vector<std::string> warnings;
    warnOfCoherence (warnings, measurement);
    warnOfLatency (warnings, measurement);
    warnOfLinearity (warnings, measurement);
    return warnings;
}
} // namespace antinode
