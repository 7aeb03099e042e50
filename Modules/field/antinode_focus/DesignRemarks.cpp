#include "DesignRemarks.h"

#include "DriveAllocation.h"
#include "FocusScore.h"
#include "LimitUse.h"
#include "Prediction.h"
#include "Projection.h"

#include <antinode_allocation/WaveformBound.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace antinode
{
namespace
{
constexpr double poorCapture = 0.9;
constexpr double noticedRigid = 0.14;          // sqrt (1 - 0.99^2)
constexpr double poorTransient = 0.05;         // field error
constexpr double minimumMove = 1e-9;           // s
constexpr double reliableShareOfNyquist = 0.8; // the interpolation of the plate model and of real converters

std::string robustnessInWords (const Robustness& robustness)
{
    const auto percent = [] (double share) { return inWords (100 * share) + " %"; };
    const auto& spread = robustness.spread;
    return "Robust against errors of " + percent (std::hypot (spread.frequency, spread.drift)) + " in frequency, "
           + percent (spread.damping) + " in damping and " + percent (spread.participation)
           + " in participation (standard deviations).";
}

std::string methodInWords (const AllocationChoice& choice)
{
    switch (choice.method)
    {
        case AllocationMethod::exact:
            return "exact terminal velocities of all controlled modes at the least norm within the voltage limit; "
                   "other modes are guarded";
        case AllocationMethod::leastVoltage:
            return "exact terminal velocities of all controlled modes by freely chosen samples "
                   + std::string (choice.isNearBound() ? "near the lowest voltage that any waveform needs"
                                                       : "of least energy within the voltage limit")
                   + "; other modes are guarded";
        case AllocationMethod::paper:
            break;
    }

    return "the paper's problem: least norm within the voltage limit, only each mode's own row";
}

void addChoices (FocusDesign& design, const ModalModel& model)
{
    const auto& description = design.description;
    std::string modes;

    if (! design.weighing.empty())
        design.choices.push_back (design.weighing);

    for (const auto mode : design.controlledModes)
        modes += (modes.empty() ? "" : ", ") + std::to_string (mode + 1);

    design.choices.push_back ("Controlled modes: " + modes + " of " + std::to_string (model.modes()) + ".");

    for (const auto& moment : design.moments)
        for (const auto& target : moment.targets)
            if (const auto asked = target.time.value_or (moment.time); std::abs (asked - moment.time) > minimumMove)
                design.choices.push_back ("The focus at " + inWords (asked * 1000)
                                          + " ms is moved to the nearest sample, at " + inWords (moment.time * 1000)
                                          + " ms.");

    const auto hasDrives = ! design.program.samples;

    if (hasDrives && description.transients.growth.empty())
        design.choices.push_back (
            "The growth is chosen so that all modes rise together, by 4 e-folds before the focus.");

    if (hasDrives && description.transients.cycles.empty())
        design.choices.push_back ("The number of cycles is the largest that fits before the focus.");

    design.choices.push_back ("Allocation: " + methodInWords (description.allocation) + ".");

    if (description.allocation.robust)
        design.choices.push_back (robustnessInWords (*description.allocation.robust));

    if (hasDrives && description.allocation.robust && description.transients.growth.empty())
        design.choices.emplace_back ("Each mode has a second drive, which rises by 12 e-folds before the focus.");
}

/** Modes that measured points hide: left out, or controlled because somebody asked. */
void addHiddenModes (FocusDesign& design, const ModalModel& model)
{
    const auto shown = static_cast<int> (resolvedModes (model));

    if (shown == model.modes())
        return;

    const auto asked = std::any_of (design.controlledModes.begin(), design.controlledModes.end(),
                                    [&] (int mode) { return mode >= shown; });
    design.warnings.push_back (
        "The " + std::to_string (model.points()) + " measured points are less than " + inWords (enoughPointsPerHalfWave)
        + " per half wave of the modes above mode " + std::to_string (shown)
        + (asked ? ": between the points they are unknown, and the field is wrong there."
                 : ", which are left out; 'modes' with 'maximum_frequency_Hz' controls them, too, as they are at the "
                   "points."));
}

/** What is exceeded, by how much, and what comes of it. */
std::string excessInWords (const LimitUse& limit, const ModalModel& model)
{
    const auto isVoltage = limit.kind != LimitKind::slew && limit.kind != LimitKind::current;
    return "This allocation needs " + limitAmount (limit.kind, limit.used) + " at " + limitedCeramic (model, limit)
           + ", but the " + limitName (limit.kind) + " is " + limitAmount (limit.kind, limit.allowed)
           + (isVoltage ? "; the limiter will clip it and change the field. "
                        : "; the amplifier will not follow, which changes the field. ")
           + "Use a longer window, a lower velocity or a higher limit.";
}

void warnOfPeak (FocusDesign& design, const ModalModel& model)
{
    if (! design.limit)
        return;

    if (const auto& limit = *design.limit; limit.share() > 1 + 1e-6)
        design.warnings.push_back (excessInWords (limit, model));
    else if (design.certificate.status == AllocationStatus::optimal && ! design.description.allocation.isNearBound())
        design.warnings.push_back ("The " + limitName (limit.kind)
                                   + " is reached: the voltages are spread over more ceramics than without it.");
}

/** Warns of described drives where samples are played instead. */
void warnOfUnusedDrives (FocusDesign& design)
{
    const auto& transients = design.description.transients;

    if (! design.program.samples)
        return;

    std::string unused;

    if (! transients.cycles.empty())
        unused = "'cycles'";
    else if (transients.drive == DriveKind::paper)
        unused = "'drive'";
    else if (! transients.growth.empty())
        unused = "'growth'";

    if (! unused.empty())
        design.warnings.push_back (unused + " is ignored: this allocation makes its own waveforms.");
}

/** A place of a focus, as its messages name it. */
struct NamedPlace
{
    std::string name;
    double x = 0, y = 0; ///< m
};

/** Where less is to be felt; none where that is everywhere. */
std::vector<NamedPlace> bystanders (const FocusDescription& description)
{
    std::vector<NamedPlace> places;
    const auto at = description.felt ? description.felt->at : FeltAt::everywhere;

    if (at == FeltAt::places)
        for (const auto& [x, y] : description.felt->places)
            places.push_back ({ "place " + std::to_string (places.size() + 1), x, y });

    if (at == FeltAt::fingers)
        for (const auto& finger : description.fingers)
            places.push_back ({ "finger " + std::to_string (places.size() + 1), finger.x, finger.y });

    return places;
}

/** Less felt at a focus works against the focus itself. */
void warnOfFeltAtTargets (FocusDesign& design, bool isLine)
{
    const auto& targets = design.description.targets;

    for (const auto& place : bystanders (design.description))
        for (std::size_t i = 0; i < targets.size(); ++i)
        {
            const auto alongY = isLine ? 0 : place.y - targets[i].y;
            const auto distance = std::hypot (place.x - targets[i].x, alongY);

            if (distance < targets[i].width / 2)
                design.warnings.push_back ("'felt': " + place.name + " lies " + inWords (distance * milli)
                                           + " mm from target " + std::to_string (i + 1)
                                           + ", within its width: less felt there works against the focus.");
        }
}

/** A line has no y. */
void warnOfIgnoredY (FocusDesign& design, const ModalModel& model)
{
    const auto& description = design.description;
    std::vector<NamedPlace> places;

    for (const auto& target : description.targets)
        places.push_back ({ "target " + std::to_string (places.size() + 1), target.x, target.y });

    for (std::size_t i = 0; i < description.fingers.size(); ++i)
        places.push_back ({ "finger " + std::to_string (i + 1), description.fingers[i].x, description.fingers[i].y });

    if (description.felt && description.felt->at == FeltAt::places)
        for (const auto& place : bystanders (description))
            places.push_back (place);

    for (const auto& place : places)
        if (place.y != 0)
            design.warnings.push_back ("y of " + place.name + ", " + inWords (place.y * milli)
                                       + " mm, is ignored: the surface of '" + model.name + "' is a line.");
}

void warnOfLooseBound (FocusDesign& design)
{
    const auto gap = design.lowerBoundGap;

    if (gap == 1)
        design.warnings.push_back (
            "No waveform was found that brings the controlled modes to their velocities: the lower bound of "
            + inWords (design.lowerBoundVoltage) + " V may be far too low. Control fewer modes.");
    else if (gap > waveformBoundTolerance)
        design.warnings.push_back ("The lower bound of " + inWords (design.lowerBoundVoltage)
                                   + " V is not tight: the best waveform that was found needs "
                                   + inWords (design.lowerBoundVoltage / (1 - gap)) + " V.");
}

void addSampleRemarks (FocusDesign& design)
{
    const auto& samples = *design.program.samples;
    const auto peak = design.intersamplePeakVoltage;
    design.choices.push_back ("The waveform consists of samples for exactly " + inWords (samples.playback.sampleRate)
                              + " Hz"
                              + (peak > 0 ? "; between the samples it peaks at " + inWords (peak) + " V." : "."));
}

void warnOfCapture (FocusDesign& design, const ModalModel& model)
{
    const auto& worst =
        *std::min_element (design.moments.begin(), design.moments.end(),
                           [] (const FocusMoment& a, const FocusMoment& b) { return a.captured < b.captured; });

    if (worst.captured < poorCapture)
        design.warnings.push_back ("The controlled modes represent only " + inWords (worst.captured)
                                   + " of the wanted field (1 is all of it). " + lossInWords (model, design, worst));

    const auto& target = worst.target;
    const auto rigid = std::sqrt (target.rigidEnergy / (target.energy + target.rigidEnergy));

    if (rigid > noticedRigid)
        design.warnings.push_back (
            "The device can move as a rigid body, and ceramics cannot excite this part of the wanted field: "
            + inWords (std::round (1000 * rigid) / 10)
            + " % (square root of energy). Foci of opposite sign, or a sinc, have less of it.");
}
} // namespace

void addTransientRemark (FocusDesign& design, const ModalModel& model)
{
    for (const auto& moment : design.moments)
    {
        const auto velocities = modalVelocities (model, predictStates (model, design.program, moment.time));
        const auto error = scoreField (model.surface, model.shapes * velocities, moment.truncatedField).fieldError;

        if (error > poorTransient)
            design.warnings.push_back (transientInWords (design, moment, velocities, error));
    }
}

void addRemarks (FocusDesign& design, const ModalModel& model)
{
    addChoices (design, model);

    if (const auto sentence = retirementInWords (design.description.allocation); ! sentence.empty())
        design.warnings.push_back (sentence);

    design.warnings.insert (design.warnings.end(), model.warnings.begin(), model.warnings.end());

    warnOfCapture (design, model);
    addHiddenModes (design, model);

    const auto highest = model.frequencyHz (design.controlledModes.back());

    if (design.playback.sampleRate > 0 && highest > reliableShareOfNyquist * 0.5 * design.playback.sampleRate)
        design.warnings.push_back (
            "Mode " + std::to_string (design.controlledModes.back() + 1) + " at " + inWords (highest)
            + " Hz is close to half the sample rate, where converters roll off; choose a higher rate.");

    const auto isLine = model.surface.kind == SurfaceKind::line;
    warnOfFeltAtTargets (design, isLine);

    if (isLine)
        warnOfIgnoredY (design, model);

    warnOfUnusedDrives (design);
    warnOfPeak (design, model);
    warnOfLooseBound (design);

    if (design.program.samples)
        addSampleRemarks (design);
}
} // namespace antinode
