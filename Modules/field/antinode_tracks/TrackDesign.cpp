#include "TrackDesign.h"

#include "LeastPeak.h"
#include "TrackSolver.h"
#include "TrackWork.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_numerics/KaiserSinc.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
/** Between the samples of the design waveforms go beyond the limits a little, and slew rates are not among them: so its
    limits are lowered until what is played keeps all. The last thousandth is taken by the size. */
TrackReach limitedTracks (TrackWork& work, const Eigen::MatrixXd& start)
{
    constexpr int attempts = 4;
    constexpr double enough = 1.001;
    TrackReach best;
    TrackSolution solution;
    Eigen::VectorXd limits = work.limits;
    solution.multipliers = start;

    for (int i = 0; i < attempts; ++i)
    {
        solution = solveLimitedTracks (work.responses, work.wanted, limits, solution.multipliers, acceptedTrackError);
        best.iterations += solution.iterations;
        best.played = interpolated (solution.voltages, work.span.factor);
        best.times = timesLimits (work, best.played);

        if (best.times <= enough || solution.errorBound > acceptedTrackError)
            break;

        limits /= best.times;
    }

    const auto shrink = 1 / std::max (1.0, best.times);
    best.played *= shrink;
    best.times *= shrink;
    best.span = work.span;
    best.error = (shrink * work.responses.motion (solution.voltages) - work.wanted).norm() / work.wanted.norm();
    best.bound = peakBound (work.responses, work.wanted, work.limits, solution.multipliers, best.error);
    return best;
}

[[noreturn]] void throwUnreachable (const TrackReach& reach, double unlimitedPeak)
{
    constexpr double tells = 0.5; // where slew rates decide, the bound, which does not know them, says nothing
    const auto share = 1 / reach.times;
    const auto bound = reach.bound * share;
    throw TrackLimitError (
        "waveforms",
        "need " + inWords (unlimitedPeak) + " times the limits of the device; reachable: " + inWords (100 * share)
            + " % of the wanted levels (" + fixedText (20 * std::log10 (share), 1) + " dB)"
            + (bound > tells ? ", by no waveform more than " + inWords (100 / reach.bound) + " %" : std::string())
            + "; more with a longer pre_roll_ms and post_roll_ms or fewer fingers",
        share, bound);
}

/** The least error within the limits, or where that is above what is accepted, the voltages that are known to leave
   less.
    @throws TrackLimitError  where there are none */
TrackReach tracksWithinLimits (const ModalModel& model, const WaveformsDescription& description, TrackWork& work,
                               const TrackSolution& unlimited, double unlimitedPeak)
{
    auto reach = reachOf (model, description, work, unlimited);

    if (reach.times > 1)
        throwUnreachable (reach, unlimitedPeak);

    auto limited = limitedTracks (work, unlimited.multipliers);
    auto& best = limited.error <= reach.error ? limited : reach;
    best.iterations = limited.iterations + reach.iterations;
    return std::move (best);
}

std::vector<std::string> warningsOf (const WaveformsDescription& description, double rate)
{
    const auto reach = kaiserSincHalfWidth / rate;
    auto warnings = description.warnings;

    if (std::min (description.preRoll, description.postRoll) < reach)
        warnings.push_back ("Voltages begin and end up to " + inWords (reach * milli)
                            + " ms beyond the tracks, by which samples are interpolated.");

    return warnings;
}
} // namespace

TrackDesign designTracks (const ModalModel& model, const WaveformsDescription& description,
                          const TrackSettings& settings, const ShowProgress& progress, const TrackShift& shift)
{
    const auto show = [&] (const char* what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Responses of the surface", 0);
    auto work = trackWork (model, description, settings);
    applyShift (work, shift, description.band);
    show ("Voltages without limits", 0.2);
    const auto unlimited = solveTracks (work.responses, work.wanted);
    TrackReach found;
    found.played = interpolated (unlimited.voltages, work.span.factor);
    found.span = work.span;
    found.error = unlimited.error;
    TrackDesign design;
    design.limitUse.unlimitedPeak = timesLimits (work, found.played);

    if (design.limitUse.unlimitedPeak > 1)
    {
        show ("Voltages within the limits", 0.5);
        found = tracksWithinLimits (model, description, work, unlimited, design.limitUse.unlimitedPeak);
        design.limitUse.peakBound = found.bound;
    }

    design.description = description;
    design.designRate = found.span.rate;
    design.error = found.error;
    design.iterations = unlimited.iterations + found.iterations;
    design.peaks = found.played.cwiseAbs().colwise().maxCoeff().transpose();
    design.voltages = { { Reconstruction::bandLimited, settings.sampleRate },
                        -static_cast<double> (found.span.lead + kaiserSincHalfWidth) / found.span.rate,
                        found.played.transpose() };
    design.wanted = wantedAsPlayed (model, description, settings);
    design.warnings = warningsOf (description, work.span.rate);
    return design;
}
} // namespace antinode
