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
constexpr double enough = 1e-3; ///< Of log posterior: a step that is worth less is the last one.
constexpr int maximumSteps = 30;

/** Modes after a step; no pole moves further than a half width at a time. */
KnownModes afterStep (KnownModes modes, const Eigen::VectorXd& poles, const Eigen::MatrixXd& strengths)
{
    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto resonance = modes.angularFrequencies[k], before = modes.dampingRatios[k];
        modes.angularFrequencies[k] *= 1 + before * std::clamp (poles[k], -1.0, 1.0);
        modes.dampingRatios[k] =
            std::clamp (before * std::exp (std::clamp (poles[modes.modes() + k], -0.7, 0.7)), 1e-9, 0.9);
        modes.participation.row (k) += resonance * strengths.row (k);
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

/** By what each ceramic's known participations are multiplied, least squares over the modes, each in its own measure.
 */
Eigen::VectorXd scalesOf (const Eigen::MatrixXd& found, const Eigen::MatrixXd& known)
{
    const auto weights = known.rowwise().squaredNorm().cwiseMax (1e-300).cwiseInverse().eval();
    const Eigen::VectorXd between = known.cwiseProduct (found).transpose() * weights,
                          squares = known.cwiseAbs2().transpose() * weights;
    return (squares.array() > 1e-12).select (between.cwiseQuotient (squares.cwiseMax (1e-300)), 1);
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

    /** Goes on until nothing is gained. @return  the equations there */
    KnownModeEquations run (Search& best)
    {
        auto equations = knownModeEquations (best.state, best.modes, prior);
        double damping = 1e-4;

        for (int steps = 0; steps < maximumSteps; ++steps)
        {
            const auto step = solve (equations, damping);

            if (! step || step->gain < enough)
                break;

            auto next = at (afterStep (best.modes, step->poles, step->strengths), best.delay + step->delay);

            if (! (next.cost <= best.cost))
            {
                damping = std::max (damping, 1e-6) * 10;

                if (damping > 1e6)
                    break;

                continue;
            }

            damping /= 10;
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

KnownModeFit fitKnownModes (PreparedResponses& data, const KnownModes& start, const KnownModePrior& prior, double delay)
{
    Searcher searcher (data, prior, delay);
    auto best = searcher.at (start, delay);
    KnownModeFit result;
    searcher.run (best);
    result.participationScales = searcher.learnFromFirst (best);
    const auto deviations = deviationsOf (searcher.run (best));
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
