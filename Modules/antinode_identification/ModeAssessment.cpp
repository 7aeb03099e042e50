#include "ModeAssessment.h"

#include <antinode_numerics/ComplexKernels.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
std::string percent (double share)
{
    if (! std::isfinite (share))
        return "an unknown fraction";

    return std::to_string (static_cast<int> (std::lround (100 * share))) + " %";
}

/** Modal phase collinearity of a complex vector: 1 where all values lie on one line through 0. */
double collinearity (const Eigen::VectorXcd& vector)
{
    const auto real = vector.real().squaredNorm(), imaginary = vector.imag().squaredNorm();
    const auto between = vector.real().dot (vector.imag());
    const auto sum = real + imaginary;
    return sum > 0 ? (std::pow (real - imaginary, 2) + 4 * between * between) / (sum * sum) : 1;
}

void warnOfMode (IdentifiedModes& modes, Eigen::Index k)
{
    auto& quality = modes.quality[static_cast<std::size_t> (k)];
    auto& warnings = quality.warnings;
    const auto halfWidth = modes.dampingRatios[k] * modes.angularFrequencies[k];

    if (quality.presence < 0.6)
        warnings.push_back ("it was found at only " + percent (quality.presence) + " of the model orders");

    if (quality.signalToNoise < 4)
        warnings.emplace_back ("it is close to the noise level");

    if (quality.collinearity < 0.9)
        warnings.push_back ("its points do not move in phase (MPC " + percent (quality.collinearity)
                            + "): damping is not proportional, or the responses are inconsistent");

    if (quality.rankOne < 0.9 && quality.signalToNoise > 4)
        warnings.push_back ("one shape explains only " + percent (quality.rankOne)
                            + " of its residues: it may be two modes, or references measured differently");

    if (modes.deviations.dampingRatios[k] > 0.1 * modes.dampingRatios[k])
        warnings.push_back ("its damping is uncertain by "
                            + percent (modes.deviations.dampingRatios[k] / modes.dampingRatios[k]));

    for (const auto other : { k - 1, k + 1 })
        if (other >= 0 && other < modes.modes()
            && std::abs (modes.angularFrequencies[other] - modes.angularFrequencies[k]) < halfWidth / 4)
            warnings.push_back ("mode " + std::to_string (other + 1)
                                + " is within a quarter of its half-power half width");
}

/** Points of one half wave of the most rippled shape on a line, or of the wave that as many modes have in the plane. */
double pointsPerHalfWave (const IdentifiedModes& modes)
{
    const auto spreadX = modes.points.col (0).maxCoeff() - modes.points.col (0).minCoeff();
    const auto spreadY = modes.points.col (1).maxCoeff() - modes.points.col (1).minCoeff();
    const auto halfWaves = spreadX > 0 && spreadY > 0 ? std::sqrt (static_cast<double> (modes.modes()))
                                                      : static_cast<double> (modes.modes());
    const auto points = static_cast<double> (modes.points.rows());
    return (spreadX > 0 && spreadY > 0 ? std::sqrt (points) : points) / halfWaves;
}
} // namespace

Eigen::VectorXd signalToNoise (const FitState& state, double variance, double ridge)
{
    Eigen::VectorXd energies = Eigen::VectorXd::Zero (state.modes());
    double points = 0;

    for (const auto& group : state.groups)
    {
        const Eigen::MatrixXd shapes = state.shapes (group.points, Eigen::all);
        const auto inverse = shapeCoupling (state, group, ridge).inverseDiagonal;
        energies += (shapes.cwiseAbs2().transpose() * group.pointWeights).cwiseQuotient (inverse);
        points += static_cast<double> (group.points.size());
    }

    return (energies * (2 / std::max (variance, 1e-300) / points)).cwiseMax (0).cwiseSqrt();
}

std::vector<ModeQuality> assessResidues (const Eigen::MatrixXcd& residues, const PreparedResponses& data)
{
    std::vector<ModeQuality> result;

    for (Eigen::Index k = 0; k < residues.rows(); ++k)
    {
        const Eigen::RowVectorXcd weighted = residues.row (k).cwiseProduct (data.columnWeights.cwiseSqrt().transpose());
        const Eigen::MatrixXcd table = weighted.reshaped (data.points(), data.references());
        const auto [strength, direction] = largestEigenpair (adjointGram (table));
        ModeQuality quality;
        quality.rankOne = strength / std::max (table.squaredNorm(), 1e-300);
        quality.collinearity = collinearity (table * direction);
        result.push_back (quality);
    }

    return result;
}

void addWarnings (IdentifiedModes& modes)
{
    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        warnOfMode (modes, k);

    if (modes.points.rows() > 1 && pointsPerHalfWave (modes) < 2.5)
        modes.warnings.emplace_back (
            "there may be less than 2.5 points per half wave of the highest modes: points on nodal lines hide modes");

    if (modes.references.size() == 1 && modes.points.rows() > 1)
        modes.warnings.emplace_back ("a single reference misses modes that it cannot excite");

    const auto error = std::min (modes.reconstructionError, modes.measuredReconstructionError);

    if (error > -20)
        modes.warnings.push_back ("the reconstruction error of the responses is "
                                  + std::to_string (static_cast<int> (std::lround (error)))
                                  + " dB; a good fit reaches -20 dB or less");
}
} // namespace antinode
