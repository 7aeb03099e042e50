#include "DesignFocus.h"

#include "Brake.h"
#include "ComplexRows.h"
#include "DesignRemarks.h"
#include "DesignSteps.h"
#include "DesignedProgram.h"
#include "FocusMoments.h"
#include "ModeWeighing.h"
#include "Prediction.h"
#include "Projection.h"
#include "Repetition.h"

#include <antinode_allocation/LowerBound.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Watch.h>
#include <antinode_model/PlaceOnSurface.h>

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

    if (methodTraits (design.description.allocation.method).waveforms == AllocatedWaveforms::samples)
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

FocusDesign allocateFocus (const ModalModel& model, const FocusDescription& description, Playback playback,
                           DesignExtent extent)
{
    if (model.actuators() == 0)
        throw InputError ("device '" + model.name + "'", "has no ceramics; a focus needs at least one");

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
} // namespace antinode
