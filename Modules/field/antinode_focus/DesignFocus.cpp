#include "DesignFocus.h"

#include "Brake.h"
#include "DesignRemarks.h"
#include "FeltLevels.h"
#include "FreeWaveform.h"
#include "ModeDrives.h"
#include "ModeWeighing.h"
#include "Prediction.h"
#include "Projection.h"
#include "Repetition.h"
#include "StateRows.h"
#include "TargetField.h"

#include <antinode_allocation/WaveformBound.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_model/Surface.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
void checkTargets (const ModalModel& model, const std::vector<Target>& targets)
{
    const auto isPlate = model.surface.kind == SurfaceKind::plate; // On a line a y is ignored, with a warning.

    for (std::size_t i = 0; i < targets.size(); ++i)
        requireOnSurface (model.surface, targets[i].x, isPlate ? targets[i].y : 0,
                          "focus: target " + std::to_string (i + 1));
}

void checkRate (const ModalModel& model, const std::vector<int>& modes, Playback playback)
{
    for (const auto mode : modes)
        if (playback.sampleRate > 0 && model.frequencyHz (mode) >= 0.5 * playback.sampleRate)
            throw InputError ("sample rate", "is " + inWords (playback.sampleRate) + " Hz, too low for mode "
                                                 + std::to_string (mode + 1) + " at "
                                                 + inWords (model.frequencyHz (mode)) + " Hz; allowed: above "
                                                 + inWords (2 * model.frequencyHz (mode))
                                                 + " Hz, or only lower modes (focus: maximum frequency)");
}

/** No waveform brings any of the foci with less. */
void addLowerBound (FocusDesign& design, const ModalModel& model)
{
    WaveformBoundProblem problem;
    problem.poles = modalPoles (model) (design.controlledModes);
    problem.participation = model.participation (design.controlledModes, Eigen::all);
    problem.voltageLimits = design.program.voltageLimits;
    double lower = 0, upper = 0;

    for (const auto& moment : design.moments)
    {
        problem.wanted = moment.wanted;
        problem.duration = moment.time;
        checkWatch();
        const auto bound = anyWaveformPeakBound (problem);
        lower = std::max (lower, bound.lower);
        upper = std::max (upper, bound.upper);
    }

    design.lowerBoundVoltage = lower * problem.voltageLimits.maxCoeff();
    design.lowerBoundGap = upper > lower ? 1 - lower / upper : 0;
}

/** What does not depend on what is played. */
FocusDesign makeDesign (const FocusDescription& description, const std::vector<int>& modes,
                        std::vector<FocusMoment> moments, Playback playback, double peakVelocity)
{
    FocusDesign design;
    design.description = description;
    design.controlledModes = modes;
    design.playback = playback;
    design.reachablePeakVelocity = peakVelocity;
    design.moments = std::move (moments);
    const auto& first = design.moments.front();
    design.target = first.target;
    design.truncatedField = first.truncatedField;
    design.captured = first.captured;
    design.residue = std::sqrt (1 - first.captured * first.captured);
    return design;
}

/** Adds what is played until the focus, and its certificate. */
FocusDesign withProgram (FocusDesign design, const ModalModel& model, DesignExtent extent)
{
    checkRate (model, design.controlledModes, design.playback);

    if (design.description.allocation.method == AllocationMethod::leastVoltage)
        sampleProgram (design, model, extent);
    else
        allocateProgram (design, model);

    return design;
}
} // namespace

double peakVoltage (const FocusDesign& design)
{
    if (design.program.samples)
        return design.program.samples->values.cwiseAbs().maxCoeff();

    return design.certificate.peakVoltage;
}

FocusDesign allocateFocus (const ModalModel& model, const FocusDescription& asked, Playback playback,
                           DesignExtent extent)
{
    if (asksForLevels (asked))
    {
        checkTargets (model, asked.targets);
        return designLevels (model, asked, playback,
                             [&] (const FocusDescription& wanted)
                             { return allocateFocus (model, wanted, playback, extent); });
    }

    if (model.actuators() == 0)
        throw InputError ("device '" + model.name + "'", "has no ceramics; a focus needs at least one");

    auto description = asked;
    description.allocation = suitedTo (model, asked.allocation);
    requireComplexModesSuit (model, description);
    checkTargets (model, description.targets);
    const auto wanted = focusMoments (model, description, playback);
    double peakVelocity = 0;

    for (const auto& wantedPlace : description.targets)
        peakVelocity = std::max (peakVelocity, wantedPlace.peakVelocity);

    const auto choose = [&] (ModeChoice choice)
    {
        if (! choice.among)
            choice.among = description.modes.among;

        auto moments = wanted;
        const auto modes = controlModes (model, choice, moments);
        return makeDesign (description, modes, std::move (moments), playback, peakVelocity);
    };
    const auto allocate = [&] (FocusDesign design) { return withProgram (std::move (design), model, extent); };
    return leavesModesOpen (description) ? weighModes (model, { choose, allocate })
                                         : allocate (choose (description.modes));
}

FocusDesign finishDesign (FocusDesign design, const ModalModel& model, DesignExtent extent)
{
    const auto& description = design.description;
    const auto& limits = design.program.voltageLimits;
    design.minimumPeakVoltage = design.certificate.minimumPeakRatio * limits.maxCoeff();

    if (hasBrake (description.transients))
        appendBrake (design, model);

    if (extent == DesignExtent::complete && ! model.hasComplexModes())
        addLowerBound (design, model);

    if (extent == DesignExtent::complete && ! model.hasComplexModes() && ! design.program.samples)
        design.shortestPeriod = shortestPeriod (model, design.program, momentTimes (design.moments));

    if (extent == DesignExtent::complete)
        design.limit = limitUses (model, description.allocation, design.program).nearest();

    addRemarks (design, model);

    if (extent == DesignExtent::complete)
        addTransientRemark (design, model);

    return design;
}

FocusDesign designFocus (const ModalModel& model, const FocusDescription& description, Playback playback,
                         DesignExtent extent)
{
    return finishDesign (allocateFocus (model, description, playback, extent), model, extent);
}

FocusDesign designModes (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                         const Eigen::VectorXd& wanted, Playback playback, DesignExtent extent)
{
    requireRealModes (model, "wanted velocities of single modes");
    const Eigen::VectorXd field = model.shapes (Eigen::all, modes) * wanted;
    FocusMoment moment { description.focusTime, {}, projectField (model, field), wanted, field, 1 };
    auto design = makeDesign (description, modes, { std::move (moment) }, playback, field.cwiseAbs().maxCoeff());
    return finishDesign (withProgram (std::move (design), model, extent), model, extent);
}

namespace
{
/** Further drives seldom lower the least peak below this ratio; lower limits are refused at once. */
constexpr auto minimumShareToTry = 0.35;

/** The drives of every moment, each before its own time. Growth and cycles are those of the first. */
DriveList makeDrives (FocusDesign& design, const ModalModel& model)
{
    const auto& description = design.description;
    DriveList drives;

    for (const auto& moment : design.moments)
        for (const auto& drive : driveModes (model, design.controlledModes, moment.time, description.transients))
        {
            drives.push_back (drive.oscillations);

            if (&moment != &design.moments.front())
                continue;

            design.growth.push_back (drive.growth);
            design.cycles.push_back (drive.cycles);
        }

    if (driveStart (model) == DriveStart::smooth)
        design.choices.emplace_back ("Slew rate or current is limited: drives begin smoothly, without a jump.");

    if (description.allocation.robust)
        for (const auto& drive :
             fasterDrives (model, design.controlledModes, description.focusTime, description.transients))
            drives.push_back (drive);

    return drives;
}

/** Whether further drives may meet a limit that one drive per mode cannot. */
bool mayTakeFurtherDrives (const FocusDescription& description, const AllocationCertificate& certificate)
{
    const auto& choice = description.allocation;
    return choice.method == AllocationMethod::exact && ! choice.robust
           && description.transients.drive == DriveKind::offsetFree
           && certificate.status == AllocationStatus::infeasible
           && minimumShareToTry * certificate.minimumPeakRatio < 1;
}

/** Says what less felt elsewhere costs, and what limits leave undone. */
void sayWhatIsFelt (FocusDesign& design, const LessFelt& felt)
{
    constexpr auto settled = 1e-2; // of the slope of what is minimised
    const auto& choice = design.description.felt.value();
    design.choices.push_back ("Less is felt elsewhere: by " + fixedText (felt.gain, 1)
                              + " dB of energy in terms of the modes of the design, at weight " + inWords (felt.weight)
                              + ". Without that it would need " + inWords (felt.plainPeak) + " V, with it "
                              + inWords (peakVoltage (design)) + " V. Voltages go on for "
                              + inWords (choice.after * milli) + " ms after the focus.");

    if (felt.share == 1 && felt.weight < choice.weight)
        design.warnings.push_back ("The voltage limit allows the weight " + inWords (felt.weight)
                                   + " of the felt level elsewhere, not " + inWords (choice.weight) + ".");

    if (felt.share < 1)
        design.warnings.push_back ("The voltage limit leaves room for " + fixedText (100 * felt.share, 0)
                                   + " % of the change that would make less felt elsewhere.");

    if (felt.residual > settled)
        design.warnings.emplace_back (
            "A lower felt level elsewhere is possible at the same voltage: the search stopped after "
            + std::to_string (felt.iterations) + " steps.");
}

/** Says what least voltage came to, and what is proven of it.
    @param tolerant  the share of the limits that all as robust ones need; 0: not robust */
void sayHowNear (FocusDesign& design, double tolerant)
{
    const auto peak = design.certificate.peakRatio, bound = design.certificate.minimumPeakRatio;
    design.choices.push_back ("Least voltage: " + inWords (peakVoltage (design)) + " V, at most " + inWords (100 * peak)
                              + " % of each ceramic's limit, " + inWords (peak / bound) + " times the "
                              + inWords (100 * bound) + " % below which no samples do.");

    if (tolerant > 0)
        design.choices.push_back ("That is " + inWords (peak / tolerant) + " times the " + inWords (100 * tolerant)
                                  + " % below which no free samples do whose expected error is as small.");
}

/** Allocates until the wanted velocities of complex modes and what the imaginary parts of their shapes add are the
   wanted field together. Modes that are nearly real need two or three rounds. */
Allocation allocateComplex (const FocusDesign& design, const ModalModel& model, const DriveList& drives)
{
    constexpr auto maximumRounds = 10;
    constexpr auto settled = 1e-6; // of the largest velocity
    auto corrected = design.moments;
    Allocation allocation;

    for (int round = 0; round < maximumRounds; ++round)
    {
        allocation =
            allocateDrives ({ model, design.description, design.controlledModes, corrected, design.playback }, drives);

        if (correctWanted (corrected, design, model, drives, allocation.matrix) < settled)
            break;
    }

    return allocation;
}

void addFurtherDrives (DriveList& drives, const FocusDesign& design, const ModalModel& model)
{
    for (const auto& moment : design.moments)
        for (const auto& drive :
             furtherDrives (model, design.controlledModes, moment.time, design.description.transients))
            drives.push_back (drive);
}
} // namespace

void allocateProgram (FocusDesign& design, const ModalModel& model)
{
    auto drives = makeDrives (design, model);
    const auto allocate = [&]
    {
        if (model.hasComplexModes())
            return allocateComplex (design, model, drives);

        return allocateDrives ({ model, design.description, design.controlledModes, design.moments, design.playback },
                               drives);
    };
    auto allocation = allocate();

    if (mayTakeFurtherDrives (design.description, allocation.certificate))
    {
        addFurtherDrives (drives, design, model);
        allocation = allocate();
        design.choices.emplace_back ("One drive per mode cannot meet the limits: each mode has further drives, "
                                     "which rise faster or start "
                                     "a quarter period later.");
    }

    design.program = makeProgram (drives, allocation.matrix, voltageLimits (model, design.description.allocation),
                                  design.moments.front().time);
    design.certificate = allocation.certificate;
    throwWhereBeyondLimit (design, model);
}

/** Free samples keep slew limits where they are band-limited, and nothing is added to them. */
static void checkSlewsCanBeKept (const FocusDesign& design)
{
    if (design.playback.reconstruction == Reconstruction::zeroOrderHold)
        throw InputError ("reconstruction", "holds samples, and this device has a slew or current limit, which no step "
                                            "keeps; allowed for free samples: 'band_limited'");

    if (design.description.felt && design.description.allocation.isUpToLimits())
        throw InputError ("focus: felt", "makes a waveform quieter without regard to the slew or current limit of this "
                                         "device; allowed: a device without one, or another method");
}

void sampleProgram (FocusDesign& design, const ModalModel& model, DesignExtent extent)
{
    if (hasSlewLimits (model))
        checkSlewsCanBeKept (design);

    const auto& moment = design.moments.front();
    const auto limits = voltageLimits (model, design.description.allocation);
    auto description = design.description;
    description.focusTime = moment.time;
    auto waveform = freeWaveform (model, description, design.controlledModes, moment.wanted, limits, design.playback);
    design.growth.assign (design.controlledModes.size(), 0);
    design.cycles.assign (design.controlledModes.size(), 0);

    if (extent != DesignExtent::playable)
        design.intersamplePeakVoltage = intersamplePeak (waveform.voltages);

    design.certificate = waveform.certificate;
    design.program.allocation.resize (model.actuators(), 0);
    design.program.voltageLimits = limits;
    design.program.focusTime = moment.time;
    design.program.samples = std::move (waveform.voltages);

    if (waveform.edgeTime > 0)
        design.choices.push_back ("Edges last " + inWords (waveform.edgeTime * 1000)
                                  + " ms, as the slew or current limit asks for; bounds hold for such waveforms.");

    if (waveform.felt)
        sayWhatIsFelt (design, *waveform.felt);

    if (description.allocation.isNearBound())
        sayHowNear (design, waveform.tolerantPeakRatio);
}
} // namespace antinode
