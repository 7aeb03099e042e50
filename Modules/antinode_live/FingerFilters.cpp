#include "FingerFilters.h"

#include "RateChange.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_tracks/PointDistances.h>
#include <antinode_tracks/PointResponses.h>
#include <antinode_tracks/TrackClimb.h>
#include <antinode_tracks/TrackWork.h>
#include <antinode_tracks/WindowedResponses.h>

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
constexpr double filterTolerance = 1e-3; // of the wanted motion: -60 dB
constexpr double filterRinging = 0.5;    // s after the last tap that counts
constexpr double longestLatency = 0.1;   // s
constexpr Eigen::Index leastDelay = 4;   // samples of the filters

/** How much an error counts at a frequency: all of it in the band, nothing below half and above one and a half. */
double filterWeight (TrackBand band, double frequency)
{
    const auto rising = std::clamp (2 * frequency / band.lower - 1, 0.0, 1.0);
    const auto falling = std::clamp (3 - 2 * frequency / band.upper, 0.0, 1.0);
    const auto share = std::min (rising, falling);
    return share * share * (3 - 2 * share);
}

struct FilterSpan
{
    Eigen::Index factor, delay, taps, length;
    double rate;
};

FilterSpan filterSpan (const WaveformsDescription& description, const FilterSettings& settings)
{
    const auto least = filterRatesPerBand * description.band.upper;

    if (! (settings.sampleRate >= least))
        throw InputError ("sample rate", "is " + inWords (settings.sampleRate) + " Hz; allowed for a band up to "
                                             + inWords (description.band.upper) + " Hz: " + inWords (least)
                                             + " Hz or more");

    FilterSpan span {};
    span.factor = static_cast<Eigen::Index> (settings.sampleRate / least);
    span.rate = settings.sampleRate / static_cast<double> (span.factor);
    span.delay = std::llround (settings.latency * span.rate) - 2 * rateChangeReach;
    const auto shortest = static_cast<double> (leastDelay + 2 * rateChangeReach) / span.rate;

    if (! (settings.latency >= shortest && settings.latency <= longestLatency))
        throw InputError ("latency", "is " + inWords (settings.latency * milli)
                                         + " ms; allowed: " + inWords (std::ceil (shortest * milli)) + " to "
                                         + inWords (longestLatency * milli) + " ms");

    span.taps = std::max<Eigen::Index> (std::llround (settings.length * span.rate), 2 * span.delay);
    span.length = quickLength (static_cast<double> (span.taps) + filterRinging * span.rate);
    return span;
}

/** Each line times its weight. */
void weigh (PointResponses& responses, TrackBand band)
{
    for (Eigen::Index line = 0; line < responses.values.rows(); ++line)
        responses.values.row (line) *= filterWeight (band, responses.sampleRate * static_cast<double> (line)
                                                               / static_cast<double> (responses.length));
}

/** An impulse after the delay, of which the lines of the band are left. */
Eigen::VectorXd weightedImpulse (const FilterSpan& span, TrackBand band)
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

void requireFixedPoints (const WaveformsDescription& description)
{
    const auto points = touchedPoints (description);

    for (std::size_t p = 0; p < points.size(); ++p)
        if (! points[p].path.empty())
            throw InputError ("waveforms: " + pointInWords (description, p) + " path",
                              "is known beforehand only; filters for live inputs take places");
}
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
    const auto span = filterSpan (description, settings);
    requireDistinctPoints (model, description);
    auto responses = pointResponses (model, shapes, touchedLoads (model, description), span.rate, span.length);
    const auto compliance =
        settings.regularisation * settings.regularisation * smallestResponse (responses, {}, description.band);
    weigh (responses, description.band);
    WindowedResponses windowed (std::move (responses), span.taps, compliance);
    const auto impulse = weightedImpulse (span, description.band);
    const Eigen::MatrixXd free = Eigen::MatrixXd::Ones (span.taps, model.actuators());
    FingerFilters filters { settings.sampleRate, span.factor, span.delay, {}, 0, 0 };

    for (std::size_t j = 0; j < description.tracks.size(); ++j)
    {
        if (progress)
            progress ("Filters of each finger",
                      static_cast<double> (j) / static_cast<double> (description.tracks.size()));

        Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero (span.length, shapes.rows());
        wanted.col (static_cast<Eigen::Index> (j)) = impulse;
        const auto found = solveByGradients (windowed, free, wanted, filterTolerance * impulse.norm());
        filters.taps.push_back (windowed.pulls (found.solution));
        filters.iterations += found.iterations;
        filters.error =
            std::max (filters.error, (windowed.motion (filters.taps.back()) - wanted).norm() / impulse.norm());
    }

    return filters;
}
} // namespace antinode
