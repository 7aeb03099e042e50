#include "FingerFilters.h"

#include "FilterDesign.h"
#include "PointResponses.h"
#include "TrackSolver.h"
#include "TrackWork.h"

#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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

FilterBank silentBank (Eigen::Index ceramics, Eigen::Index inputs, FilterTiming timing)
{
    return { inputs, timing.taps, timing.factor, Eigen::MatrixXf::Zero (ceramics, inputs * timing.taps),
             std::vector<bool> (static_cast<std::size_t> (inputs), false) };
}

FilterBank filterBank (const FingerFilters& filters, const std::vector<Eigen::Index>& inputOfTrack, Eigen::Index inputs)
{
    const auto& first = filters.taps.front();
    auto bank = silentBank (first.cols(), inputs, { filters.factor, filters.delay, first.rows() });

    for (std::size_t j = 0; j < inputOfTrack.size(); ++j)
    {
        bank.values.middleCols (inputOfTrack[j] * bank.taps, bank.taps) =
            filters.taps[j].colwise().reverse().transpose().cast<float>();
        bank.moves[static_cast<std::size_t> (inputOfTrack[j])] = true;
    }

    return bank;
}

FilterBank filterBank (const FingerFilters& filters)
{
    std::vector<Eigen::Index> inputs (filters.taps.size());
    std::iota (inputs.begin(), inputs.end(), Eigen::Index { 0 });
    return filterBank (filters, inputs, static_cast<Eigen::Index> (inputs.size()));
}

namespace
{
/** The root of the mean square of a filter's response over a band. */
double bandGain (FourierTables& tables, const Eigen::VectorXd& taps, double rate, TrackBand band)
{
    const auto length = quickLength (2 * static_cast<double> (taps.size()));
    const auto perLine = rate / static_cast<double> (length);
    const auto first = static_cast<Eigen::Index> (std::ceil (band.lower / perLine));
    const auto count = static_cast<Eigen::Index> (std::floor (band.upper / perLine)) - first + 1;
    const auto lines = tables.forward (taps, length);
    return std::sqrt (lines.segment (first, count).squaredNorm() / static_cast<double> (count));
}
} // namespace

Eigen::MatrixXd noiseGains (const FingerFilters& filters, TrackBand band)
{
    Eigen::MatrixXd gains (filters.taps.front().cols(), static_cast<Eigen::Index> (filters.taps.size()));
    FourierTables tables;

    for (Eigen::Index j = 0; j < gains.cols(); ++j)
        for (Eigen::Index i = 0; i < gains.rows(); ++i)
            gains (i, j) = bandGain (tables, filters.taps[static_cast<std::size_t> (j)].col (i), filters.rate(), band);

    return gains;
}

Eigen::VectorXf rateChangeTaps (Eigen::Index factor)
{
    constexpr double shape = 7; // Kaiser's beta: -70 dB
    const auto reach = rateChangeReach * factor;
    Eigen::VectorXf taps (2 * reach + 1);

    for (Eigen::Index n = 0; n < taps.size(); ++n)
        taps[n] = static_cast<float> (
            kaiserSinc (static_cast<double> (n - reach) / static_cast<double> (factor), rateChangeReach, shape));

    return taps;
}
} // namespace antinode
