#include "Placing.h"

#include "DescribedCeramic.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** Integral over 0..T of e^{p t}. */
Complex exponentialIntegral (Complex p, double duration)
{
    const auto phase = p * duration;
    return std::abs (phase) < 1e-8 ? Complex (duration) : (std::exp (phase) - 1.0) / p;
}
} // namespace

Eigen::MatrixXd velocityKernel (const Eigen::VectorXd& angularFrequencies, const Eigen::VectorXd& dampingRatios,
                                double duration)
{
    const auto modes = angularFrequencies.size();
    Eigen::VectorXcd poles (modes), amplitudes (modes);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto decay = dampingRatios[k] * angularFrequencies[k];
        const auto damped = angularFrequencies[k] * std::sqrt (1 - dampingRatios[k] * dampingRatios[k]);
        poles[k] = { -decay, damped };
        amplitudes[k] = { 1, decay / damped };
    }

    // h_k = Re [c_k e^{p_k t}], and the product of two real parts is half the real part of both of their products.
    return Eigen::MatrixXd::NullaryExpr (
        modes, modes,
        [&] (Eigen::Index k, Eigen::Index l)
        {
            const auto sum = amplitudes[k] * amplitudes[l] * exponentialIntegral (poles[k] + poles[l], duration);
            const auto difference = amplitudes[k] * std::conj (amplitudes[l])
                                    * exponentialIntegral (poles[k] + std::conj (poles[l]), duration);
            return 0.5 * (sum + difference).real();
        });
}

double worstControllability (const Eigen::MatrixXd& kernel, const Eigen::MatrixXd& participation)
{
    const Eigen::MatrixXd gramian = kernel.cwiseProduct (participation * participation.transpose());
    return symmetricEigenvalues (gramian)[0];
}

namespace
{
/** What a mode's participations and kernel are divided by: then a ceramic in an average place brings 1 / count. */
struct Scaling
{
    Eigen::VectorXd participation, kernel; ///< N_m each
};

Scaling computeScaling (const PlacementCandidates& candidates, const Eigen::MatrixXd& kernel, Eigen::Index count)
{
    Scaling scaling;
    scaling.participation =
        candidates.participation.rowwise().norm() / std::sqrt (static_cast<double> (candidates.participation.cols()));
    scaling.kernel = (kernel.diagonal() * static_cast<double> (count)).cwiseSqrt();
    const auto largest = scaling.participation.maxCoeff();

    for (Eigen::Index k = 0; k < scaling.participation.size(); ++k)
        if (! (scaling.participation[k] > 1e-9 * largest))
            throw InputError ("placement: number of modes",
                              "includes mode " + std::to_string (k + 1)
                                  + ", which ceramics of this size cannot excite at any position; choose fewer "
                                    "modes, smaller ceramics or a smaller step");

    return scaling;
}

Eigen::MatrixXd scaledKernel (const Eigen::VectorXd& angularFrequencies, const Eigen::VectorXd& dampingRatios,
                              double duration, const Scaling& scaling)
{
    const Eigen::VectorXd inverse = scaling.kernel.cwiseInverse();
    return inverse.asDiagonal() * velocityKernel (angularFrequencies, dampingRatios, duration) * inverse.asDiagonal();
}
bool overlaps (const CeramicDescription& ceramic, const KeepOut& zone)
{
    const auto [least, largest] = ceramicExtent (ceramic);
    return least.x() < zone.right && largest.x() > zone.left && least.y() < zone.top && largest.y() > zone.bottom;
}

/** Those candidates that keep out of all zones. */
PlacementCandidates outside (const std::vector<KeepOut>& zones, PlacementCandidates candidates)
{
    std::vector<Eigen::Index> kept;
    std::vector<CeramicDescription> ceramics;

    for (std::size_t i = 0; i < candidates.ceramics.size(); ++i)
        if (std::none_of (zones.begin(), zones.end(),
                          [&] (const auto& zone) { return overlaps (candidates.ceramics[i], zone); }))
        {
            kept.push_back (static_cast<Eigen::Index> (i));
            ceramics.push_back (candidates.ceramics[i]);
        }

    if (candidates.ceramics.empty())
        throw InputError ("placement: edge distance", "leaves no position for a ceramic; allowed: a larger distance");

    if (kept.empty())
        throw InputError ("placement: keep-out zones", "leaves no position for a ceramic; allowed: smaller zones");

    candidates.participation = Eigen::MatrixXd (candidates.participation (Eigen::all, kept));
    candidates.ceramics = std::move (ceramics);
    return candidates;
}
} // namespace

PlacedCeramics placeCeramics (const DeviceDescription& device, const CeramicDescription& like,
                              const PlacingOptions& options, const std::function<void (double)>& progress)
{
    const auto candidates = outside (options.keepOut, placementCandidates (device, like, options.grid));
    const auto kernel = velocityKernel (candidates.angularFrequencies, candidates.dampingRatios, options.duration);
    const auto scaling = computeScaling (candidates, kernel, options.count);
    const Eigen::MatrixXd participation = scaling.participation.cwiseInverse().asDiagonal() * candidates.participation;

    PlacementProblem problem;
    problem.kernel = scaledKernel (candidates.angularFrequencies, candidates.dampingRatios, options.duration, scaling);
    problem.participation = participation;
    problem.count = options.count;
    problem.exclude = [&] (Eigen::Index a, Eigen::Index b) { return candidates.overlap (a, b); };
    const auto begins = options.costOf ? 0.05 : 1.0; // The share of the work that the search is.
    const auto report = [&] (double share)
    {
        if (progress)
            progress (share);
    };
    auto placement = searchPlacement (problem, [&] (double share) { report (begins * share); });

    if (options.better)
        options.better (chosenCeramics (candidates, placement.chosen));

    if (options.costOf)
    {
        placement.chosen =
            exchangeNeighbours (candidates, placement.chosen, options.costOf (candidates), options.better,
                                [&] (double share) { report (begins + (1 - begins) * share); });
        placement.controllability = worstControllability (problem.kernel, participation (Eigen::all, placement.chosen));
    }

    PlacedCeramics placed;
    placed.candidates = participation.cols();
    placed.controllability = placement.controllability;
    placed.exchanges = placement.exchanges;
    placed.perMode =
        participation (Eigen::all, placement.chosen).cwiseAbs2().rowwise().sum() / static_cast<double> (options.count);

    placed.ceramics = chosenCeramics (candidates, placement.chosen);

    if (options.isResolved)
    {
        const auto model = solveStructure (withCeramics (device, placed.ceramics), options.grid.modes);
        placed.resolved = worstControllability (
            scaledKernel (model.angularFrequencies, model.dampingRatios, options.duration, scaling),
            scaling.participation.cwiseInverse().asDiagonal() * model.participation);
    }

    return placed;
}
} // namespace antinode
