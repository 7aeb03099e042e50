#include "KnownModeFit.h"

#include "FitErrors.h"
#include "KnownModeEquations.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double enough = 0.05;  ///< Of log posterior: a step that gains less is the last one.
constexpr double roughly = 1e-5; ///< Of the noise's variance: the same where weights and scales are found.
constexpr int maximumSteps = 30;
constexpr double firstReach = 1, farthest = 8, nearest = 1e-3; ///< Half widths that a pole may move in a step.
constexpr double littleGained = 0.25, mostGained = 0.75;       ///< Of what a step was to gain.

KnownModes afterStep (KnownModes modes, const KnownModeStep& step)
{
    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto resonance = modes.angularFrequencies[k], before = modes.dampingRatios[k];
        modes.angularFrequencies[k] *= std::exp (before * step.poles[k]);
        modes.dampingRatios[k] = std::clamp (before * std::exp (step.poles[modes.modes() + k]), 1e-9, 0.9);
        modes.participation.row (k) += resonance * step.strengths.row (k);
    }

    return modes;
}

/** Half the squares of what differs from the prior, in standard deviations. */
double priorCost (const KnownModes& modes, const KnownModePrior& prior)
{
    const auto frequencies =
        (modes.angularFrequencies.array() / prior.angularFrequencies.array()).log() / prior.frequencySpreads.array();
    const auto dampings = (modes.dampingRatios.array() / prior.dampingRatios.array()).log() / prior.dampingSpread;
    const auto participation = (modes.participation - prior.participation).array() / prior.participationSpreads.array();
    return (frequencies.square().sum() + dampings.square().sum() + participation.square().sum()) / 2;
}

/** Where the search for the most probable modes is. */
struct Search
{
    KnownModes modes;
    double delay = 0;
    KnownModeState state;
    double cost = 0; ///< - log posterior.
};

class Searcher
{
public:
    Searcher (PreparedResponses& dataToUse, KnownModePrior priorToUse, double delay)
        : data (dataToUse), prior (std::move (priorToUse)), moments (lineMoments (data, delay))
    {
    }

    Search at (KnownModes modes, double delay)
    {
        checkWatch();

        if (! isNear (moments, delay))
            moments = lineMoments (data, delay);

        auto state = knownModeState (data, moments, modes, delay);
        const auto cost = state.values / 2 * std::log (state.variance) + priorCost (modes, prior);
        return { std::move (modes), delay, std::move (state), cost };
    }

    /** Goes on until a step gains less of log posterior. @return  the equations there */
    KnownModeEquations run (Search& best, double leastGain)
    {
        auto equations = knownModeEquations (best.state, best.modes, prior);
        auto reach = firstReach;

        for (int steps = 0; steps < maximumSteps && reach > nearest; ++steps)
        {
            const auto step = solve (equations, reach);

            if (! (step.gain >= leastGain))
                break;

            auto next = at (afterStep (best.modes, step), best.delay + step.delay);
            const auto share = (best.cost - next.cost) / step.gain;
            reach = share > mostGained ? std::min (2 * reach, farthest) : share > littleGained ? reach : reach / 4;

            if (! (next.cost <= best.cost))
                continue;

            best = std::move (next);
            equations = knownModeEquations (best.state, best.modes, prior);
        }

        return equations;
    }

    /** Weights from what is left; participations are as before, times a factor of each ceramic. @return  the factors */
    Eigen::VectorXd learnFromFirst (Search& best)
    {
        auto scales = scalesOf (best.modes.participation, prior.participation);
        prior.participation *= scales.asDiagonal();
        weighByErrors (data, fitErrors (data, best.state.basis, best.state.coefficients, best.delay));
        moments = lineMoments (data, best.delay);
        best = at (std::move (best.modes), best.delay);
        return scales;
    }

private:
    PreparedResponses& data;
    KnownModePrior prior;
    LineMoments moments;
};
} // namespace

Eigen::VectorXd scalesOf (const Eigen::MatrixXd& found, const Eigen::MatrixXd& known)
{
    const auto weights = known.rowwise().squaredNorm().cwiseMax (1e-300).cwiseInverse().eval();
    const Eigen::VectorXd between = known.cwiseProduct (found).transpose() * weights,
                          squares = known.cwiseAbs2().transpose() * weights;
    return (squares.array() > 1e-12).select (between.cwiseQuotient (squares.cwiseMax (1e-300)), 1);
}

KnownModeFit fitKnownModes (PreparedResponses& data, const KnownModes& start, const KnownModePrior& prior, double delay)
{
    Searcher searcher (data, prior, delay);
    auto best = searcher.at (start, delay);
    KnownModeFit result;
    searcher.run (best, roughly * best.state.values / 2);
    result.participationScales = searcher.learnFromFirst (best);
    const auto deviations = deviationsOf (searcher.run (best, enough));
    const auto modes = best.modes.modes();
    result.frequencyDeviations = deviations.poles.head (modes).cwiseProduct (best.modes.dampingRatios);
    result.dampingDeviations = deviations.poles.segment (modes, modes);
    result.participationDeviations =
        (deviations.strengths.rowwise().norm().array() * best.modes.angularFrequencies.array()
         / best.modes.participation.rowwise().norm().array().max (1e-300))
            .matrix();
    result.pointErrors = best.state.pointErrors;
    result.reconstructionError = best.state.reconstructionError;
    result.delay = best.delay;
    result.modes = std::move (best.modes);
    return result;
}
} // namespace antinode
