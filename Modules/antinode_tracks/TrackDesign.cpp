#include "TrackDesign.h"

#include "PointDistances.h"
#include "TrackSolver.h"
#include "VoltageInterpolation.h"
#include "WantedMotion.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Median.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr double ratesPerBand = 6;    // the design's rate over the band's upper frequency, at least
constexpr double decayedTo = 0.01;    // of the slowest mode, before the transforms begin again
constexpr double longestDecay = 2;    // s of it at most: what rings then is quiet at all points
constexpr double mostBytes = 1 << 30; // of memory

/** The samples of a design: how many, and how many of the played ones each is. */
struct TrackSpan
{
    Eigen::Index factor = 1;
    double rate = 0;         // Hz
    Eigen::Index lead = 0;   // samples of voltage before the trigger
    Eigen::Index wanted = 0; // samples from the trigger to the end of the last track
    Eigen::Index window = 0; // samples of voltage
    Eigen::Index length = 0; // of the transforms
};

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

/** What the design holds at once, bytes. */
double bytesNeeded (const TrackSpan& span, double points, double actuators)
{
    constexpr double byNumber = sizeof (double), signalsKept = 8, copiesPlayed = 3;
    const auto lines = static_cast<double> (span.length);
    return byNumber
           * (lines * (points * actuators + points * points + actuators + signalsKept * points)
              + static_cast<double> (span.window) * actuators
                    * (signalsKept + copiesPlayed * static_cast<double> (span.factor)));
}

void requireMemory (const TrackSpan& span, Eigen::Index points, Eigen::Index actuators)
{
    const auto bytes = bytesNeeded (span, static_cast<double> (points), static_cast<double> (actuators));

    if (bytes > mostBytes)
        throw InputError ("waveforms",
                          "last " + inWords (static_cast<double> (span.wanted) / span.rate) + " s, which needs "
                              + inWords (bytes / mostBytes) + " GiB; allowed: 1 GiB, about "
                              + inWords (std::floor (static_cast<double> (span.wanted) / span.rate * mostBytes / bytes))
                              + " s with this device and rate");
}

/** The median over the band of the smallest singular value of the responses, squared: from the trace of the inverse, of
   which it is the largest part. */
double smallestResponse (const PointResponses& responses, TrackBand band)
{
    const auto step = responses.sampleRate / static_cast<double> (responses.length);
    std::vector<double> squares;

    for (auto line = static_cast<Eigen::Index> (std::ceil (band.lower / step));
         line <= static_cast<Eigen::Index> (band.upper / step); ++line)
    {
        const auto response = responses.atLine (line);
        const Eigen::MatrixXcd gram = response * response.adjoint();
        const Eigen::MatrixXcd inverse =
            solveSemidefinite (gram, Eigen::MatrixXcd::Identity (gram.rows(), gram.cols()));
        squares.push_back (1 / inverse.real().trace());
    }

    return median (squares);
}

/** A design while it is made. */
struct TrackWork
{
    TrackSpan span;
    WindowedResponses responses;
    Eigen::MatrixXd wanted; // length x points
    Eigen::VectorXd limits, slews;
    double sampleRate = 0; // Hz, of what is played
};

TrackWork trackWork (const ModalModel& model, const WaveformsDescription& description, const TrackSettings& settings)
{
    const auto shapes = touchedShapes (model, description);
    const auto span = trackSpan (model, description, settings.sampleRate);
    requireMemory (span, shapes.rows(), model.actuators());
    requireDistinctPoints (model, description);
    auto responses = pointResponses (model, shapes, touchedLoads (model, description), span.rate, span.length);
    const auto compliance =
        settings.regularisation * settings.regularisation * smallestResponse (responses, description.band);
    TrackWork work { span,
                     WindowedResponses (std::move (responses), span.window, compliance),
                     Eigen::MatrixXd::Zero (span.length, shapes.rows()),
                     voltageLimits (model),
                     Eigen::VectorXd (model.actuators()),
                     settings.sampleRate };
    work.wanted.middleRows (span.lead, span.wanted) = wantedMotion (description, settings.threshold, span.rate);

    for (std::size_t i = 0; i < model.ceramics.size(); ++i)
        work.slews[static_cast<Eigen::Index> (i)] = model.ceramics[i].slewLimit;

    return work;
}

/** How many times its limits a waveform is: the largest of peak and slew over all ceramics. */
double timesLimits (const TrackWork& work, const Eigen::MatrixXd& played)
{
    double times = 0;

    for (Eigen::Index i = 0; i < played.cols(); ++i)
    {
        times = std::max (times, played.col (i).cwiseAbs().maxCoeff() / work.limits[i]);

        if (const auto last = played.rows() - 1; work.slews[i] > 0)
            times = std::max (times, (played.col (i).tail (last) - played.col (i).head (last)).cwiseAbs().maxCoeff()
                                         * work.sampleRate / work.slews[i]);
    }

    return times;
}

/** Voltages within all limits when they are played, and the error that they leave. */
struct LimitedTracks
{
    TrackSolution solution;
    Eigen::MatrixXd played; // samples x actuators, V
    double error = 0;
};

/** Between the samples of the design waveforms go beyond them a little, and slew rates are not among its limits: so its
    limits are lowered until what is played keeps all. The last thousandth is taken by the size. */
LimitedTracks limitedTracks (TrackWork& work, const Eigen::MatrixXd& start, double level)
{
    constexpr int attempts = 4;
    constexpr double enough = 1.001;
    LimitedTracks best;
    Eigen::VectorXd limits = work.limits / level;
    Eigen::MatrixXd multipliers = start;

    for (int i = 0; i < attempts; ++i)
    {
        best.solution = solveLimitedTracks (work.responses, work.wanted, limits, multipliers, acceptedTrackError);
        best.played = level * interpolated (best.solution.voltages, work.span.factor);
        multipliers = best.solution.multipliers;
        const auto times = timesLimits (work, best.played);

        if (times <= enough || best.solution.errorBound > acceptedTrackError)
            break;

        limits /= times;
    }

    const auto shrink = 1 / std::max (1.0, timesLimits (work, best.played));
    best.played *= shrink;
    best.error = (shrink * work.responses.motion (best.solution.voltages) - work.wanted).norm() / work.wanted.norm();
    return best;
}

/** The bound of section 4.13 on the limits that a level needs, over these limits. */
double boundOf (TrackWork& work, const LimitedTracks& limited, double level)
{
    return peakBound (work.responses, work.wanted, work.limits / level, limited.solution.multipliers, limited.error);
}

/** The largest share of the wanted levels that the limits allow. */
[[noreturn]] void throwUnreachable (TrackWork& work, const TrackSolution& unlimited, double unlimitedPeak)
{
    constexpr int bisections = 3;
    auto reached = 1 / unlimitedPeak, beyond = 1.0, bound = 0.0;
    const auto attempt = [&] (double level)
    {
        const auto limited = limitedTracks (work, unlimited.multipliers, level);
        const auto isReached = limited.error <= acceptedTrackError;
        (isReached ? reached : beyond) = level;
        bound = isReached ? boundOf (work, limited, level) : bound;
    };

    while (2 * reached < beyond && beyond == 1)
        attempt (2 * reached);

    for (int i = 0; i < bisections; ++i)
        attempt (std::sqrt (reached * beyond));

    throw TrackLimitError ("waveforms",
                           "need " + inWords (unlimitedPeak)
                               + " times the limits of the device; reachable: " + inWords (100 * reached)
                               + " % of the wanted levels (" + fixedText (20 * std::log10 (reached), 1)
                               + " dB), or more with a longer pre_roll_ms and post_roll_ms or fewer fingers",
                           reached, bound);
}

std::vector<std::string> warningsOf (const WaveformsDescription& description, double rate)
{
    const auto reach = kaiserSincHalfWidth / rate;

    if (std::min (description.preRoll, description.postRoll) < reach)
        return { "Voltages begin and end up to " + inWords (reach * milli)
                 + " ms beyond the tracks, by which samples are interpolated." };

    return {};
}
} // namespace

TrackDesign designTracks (const ModalModel& model, const WaveformsDescription& description,
                          const TrackSettings& settings, const ShowProgress& progress)
{
    const auto show = [&] (const char* what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Responses of the surface", 0);
    auto work = trackWork (model, description, settings);
    show ("Voltages without limits", 0.2);
    const auto unlimited = solveTracks (work.responses, work.wanted);
    TrackDesign design;
    design.description = description;
    design.designRate = work.span.rate;
    design.error = unlimited.error;
    design.iterations = unlimited.iterations;
    auto played = interpolated (unlimited.voltages, work.span.factor);
    design.limitUse.unlimitedPeak = timesLimits (work, played);

    if (design.limitUse.unlimitedPeak > 1)
    {
        show ("Voltages within the limits", 0.5);
        auto limited = limitedTracks (work, unlimited.multipliers, 1);
        design.iterations += limited.solution.iterations;
        design.error = limited.error;
        design.limitUse.peakBound = boundOf (work, limited, 1);
        played = std::move (limited.played);

        if (design.error > acceptedTrackError)
            throwUnreachable (work, unlimited, design.limitUse.unlimitedPeak);
    }

    design.peaks = played.cwiseAbs().colwise().maxCoeff().transpose();
    design.voltages = { { Reconstruction::bandLimited, settings.sampleRate },
                        -static_cast<double> (work.span.lead + kaiserSincHalfWidth) / work.span.rate,
                        played.transpose() };
    design.wanted =
        interpolated (work.wanted.middleRows (work.span.lead, work.span.wanted), work.span.factor)
            .middleRows (kaiserSincHalfWidth * work.span.factor, (work.span.wanted - 1) * work.span.factor + 1);
    design.warnings = warningsOf (description, work.span.rate);
    return design;
}
} // namespace antinode
