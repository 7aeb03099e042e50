#include "ModeSelection.h"

#include <antinode_base/InputError.h>
#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr double maximumDamping = 0.15;

double clusterFrequency (const PoleCluster& cluster)
{
    return std::abs (cluster.pole) / (2 * std::numbers::pi);
}

std::size_t nearest (const std::vector<PoleCluster>& clusters, double frequency)
{
    std::size_t best = 0;

    for (std::size_t k = 1; k < clusters.size(); ++k)
        if (std::abs (clusterFrequency (clusters[k]) - frequency)
            < std::abs (clusterFrequency (clusters[best]) - frequency))
            best = k;

    if (clusters.empty() || std::abs (clusterFrequency (clusters[best]) - frequency) > 0.02 * frequency)
    {
        auto allowed = std::string ("there are no candidates");

        if (! clusters.empty())
            allowed = "the nearest candidate is at " + std::to_string (clusterFrequency (clusters[best])) + " Hz";

        throw InputError ("frequency " + std::to_string (frequency) + " Hz", "has no candidate within 2 %; " + allowed);
    }

    return best;
}

double assurance (const Eigen::VectorXd& one, const Eigen::VectorXd& other)
{
    return std::pow (one.dot (other), 2) / std::max (one.squaredNorm() * other.squaredNorm(), 1e-300);
}

/** Whether two modes are one that was split: poles within half a half width, and one product of shape and
   participation. Two modes of one frequency differ in either. */
bool areTwins (const FitState& state, Eigen::Index k, Eigen::Index l)
{
    const auto& omega = state.basis.angularFrequencies;
    const auto& damping = state.basis.dampingRatios;
    const auto halfWidth = std::min (damping[k] * omega[k], damping[l] * omega[l]);
    return std::hypot (omega[k] - omega[l], damping[k] * omega[k] - damping[l] * omega[l]) < halfWidth / 2
           && assurance (state.shapes.col (k), state.shapes.col (l))
                      * assurance (state.strengths.row (k), state.strengths.row (l))
                  > 0.5;
}
} // namespace

std::vector<PoleCluster> picked (const std::vector<PoleCluster>& clusters, const IdentificationOptions& options)
{
    std::vector<bool> isKept (clusters.size(), options.selected.empty());

    for (const auto frequency : options.selected)
        isKept[nearest (clusters, frequency)] = true;

    for (const auto frequency : options.rejected)
        isKept[nearest (clusters, frequency)] = false;

    std::vector<PoleCluster> result;

    for (std::size_t k = 0; k < clusters.size(); ++k)
        if (isKept[k])
            result.push_back (clusters[k]);

    return result;
}

std::vector<Eigen::Index> standOut (const FitState& state, double variance, double ridge)
{
    const auto ratios = signalToNoise (state, variance, ridge);
    // The strongest direction of pure noise has (sqrt (N_p) + sqrt (N_b))^2 / N_p times its mean energy; the poles were
    // chosen among many.
    const auto points =
        static_cast<double> (std::max<Eigen::Index> (1, (state.shapes.rowwise().squaredNorm().array() > 0).count()));
    const auto references = static_cast<double> (state.references());
    const auto minimum = std::sqrt (1.5 * std::pow (1 + std::sqrt (references / points), 2) + 30 / points);
    // What is damped so heavily is no resonance, but misfit that has taken its form.
    const auto isMisfit = [&state] (Eigen::Index k) { return state.basis.dampingRatios[k] > maximumDamping; };
    std::vector<Eigen::Index> kept;
    bool lastFell = false;

    for (Eigen::Index k = 0; k < state.modes(); ++k)
    {
        // Of two that represent one mode each looks superfluous: only the weaker one is removed.
        const auto isWeaker = k + 1 == state.modes() || ratios[k] <= ratios[k + 1] || ratios[k + 1] >= minimum;
        const auto isSplit = k + 1 < state.modes() && areTwins (state, k, k + 1);
        lastFell = isMisfit (k) || isSplit || (ratios[k] < minimum && isWeaker && ! lastFell);

        if (! lastFell)
            kept.push_back (k);
    }

    std::stable_sort (kept.begin(), kept.end(),
                      [&state] (auto a, auto b)
                      { return state.basis.angularFrequencies[a] < state.basis.angularFrequencies[b]; });
    return kept;
}

NormalModes polesOf (const std::vector<PoleCluster>& clusters, double delay)
{
    const auto count = static_cast<Eigen::Index> (clusters.size());
    NormalModes modes { Eigen::VectorXd (count), Eigen::VectorXd (count), {}, {}, delay };

    for (Eigen::Index k = 0; k < count; ++k)
    {
        const auto pole = clusters[static_cast<std::size_t> (k)].pole;
        modes.angularFrequencies[k] = std::abs (pole);
        modes.dampingRatios[k] = -pole.real() / std::abs (pole);
    }

    return modes;
}

std::vector<PoleCluster> chosen (const std::vector<PoleCluster>& clusters, const std::vector<Eigen::Index>& indices)
{
    std::vector<PoleCluster> result;
    result.reserve (indices.size());

    for (const auto k : indices)
        result.push_back (clusters[static_cast<std::size_t> (k)]);

    return result;
}

NormalModes chosen (const NormalModes& modes, const std::vector<Eigen::Index>& indices)
{
    return { modes.angularFrequencies (indices), modes.dampingRatios (indices), modes.shapes (Eigen::all, indices),
             modes.participation (indices, Eigen::all), modes.delay };
}

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
