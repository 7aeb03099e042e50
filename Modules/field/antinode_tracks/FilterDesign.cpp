#include "FilterDesign.h"

#include "FingerFilters.h"
#include "PointResponses.h"
#include "TrackWork.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr double filterRatesPerBand = 4; // the filters' rate over the band's upper frequency, at least
constexpr double filterRinging = 0.2;    // s after the last tap that counts
constexpr double longestLatency = 0.1;   // s
constexpr Eigen::Index leastDelay = 4;   // samples of the filters
constexpr double weightEnd = 1.5;        // times the band's upper frequency

/** How much an error counts at a frequency: all of it up to the end of the band, nothing above one and a half times
    that. A lower end would be felt by none, and last longer than the filters. */
double filterWeight (TrackBand band, double frequency)
{
    const auto share = std::clamp ((weightEnd - frequency / band.upper) / (weightEnd - 1), 0.0, 1.0);
    return share * share * (3 - 2 * share);
}
} // namespace

Eigen::Index FilterTiming::latencySamples() const
{
    return (delay + 2 * rateChangeReach) * factor;
}

FilterTiming filterTiming (TrackBand band, const FilterSettings& settings)
{
    const auto least = filterRatesPerBand * band.upper;

    if (! (settings.sampleRate >= least))
        throw InputError ("sample rate", "is " + inWords (settings.sampleRate) + " Hz; allowed for a band up to "
                                             + inWords (band.upper) + " Hz: " + inWords (least) + " Hz or more");

    FilterTiming timing;
    timing.factor = static_cast<Eigen::Index> (settings.sampleRate / least);
    const auto rate = settings.sampleRate / static_cast<double> (timing.factor);
    timing.delay = std::llround (settings.latency * rate) - 2 * rateChangeReach;
    const auto shortest = static_cast<double> (leastDelay + 2 * rateChangeReach) / rate;

    if (! (settings.latency >= shortest && settings.latency <= longestLatency))
        throw InputError ("latency", "is " + inWords (settings.latency * milli)
                                         + " ms; allowed: " + inWords (std::ceil (shortest * milli)) + " to "
                                         + inWords (longestLatency * milli) + " ms");

    timing.taps = std::max<Eigen::Index> (std::llround (settings.length * rate), 2 * timing.delay);
    return timing;
}

double highestWeighed (TrackBand band)
{
    return weightEnd * band.upper;
}

FilterSpan filterSpan (TrackBand band, const FilterSettings& settings)
{
    const auto timing = filterTiming (band, settings);
    const auto rate = settings.sampleRate / static_cast<double> (timing.factor);
    const auto length = quickLength (static_cast<double> (timing.taps) + filterRinging * rate);
    return { timing.factor, timing.delay, timing.taps, length, rate };
}

void weighLines (PointResponses& responses, TrackBand band)
{
    for (Eigen::Index line = 0; line < responses.values.rows(); ++line)
        responses.values.row (line) *= filterWeight (band, responses.sampleRate * static_cast<double> (line)
                                                               / static_cast<double> (responses.length));
}

Eigen::VectorXd weighedImpulse (const FilterSpan& span, TrackBand band)
{
    Eigen::VectorXcd lines (span.length / 2 + 1);

    for (Eigen::Index line = 0; line < lines.size(); ++line)
    {
        const auto turns = static_cast<double> (line) / static_cast<double> (span.length);
        lines[line] = std::polar (filterWeight (band, turns * span.rate),
                                  -2 * std::numbers::pi * turns * static_cast<double> (span.delay));
    }

    return inverseFourier (lines, span.length);
}

double filterError (const GradientsResult& found, double compliance, const Eigen::VectorXd& impulse)
{
    return (found.left + compliance * found.solution).norm() / impulse.norm();
}

void requireFixedPoints (const WaveformsDescription& description)
{
    const auto points = touchedPoints (description);

    for (std::size_t p = 0; p < points.size(); ++p)
        if (! points[p].path.empty())
            throw InputError ("waveforms: " + pointInWords (description, p) + " path",
                              "needs the whole event in advance; filters for live inputs take places");
}

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
