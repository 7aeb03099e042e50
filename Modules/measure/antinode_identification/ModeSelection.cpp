#include "ModeSelection.h"

#include "ModeAssessment.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
} // namespace antinode
