#include "FingerFilters.h"

#include "FilterProblem.h"
#include "RateChange.h"

#include "PointDistances.h"
#include "TrackClimb.h"
#include "TrackWork.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr double filterTolerance = 1e-3; // of the wanted motion: -60 dB
} // namespace

double FingerFilters::latency() const
{
    return static_cast<double> (delay + 2 * rateChangeReach) / rate();
}

FingerFilters designFingerFilters (const ModalModel& model, const WaveformsDescription& description,
                                   const FilterSettings& settings, const ShowProgress& progress)
{
    requireFixedPoints (description);
    const auto shapes = touchedShapes (model, description);
    requireEnoughCeramics (model, description);
    const auto span = filterSpan (description.band, settings);
    requireDistinctPoints (model, description);
    auto responses = pointResponses (model, shapes, touchedLoads (model, description), span.rate, span.length);
    const auto compliance =
        settings.regularisation * settings.regularisation * smallestResponse (responses, {}, description.band);
    weighLines (responses, description.band);
    WindowedResponses windowed (std::move (responses), span.taps, compliance);
    const auto impulse = weighedImpulse (span, description.band);
    const Eigen::MatrixXd free = Eigen::MatrixXd::Ones (span.taps, model.actuators());
    FingerFilters filters { settings.sampleRate, span.factor, span.delay, {}, 0, 0 };

    for (std::size_t j = 0; j < description.tracks.size(); ++j)
    {
        if (progress)
            progress ("Filters of each finger",
                      static_cast<double> (j) / static_cast<double> (description.tracks.size()));

        Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero (span.length, shapes.rows());
        wanted.col (static_cast<Eigen::Index> (j)) = impulse;
        auto found = solveByGradients (windowed, free, wanted, filterTolerance * impulse.norm());
        filters.iterations += found.iterations;
        filters.error = std::max (filters.error, filterError (found, windowed.compliance(), impulse));
        filters.taps.push_back (std::move (found.pulls));
    }

    return filters;
}
} // namespace antinode
