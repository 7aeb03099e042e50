#include "QuickFilterDesigner.h"

#include "PointDistances.h"
#include "TrackWork.h"
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr double leastMix = 1e-2;                               // of the motion that the strongest mix makes
constexpr int fewestSteps = 4, mostSteps = 12, stepsOfAll = 30; // of one track, and of all together

/** The orthonormal mixes of ceramics that move the surface most in the band: eigenvectors of what all modes take from
    them, each mode at its largest response there. */
Eigen::MatrixXd ceramicMixes (const ModalModel& model, TrackBand band)
{
    const auto highest = 2 * std::numbers::pi * highestWeighed (band);
    Eigen::MatrixXd moved = model.participation;

    for (Eigen::Index k = 0; k < moved.rows(); ++k)
    {
        const auto own = model.angularFrequencies[k], nearest = std::min (own, highest);
        moved.row (k) /= std::hypot (own * own - nearest * nearest, 2 * model.dampingRatios[k] * own * nearest);
    }

    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (moved.cols(), moved.cols());
    addGram (gram, 1, moved.transpose());
    const auto eigen = symmetricEigen (gram);
    const auto least = leastMix * leastMix * eigen.values[eigen.values.size() - 1];
    return eigen.vectors.rightCols ((eigen.values.array() > least).count());
}

/** Every eighth line: enough for a median over the band. */
PointResponses thinned (const PointResponses& responses)
{
    constexpr Eigen::Index step = 8;
    return { responses.points, responses.actuators, responses.length / step, responses.sampleRate,
             responses.values (Eigen::seq (0, responses.length / 2, step), Eigen::all) };
}

int stepsFor (std::size_t tracks)
{
    return std::clamp (stepsOfAll / std::max (1, static_cast<int> (tracks)), fewestSteps, mostSteps);
}
} // namespace

QuickFilterDesigner::QuickFilterDesigner (std::shared_ptr<const ModalModel> modelToUse, TrackBand bandToUse,
                                          const FilterSettings& settingsToUse)
    : model (std::move (modelToUse)), band (bandToUse), settings (settingsToUse), span (filterSpan (band, settings)),
      mixes (ceramicMixes (*model, band)),
      table (*model, model->participation * mixes, span.rate, span.length, highestWeighed (band)),
      impulse (weighedImpulse (span, band))
{
}

FingerFilters QuickFilterDesigner::design (const WaveformsDescription& description, double tolerance) const
{
    requireFixedPoints (description);
    const auto shapes = touchedShapes (*model, description);
    requireEnoughCeramics (*model, description);
    auto responses = table.responses (shapes, touchedLoads (*model, description));
    const auto compliance =
        settings.regularisation * settings.regularisation * smallestResponse (thinned (responses), {}, band);
    weighLines (responses, band);
    WindowedResponses windowed (std::move (responses), span.taps, compliance, {}, 1);
    const Eigen::MatrixXd free = Eigen::MatrixXd::Ones (span.taps, mixes.cols());
    FingerFilters filters { settings.sampleRate, span.factor, span.delay, {}, 0, 0 };

    for (std::size_t j = 0; j < description.tracks.size(); ++j)
    {
        Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero (span.length, shapes.rows());
        wanted.col (static_cast<Eigen::Index> (j)) = impulse;
        const auto found =
            solveByGradients (windowed, free, wanted, tolerance * impulse.norm(), stepsFor (description.tracks.size()));
        filters.iterations += found.iterations;
        filters.error = std::max (filters.error, filterError (found, compliance, impulse));
        filters.taps.push_back (found.pulls * mixes.transpose());
    }

    return filters;
}
} // namespace antinode
