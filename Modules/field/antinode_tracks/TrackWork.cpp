#include "TrackWork.h"

#include "PointResponses.h"
#include "TouchedNodes.h"
#include "TrackSolver.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr double ratesPerBand = 6;    // the design's rate over the band's upper frequency, at least
constexpr double decayedTo = 0.01;    // of the slowest mode, before the transforms begin again
constexpr double longestDecay = 2;    // s of it at most: what rings then is quiet at all points
constexpr Eigen::Index mostFiner = 8; // times the design's rate, at which limits are kept sample by sample

double decayTime (const ModalModel& model, TrackBand band)
{
    const auto rates = decayRates (model);
    auto slowest = rates[0];

    for (Eigen::Index k = 0; k < model.modes() && model.frequencyHz (k) <= 2 * band.upper; ++k)
        slowest = std::min (slowest, rates[k]);

    return std::min (-std::log (decayedTo) / slowest, longestDecay);
}

/** Voltages reach kaiserSincHalfWidth samples beyond the window, which belong to the roll. */
Eigen::Index rollSamples (double roll, double rate)
{
    return std::max<Eigen::Index> (0, static_cast<Eigen::Index> (std::floor (roll * rate)) - kaiserSincHalfWidth);
}

TrackSpan trackSpan (const ModalModel& model, const WaveformsDescription& description, double sampleRate)
{
    const auto least = ratesPerBand * description.band.upper;

    if (! (sampleRate >= least))
        throw InputError ("sample rate", "is " + inWords (sampleRate) + " Hz; allowed for a band up to "
                                             + inWords (description.band.upper) + " Hz: " + inWords (least)
                                             + " Hz or more");

    TrackSpan span;
    span.factor = static_cast<Eigen::Index> (sampleRate / least);
    span.rate = sampleRate / static_cast<double> (span.factor);
    span.lead = rollSamples (description.preRoll, span.rate);
    span.wanted = static_cast<Eigen::Index> (std::ceil (tracksDuration (description) * span.rate)) + 1;
    span.window = span.lead + span.wanted + rollSamples (description.postRoll, span.rate);
    span.length = quickLength (static_cast<double> (span.window) + decayTime (model, description.band) * span.rate);
    return span;
}

/** The smallest singular values of the responses within the band, squared: from the trace of the inverse, of which it
   is the largest part. */
void addSmallest (std::vector<double>& squares, const PointResponses& responses, TrackBand band)
{
    const auto step = responses.sampleRate / static_cast<double> (responses.length);

    for (auto line = static_cast<Eigen::Index> (std::ceil (band.lower / step));
         line <= static_cast<Eigen::Index> (band.upper / step); ++line)
    {
        const auto response = responses.atLine (line);
        const Eigen::MatrixXcd gram = response * response.adjoint();
        const Eigen::MatrixXcd inverse =
            solveSemidefinite (gram, Eigen::MatrixXcd::Identity (gram.rows(), gram.cols()));
        squares.push_back (1 / inverse.real().trace());
    }
}

/** Peaks over their limits. */
double highest (const Eigen::VectorXd& limits, const Eigen::MatrixXd& played)
{
    return (played.cwiseAbs().colwise().maxCoeff().transpose().array() / limits.array()).maxCoeff();
}

/** Slew rates over their limits, 0: none. */
double steepest (const Eigen::VectorXd& slews, double sampleRate, const Eigen::MatrixXd& played)
{
    double times = 0;

    for (Eigen::Index i = 0; i < played.cols(); ++i)
        if (const auto last = played.rows() - 1; slews[i] > 0)
            times = std::max (times, (played.col (i).tail (last) - played.col (i).head (last)).cwiseAbs().maxCoeff()
                                         * sampleRate / slews[i]);

    return times;
}
} // namespace

double smallestResponse (const PointResponses& nodes, const MovingPoints& moving, TrackBand band)
{
    std::vector<double> squares;

    if (moving.points.empty())
        addSmallest (squares, nodes, band);

    for (const auto sample : moving.stages)
        addSmallest (squares, frozenResponses (nodes, moving, sample), band);

    return median (squares);
}

TrackProblem trackProblem (const ModalModel& model, const WaveformsDescription& description,
                           const TrackSettings& settings)
{
    const auto span = trackSpan (model, description, settings.sampleRate);
    requirePlaces (model.surface, description);
    requireEnoughCeramics (model, description);
    requirePathMemory (model, description);
    const TouchedNodes nodes (model, description, span.rate);
    requireTrackMemory (trackBytes (model, description, span, nodes), static_cast<double> (span.wanted) / span.rate);
    requireDistinctPoints (model, description);
    TrackProblem problem {
        span, nodes.weights (span.rate, span.lead, span.length),
        pointResponses (model, nodes.shapes(), touchedLoads (model, description), span.rate, span.length),
        Eigen::MatrixXd::Zero (span.length, static_cast<Eigen::Index> (touchedPoints (description).size()))
    };
    problem.wanted.middleRows (span.lead, span.wanted) = wantedMotion (description, settings.threshold, span.rate);
    return problem;
}

TrackWork trackWork (const ModalModel& model, const WaveformsDescription& description, const TrackSettings& settings)
{
    auto problem = trackProblem (model, description, settings);
    const auto& span = problem.span;
    auto& moving = problem.moving;
    const auto compliance = settings.regularisation * settings.regularisation
                            * smallestResponse (problem.responses, moving, description.band);
    return { span,
             WindowedResponses (std::move (problem.responses), span.window, compliance, std::move (moving)),
             std::move (problem.wanted),
             voltageLimits (model),
             slewLimits (model),
             settings.sampleRate };
}

Eigen::MatrixXd wantedAsPlayed (const ModalModel& model, const WaveformsDescription& description,
                                const TrackSettings& settings)
{
    const auto span = trackSpan (model, description, settings.sampleRate);
    return interpolated (wantedMotion (description, settings.threshold, span.rate), span.factor)
        .middleRows (kaiserSincHalfWidth * span.factor, (span.wanted - 1) * span.factor + 1);
}

std::optional<TrackWork> finerWork (const ModalModel& model, const WaveformsDescription& description,
                                    const TrackWork& coarse)
{
    Eigen::Index factor = std::min (mostFiner, coarse.span.factor);

    while (coarse.span.factor % factor != 0)
        --factor;

    auto span = coarse.span;
    span.factor /= factor;
    span.rate *= static_cast<double> (factor);
    span.lead *= factor;
    span.wanted = (span.wanted - 1) * factor + 1;
    span.window = (span.window - 1) * factor + 1;
    span.length *= factor;
    const TouchedNodes nodes (model, description, span.rate);

    if (! isWithinMemory (trackBytes (model, description, span, nodes)))
        return {};

    auto moving = nodes.weights (span.rate, span.lead, span.length);
    auto responses = pointResponses (model, nodes.shapes(), touchedLoads (model, description), span.rate, span.length);
    return TrackWork { span,
                       WindowedResponses (std::move (responses), span.window, coarse.responses.compliance(),
                                          std::move (moving)),
                       finer (coarse.wanted, factor),
                       coarse.limits,
                       coarse.slews,
                       coarse.sampleRate };
}

Eigen::MatrixXd finer (const Eigen::MatrixXd& signals, Eigen::Index factor)
{
    const auto length = signals.rows();
    Eigen::MatrixXd result (length * factor, signals.cols());

    for (Eigen::Index i = 0; i < signals.cols(); ++i)
    {
        const auto lines = forwardFourier (signals.col (i));
        Eigen::VectorXcd more = Eigen::VectorXcd::Zero (result.rows() / 2 + 1);
        more.head (lines.size()) = lines;
        more[lines.size() - 1] /= factor > 1 ? 2 : 1; // the Nyquist line stands for two
        result.col (i) = static_cast<double> (factor) * inverseFourier (more, result.rows());
    }

    return result;
}

bool isSteep (const TrackWork& work, const Eigen::MatrixXd& played)
{
    return steepest (work.slews, work.sampleRate, played) > highest (work.limits, played);
}

double timesLimits (const TrackWork& work, const Eigen::MatrixXd& played)
{
    return std::max (highest (work.limits, played), steepest (work.slews, work.sampleRate, played));
}

double timesLimits (const ModalModel& model, double sampleRate, const Eigen::MatrixXd& played)
{
    return std::max (highest (voltageLimits (model), played), steepest (slewLimits (model), sampleRate, played));
}

namespace
{
/** The largest velocity of a displacement, between samples too, m/s. */
double largestVelocityOf (const Eigen::VectorXd& displacement, double sampleRate)
{
    const auto length = quickLength (2 * static_cast<double> (displacement.size()));
    auto spectrum = forwardFourier (displacement, length);

    for (Eigen::Index k = 0; k < spectrum.size(); ++k)
        spectrum[k] *= std::complex (0.0, 2 * std::numbers::pi * static_cast<double> (k) * sampleRate
                                              / static_cast<double> (length));

    return peakBetweenSamples (inverseFourier (spectrum, length));
}

/** An event as a file numbers it: "waveforms: track 2 event 3"; without its number where the track has one. */
std::string eventInWords (const WaveformsDescription& description, std::size_t track, std::size_t event)
{
    const auto isOnly = description.tracks[track].events.size() == 1;
    return "waveforms: " + pointInWords (description, track) + (isOnly ? "" : " event " + std::to_string (event + 1));
}

void requireInBand (const TrackSignal& signal, TrackBand band, const std::string& where)
{
    const auto require = [&] (double frequency)
    {
        if (! (frequency >= band.lower && frequency <= band.upper))
            throw InputError (where + " frequency", "is " + inWords (frequency) + " Hz; allowed: the band, "
                                                        + inWords (band.lower) + " to " + inWords (band.upper) + " Hz");
    };
    const auto check = [&] (const auto& each)
    {
        if constexpr (requires { each.frequency; })
            require (each.frequency);

        if constexpr (requires { each.points; })
            for (const auto& point : each.points)
                require (point.frequency);
    };
    std::visit (check, signal);
}

/** What to multiply a waveform by so that it has its level. */
double scaleFor (const Eigen::VectorXd& waveform, double sampleRate, const TrackLevel& level,
                 const SkinThreshold& threshold)
{
    switch (level.kind)
    {
        case LevelKind::velocity:
            return level.value / largestVelocityOf (waveform, sampleRate);
        case LevelKind::sensation:
            return std::pow (10, level.value / 20)
                   / feltAmount (feltDisplacement (waveform, sampleRate, threshold), sampleRate);
        case LevelKind::displacement:
            break;
    }

    return level.value / peakBetweenSamples (waveform);
}
} // namespace

Eigen::MatrixXd wantedMotion (const WaveformsDescription& description, const SkinThreshold& threshold,
                              double sampleRate)
{
    const auto points = description.tracks.size() + description.silent.size();
    const auto samples = static_cast<Eigen::Index> (std::ceil (tracksDuration (description) * sampleRate)) + 1;
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero (samples, static_cast<Eigen::Index> (points));

    for (std::size_t p = 0; p < description.tracks.size(); ++p)
    {
        const auto& events = description.tracks[p].events;

        for (std::size_t e = 0; e < events.size(); ++e)
        {
            checkWatch();
            const auto& event = events[e];
            const auto where = eventInWords (description, p, e);
            requireInBand (event.signal, description.band, where);
            const auto first = std::llround (event.start * sampleRate);
            const auto waveform = signalSamples (event.signal, description.band, sampleRate);

            if (! (waveform.cwiseAbs().maxCoeff() > 0))
                throw InputError (where, "is silent within the band");

            const auto count = std::min<Eigen::Index> (waveform.size(), samples - first);
            motion.col (static_cast<Eigen::Index> (p)).segment (first, count) +=
                event.amplitude * scaleFor (waveform, sampleRate, event.level, threshold) * waveform.head (count);
        }
    }

    return motion;
}

namespace
{
constexpr double mostBytes = 1 << 30; // of memory
constexpr double byNumber = sizeof (double);

double tableBytes (const ModalModel& model, const WaveformsDescription& description)
{
    double places = 0;

    for (const auto& point : touchedPoints (description))
        places += static_cast<double> (PathShapes::placesAlong (point));

    return byNumber * places * static_cast<double> (model.coordinates());
}
} // namespace

TrackBytes trackBytes (const ModalModel& model, const WaveformsDescription& description, const TrackSpan& span,
                       const TouchedNodes& touched)
{
    constexpr double signalsKept = 8, copiesPlayed = 3, copiesOfNodes = 3;
    const auto points = static_cast<double> (description.tracks.size() + description.silent.size());
    const auto nodes = static_cast<double> (touched.shapes().rows());
    const auto stages = static_cast<double> (touched.stages());
    const auto actuators = static_cast<double> (model.actuators());
    const auto moving = nodes > points ? copiesOfNodes * nodes : 0;
    const auto inLines = nodes * actuators + stages * points * points + actuators + signalsKept * points + moving;
    const auto inWindow = actuators * (signalsKept + copiesPlayed * static_cast<double> (span.factor));
    return { byNumber * (static_cast<double> (span.length) * inLines + static_cast<double> (span.window) * inWindow),
             tableBytes (model, description) };
}

bool isWithinMemory (TrackBytes bytes)
{
    return bytes.sum() <= mostBytes;
}

void requireTrackMemory (TrackBytes bytes, double seconds)
{
    if (! isWithinMemory (bytes))
        throw InputError ("waveforms", "last " + inWords (seconds) + " s, which needs "
                                           + inWords (bytes.sum() / mostBytes) + " GiB; allowed: 1 GiB, about "
                                           + inWords (std::floor (seconds * (mostBytes - bytes.tables) / bytes.samples))
                                           + " s with this device and rate");
}

void requirePathMemory (const ModalModel& model, const WaveformsDescription& description)
{
    const auto bytes = tableBytes (model, description);

    if (bytes > mostBytes)
        throw InputError ("waveforms",
                          "have paths that need " + inWords (bytes / mostBytes) + " GiB; allowed: 1 GiB, about "
                              + inWords (std::floor (100 * mostBytes / bytes)) + " % of their length with this device");
}

namespace
{
constexpr auto softness = 1e4; // of the voltages that make up for an error: what they cannot bring is left

/** 1 in the band, 0 below half of it and above twice of it; in between as a raised cosine of the octave. */
double shareInBand (double frequency, TrackBand band)
{
    if (frequency <= band.lower / 2 || frequency >= 2 * band.upper)
        return 0;

    const auto octaves = std::max (std::log2 (band.lower / frequency), std::log2 (frequency / band.upper));
    return octaves > 0 ? 0.5 + 0.5 * std::cos (std::numbers::pi * octaves) : 1;
}

/** Recorded signals at the samples of a design, without what lies beyond a band, where there is one. */
Eigen::MatrixXd atDesignRate (const TrackWork& work, const TrackShift& shift, const Eigen::MatrixXd& signals,
                              std::optional<TrackBand> band)
{
    const auto& span = work.span;
    const Eigen::Index first = std::llround (shift.firstTime * work.sampleRate) + span.lead * span.factor;
    const auto begin = std::max<Eigen::Index> (0, -first);
    const auto count = std::min (signals.rows(), span.length * span.factor - first) - begin;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (span.length, signals.cols());

    for (Eigen::Index p = 0; p < signals.cols() && count > 0; ++p)
    {
        Eigen::VectorXd whole = Eigen::VectorXd::Zero (span.length * span.factor);
        whole.segment (first + begin, count) = signals.col (p).segment (begin, count);
        Eigen::VectorXcd lines = forwardFourier (whole).head (span.length / 2 + 1);

        for (Eigen::Index k = 0; band && k < lines.size(); ++k)
            lines[k] *= shareInBand (static_cast<double> (k) * span.rate / static_cast<double> (span.length), *band);

        result.col (p) = inverseFourier (lines, span.length) / static_cast<double> (span.factor);
    }

    return result;
}
} // namespace

void applyShift (TrackWork& work, const TrackShift& shift, TrackBand band)
{
    if (shift.missing.cols() == 0)
        return;

    const auto compliance = work.responses.compliance();
    work.responses.setCompliance (softness * compliance);
    const auto change = solveTracks (work.responses, atDesignRate (work, shift, shift.missing, band)).voltages;
    work.responses.setCompliance (compliance);
    work.wanted = atDesignRate (work, shift, shift.predicted, {}) + work.responses.motion (change);
}
} // namespace antinode
