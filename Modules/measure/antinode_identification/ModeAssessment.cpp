#include "ModeAssessment.h"

#include <antinode_model/ModalModel.h>
#include <antinode_numerics/ComplexKernels.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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

/** A sum over so many numbers of noise exceeds its mean by this share once in a thousand. */
double noiseMargin (double numbers)
{
    return 3 * std::sqrt (2 / std::max (numbers, 1.0));
}

/** Modal phase collinearity of a complex vector without what noise of that covariance adds to each of some values: 1
   where all lie on one line through 0. */
double collinearity (const Eigen::VectorXcd& vector, const Eigen::Matrix2d& noise, double values)
{
    Eigen::MatrixX2d parts (vector.size(), 2);
    parts << vector.real(), vector.imag();
    const Eigen::Matrix2d scatter = parts.transpose() * parts - values * (1 + noiseMargin (values)) * noise;
    const auto sum = scatter.trace();
    const auto difference = std::hypot (scatter (0, 0) - scatter (1, 1), 2 * scatter (0, 1));
    return sum > difference ? std::pow (difference / sum, 2) : 1;
}

/** Share of a table's energy above its noise that is of its strongest product.
    @param noise    E |error|^2 of one value  @param active, values  rows and columns, and values, that were measured */
double rankOne (double strongest, double all, double noise, double active, double values)
{
    const auto others = std::max (values - active + 1, 0.0);
    const auto left = std::max (0.0, all - strongest - noise * others * (1 + noiseMargin (others)));
    const auto strength = std::max (strongest - noise * (active - 1), 1e-300);
    return strength / (strength + left);
}

template <typename A, typename B>
double likeness (const A& one, const B& other)
{
    return std::pow (one.dot (other), 2) / std::max (one.squaredNorm() * other.squaredNorm(), 1e-300);
}

/** Of numbers of which some are NaN. */
double length (const Eigen::VectorXd& values)
{
    return values.array().isFinite().select (values, 0).norm();
}

/** What of a mode is known worst, and how badly, relative. */
std::pair<std::string, double> leastCertain (const IdentifiedModes& modes, Eigen::Index k)
{
    const auto& deviations = modes.deviations;
    std::pair<std::string, double> worst { "damping", deviations.dampingRatios[k] / modes.dampingRatios[k] };
    const auto consider = [&worst] (const char* name, double share)
    {
        if (share > worst.second)
            worst = { name, share };
    };
    consider ("participation", deviations.participation.row (k).norm() / modes.participation.row (k).norm());
    consider ("shape", length (deviations.shapes.col (k)) / length (modes.shapes.col (k)));
    consider ("frequency, in half widths,",
              deviations.angularFrequencies[k] / (modes.dampingRatios[k] * modes.angularFrequencies[k]));
    return worst;
}

/** Two modes that are near each other and differ in their shapes alone, or in their participations alone. Where modes
   are two, both differ. */
void warnOfNeighbour (IdentifiedModes& modes, Eigen::Index k, Eigen::Index other)
{
    constexpr double alike = 0.9;
    constexpr Eigen::Index fewest = 3; // numbers of which two vectors are hardly alike by chance
    const auto& omega = modes.angularFrequencies;
    const auto reach = modes.dampingRatios[k] * omega[k] + modes.dampingRatios[other] * omega[other];

    if (std::abs (omega[other] - omega[k]) > reach)
        return;

    const Eigen::MatrixXd shapes = modes.shapes.array().isFinite().select (modes.shapes, 0);
    auto& warnings = modes.quality[static_cast<std::size_t> (k)].warnings;
    const auto name = "mode " + std::to_string (other + 1) + ", within its half-power band, has the same ";

    if (modes.participation.cols() >= fewest
        && likeness (modes.participation.row (k), modes.participation.row (other)) > alike)
        warnings.push_back (name + "participation: both may be one mode that differs from point to point");
    else if (shapes.rows() >= fewest && likeness (shapes.col (k), shapes.col (other)) > alike)
        warnings.push_back (name + "shape: both may be one mode that differs from driver to driver");
}

void warnOfMode (IdentifiedModes& modes, Eigen::Index k)
{
    constexpr double uncertain = 0.1, often = 0.6;
    auto& quality = modes.quality[static_cast<std::size_t> (k)];
    auto& warnings = quality.warnings;
    const auto [worst, share] = leastCertain (modes, k);

    // What is known well is there, however few orders show it.
    if (quality.presence < often && ! (share <= uncertain))
        warnings.push_back ("it was found at only " + percent (quality.presence) + " of the model orders");

    if (quality.collinearity < 0.9)
        warnings.push_back ("its points do not move in phase (MPC " + percent (quality.collinearity)
                            + "): damping is not proportional, or the responses are inconsistent");

    if (quality.rankOne < 0.9)
        warnings.push_back ("one shape explains only " + percent (quality.rankOne)
                            + " of its residues: it may be two modes, or references measured differently");

    if (! (share <= uncertain))
        warnings.push_back ("its " + worst + " is uncertain by " + percent (share));

    for (const auto other : { k - 1, k + 1 })
        if (other >= 0 && other < modes.modes())
            warnOfNeighbour (modes, k, other);
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

std::vector<Eigen::Matrix2d> residueCovariances (const FreeResidues& fit, double variance, double ridge)
{
    const auto& basis = fit.basis;
    const auto modes = basis.modes();
    std::vector<Eigen::Index> columns;

    for (const auto function : { ModalFunction::velocity, ModalFunction::delay })
        for (Eigen::Index k = 0; k < modes; ++k)
            columns.push_back (basis.column (k, function));

    const auto reduced = withoutPowers (basis, fit.products);
    const auto inverse = solveEven (reduced.gram (columns, columns), Eigen::MatrixXd::Identity (2 * modes, 2 * modes),
                                    std::max (ridge, 1e-14));
    std::vector<Eigen::Matrix2d> result;

    // As complexResidues makes residues of the coefficients of both functions.
    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto resonance = basis.angularFrequencies[k], damping = basis.dampingRatios[k];
        Eigen::Matrix2d toResidue, ofCoefficients;
        toResidue << resonance, damping * resonance, 0, -resonance * std::sqrt (1 - damping * damping);
        ofCoefficients << inverse (k, k), inverse (k, modes + k), inverse (modes + k, k),
            inverse (modes + k, modes + k);
        result.emplace_back (variance / 2 * toResidue * ofCoefficients * toResidue.transpose());
    }

    return result;
}

std::vector<ModeQuality> assessResidues (const FreeResidues& fit, const PreparedResponses& data, double variance,
                                         double ridge)
{
    const auto covariances = residueCovariances (fit, variance, ridge);
    const Eigen::MatrixXd isActive =
        (data.columnWeights.array() > 0).cast<double>().reshaped (data.points(), data.references());
    const auto points = isActive.rowwise().maxCoeff().sum(), references = isActive.colwise().maxCoeff().sum();
    std::vector<ModeQuality> result;

    for (Eigen::Index k = 0; k < fit.residues.rows(); ++k)
    {
        const auto& noise = covariances[static_cast<std::size_t> (k)];
        const Eigen::RowVectorXcd weighted =
            fit.residues.row (k).cwiseProduct (data.columnWeights.cwiseSqrt().transpose());
        const Eigen::MatrixXcd table = weighted.reshaped (data.points(), data.references());
        auto [strength, direction] = largestEigenpair (adjointGram (table));
        // As real as can be, so that the noise keeps its phases.
        direction *= std::polar (1.0, -std::arg (direction.array().square().sum()) / 2);
        ModeQuality quality;
        quality.rankOne = rankOne (strength, table.squaredNorm(), noise.trace(), points + references, isActive.sum());
        quality.collinearity = collinearity (table * direction, noise, points);
        result.push_back (quality);
    }

    return result;
}

void addWarnings (IdentifiedModes& modes)
{
    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        warnOfMode (modes, k);

    if (modes.points.rows() > 1 && pointsPerHalfWave (modes.points, modes.modes()) < enoughPointsPerHalfWave)
        modes.warnings.emplace_back (
            "there may be fewer than 2.5 points per half wave of the highest modes: points on nodal lines hide modes");

    if (modes.references.size() == 1 && modes.points.rows() > 1)
        modes.warnings.emplace_back ("a single reference misses modes that it cannot excite");

    const auto error = std::min (modes.reconstructionError, modes.measuredReconstructionError);

    if (error > -20)
        modes.warnings.push_back ("the reconstruction error of the responses is "
                                  + std::to_string (static_cast<int> (std::lround (error)))
                                  + " dB; a good fit reaches -20 dB or less");
}
} // namespace antinode
