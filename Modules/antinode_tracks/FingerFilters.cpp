#include "FingerFilters.h"

#include "PointDistances.h"
#include "PointResponses.h"
#include "TrackClimb.h"
#include "TrackWork.h"
#include "WindowedResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>

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

/** A filter rate, a band's width and a change of rate: 1 below a quarter of the rate, -70 dB above three quarters. */
constexpr Eigen::Index rateChangeReach = 5; // samples of the filters to each side
constexpr double rateChangeShape = 7;       // Kaiser's beta

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

/** Kaiser's windowed sinc at the samples around a sample of the filters. */
Eigen::VectorXd rateChangeTaps (Eigen::Index factor)
{
    const auto reach = rateChangeReach * factor;
    Eigen::VectorXd taps (2 * reach + 1);

    for (Eigen::Index n = 0; n < taps.size(); ++n)
        taps[n] = kaiserSinc (static_cast<double> (n - reach) / static_cast<double> (factor), rateChangeReach,
                              rateChangeShape);

    return taps;
}

/** Signals at the filters' rate, from rateChangeReach of its samples before the first one to as many behind the last.
 */
Eigen::MatrixXd decimated (const Eigen::MatrixXd& signals, Eigen::Index factor)
{
    const Eigen::VectorXd taps = rateChangeTaps (factor) / static_cast<double> (factor);
    const auto reach = rateChangeReach * factor;
    Eigen::MatrixXd slower ((signals.rows() - 1) / factor + 1 + 2 * rateChangeReach, signals.cols());

    for (Eigen::Index m = 0; m < slower.rows(); ++m)
    {
        const auto centre = (m - rateChangeReach) * factor;
        const auto begin = std::max<Eigen::Index> (0, centre - reach);
        const auto end = std::min (signals.rows(), centre + reach + 1);
        slower.row (m) = begin < end
                             ? Eigen::RowVectorXd (taps.segment (begin - centre + reach, end - begin).transpose()
                                                   * signals.middleRows (begin, end - begin))
                             : Eigen::RowVectorXd::Zero (signals.cols()).eval();
    }

    return slower;
}

/** The other way, again from rateChangeReach samples before the first to as many behind the last. */
Eigen::MatrixXd expanded (const Eigen::MatrixXd& signals, Eigen::Index factor)
{
    const auto taps = rateChangeTaps (factor);
    Eigen::MatrixXd result =
        Eigen::MatrixXd::Zero ((signals.rows() - 1 + 2 * rateChangeReach) * factor + 1, signals.cols());

    for (Eigen::Index i = 0; i < signals.cols(); ++i)
        for (Eigen::Index m = 0; m < signals.rows(); ++m)
            result.col (i).segment (m * factor, taps.size()) += signals (m, i) * taps;

    return result;
}

[[noreturn]] void throwTooLoud (double times)
{
    throw TrackLimitError ("waveforms",
                           "need " + inWords (times)
                               + " times the limits of the device; reachable: " + inWords (100 / times)
                               + " % of the wanted levels (" + fixedText (-20 * std::log10 (times), 1)
                               + " dB); more with a longer latency or fewer fingers",
                           1 / times, 1 / times);
}
} // namespace

double FingerFilters::latency() const
{
    return static_cast<double> (delay + 2 * rateChangeReach) / rate();
}

FingerFilters designFingerFilters (const ModalModel& model, const WaveformsDescription& description,
                                   const FilterSettings& settings, const ShowProgress& progress)
{
    const auto shapes = touchedShapes (model, description);
    const auto span = filterSpan (description, settings);
    requireDistinctPoints (model, description);
    auto responses = pointResponses (model, shapes, touchedLoads (model, description), span.rate, span.length);
    const auto compliance =
        settings.regularisation * settings.regularisation * smallestResponse (responses, description.band);
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

SampledVoltages filteredTracks (const FingerFilters& filters, const Eigen::MatrixXd& inputs)
{
    const auto slower = decimated (inputs, filters.factor);
    const auto taps = filters.taps.front().rows();
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (slower.rows() + taps - 1, filters.taps.front().cols());

    for (std::size_t j = 0; j < filters.taps.size(); ++j)
        for (Eigen::Index k = 0; k < taps; ++k)
            voltages.middleRows (k, slower.rows()).noalias() +=
                slower.col (static_cast<Eigen::Index> (j)) * filters.taps[j].row (k);

    return { { Reconstruction::bandLimited, filters.sampleRate },
             -filters.latency(),
             expanded (voltages, filters.factor).transpose() };
}

TrackDesign designLiveTracks (const ModalModel& model, const WaveformsDescription& description,
                              const TrackSettings& settings, const ShowProgress& progress)
{
    FilterSettings filterSettings;
    filterSettings.sampleRate = settings.sampleRate;
    filterSettings.latency = settings.latency;
    const auto filters = designFingerFilters (model, description, filterSettings, progress);
    TrackDesign design;
    design.description = description;
    design.wanted = wantedAsPlayed (model, description, settings);
    design.voltages =
        filteredTracks (filters, design.wanted.leftCols (static_cast<Eigen::Index> (description.tracks.size())));
    design.designRate = filters.rate();
    design.latency = filters.latency();
    design.error = filters.error;
    design.iterations = filters.iterations;
    design.peaks = design.voltages.values.cwiseAbs().rowwise().maxCoeff();
    design.limitUse.unlimitedPeak = timesLimits (model, settings.sampleRate, design.voltages.values.transpose());

    if (design.limitUse.unlimitedPeak > 1)
        throwTooLoud (design.limitUse.unlimitedPeak);

    return design;
}
} // namespace antinode
