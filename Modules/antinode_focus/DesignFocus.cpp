#include "DesignFocus.h"

#include "Brake.h"
#include "DesignRemarks.h"
#include "DriveAllocation.h"
#include "DriveDictionary.h"
#include "DriveGrid.h"
#include "FreeWaveform.h"
#include "LowerBound.h"
#include "Prediction.h"
#include "Projection.h"
#include "RobustDrives.h"
#include "SampledPrediction.h"
#include "TargetField.h"
#include "Transients.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
void checkTargets (const Surface& surface, const std::vector<Target>& targets)
{
    const auto isPlate = surface.kind == SurfaceKind::plate;

    for (std::size_t i = 0; i < targets.size(); ++i)
    {
        const auto where = "focus: /targets/" + std::to_string (i);
        const auto check = [&] (const char* key, double value, double minimum, double maximum)
        {
            if (value < minimum || value > maximum)
                throw InputError (where + key, "is " + inWords (value * 1000)
                                                   + ", which is beside the surface: allowed is "
                                                   + inWords (minimum * 1000) + " to " + inWords (maximum * 1000));
        };
        check ("/x_mm", targets[i].x, surface.xMinimum, surface.xMaximum);

        if (isPlate)
            check ("/y_mm", targets[i].y, surface.yMinimum, surface.yMaximum);
    }
}

void checkRate (const ModalModel& model, const std::vector<int>& modes, Playback playback)
{
    for (const auto mode : modes)
        if (playback.sampleRate > 0 && model.frequencyHz (mode) >= 0.5 * playback.sampleRate)
            throw InputError ("sample rate", inWords (playback.sampleRate) + " Hz cannot play mode "
                                                 + std::to_string (mode + 1) + " at "
                                                 + inWords (model.frequencyHz (mode))
                                                 + " Hz: take more than twice that, or control lower modes only "
                                                   "(focus: /modes/maximum_frequency_Hz)");
}

double lowerBound (const ModalModel& model, const std::vector<int>& modes, const Eigen::VectorXd& wanted,
                   const Eigen::VectorXd& limits, double focusTime)
{
    WaveformBoundProblem problem;
    problem.poles = modalPoles (model) (modes);
    problem.participation = model.participation (modes, Eigen::all);
    problem.wanted = wanted;
    problem.voltageLimits = limits;
    problem.duration = focusTime;
    return anyWaveformPeakBound (problem) * limits.maxCoeff();
}

/** What does not depend on what is played. */
FocusDesign designOf (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                      const Eigen::VectorXd& wanted, Playback playback, double peakVelocity, DesignExtent extent)
{
    FocusDesign design;
    design.description = description;
    design.controlledModes = modes;
    design.playback = playback;
    design.reachablePeakVelocity = peakVelocity;

    if (extent == DesignExtent::complete)
        design.lowerBoundVoltage =
            lowerBound (model, modes, wanted, voltageLimits (model, description.allocation), description.focusTime);

    return design;
}

FocusDesign designSamples (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                           const Eigen::VectorXd& wanted, Playback playback, double peakVelocity, DesignExtent extent)
{
    if (extent == DesignExtent::playable)
        throw InputError (
            "focus: /allocation/method",
            "is 'free_waveform', which is played offline only; use 'dictionary' in real time, which comes "
            "near the same voltage");

    const auto limits = voltageLimits (model, description.allocation);
    auto waveform = freeWaveform (model, description, modes, wanted, limits, playback);
    auto design = designOf (model, description, modes, wanted, playback, peakVelocity, extent);
    design.growth.assign (modes.size(), 0);
    design.cycles.assign (modes.size(), 0);
    design.intersamplePeakVoltage = intersamplePeak (waveform.voltages);
    design.certificate = waveform.certificate;
    design.program.allocation.resize (model.actuators(), 0);
    design.program.voltageLimits = limits;
    design.program.focusTime = description.focusTime;
    design.program.samples = std::move (waveform.voltages);
    design.leastPeakVoltage = design.certificate.leastPeakRatio * limits.maxCoeff();

    if (description.transients.brake)
        appendBrake (design, model);

    return design;
}

FocusDesign designDrives (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                          const Eigen::VectorXd& wanted, Playback playback, double peakVelocity, DesignExtent extent)
{
    checkRate (model, modes, playback);

    if (description.allocation.method == AllocationMethod::freeWaveform)
        return designSamples (model, description, modes, wanted, playback, peakVelocity, extent);

    const auto modeDrives = driveModes (model, modes, description.focusTime, description.transients);
    auto design = designOf (model, description, modes, wanted, playback, peakVelocity, extent);
    DriveList drives;

    for (const auto& drive : modeDrives)
    {
        drives.push_back (drive.oscillations);
        design.growth.push_back (drive.growth);
        design.cycles.push_back (drive.cycles);
    }

    if (description.allocation.robust)
        for (const auto& drive : fasterDrives (model, modes, description.focusTime, description.transients))
            drives.push_back (drive);

    if (description.allocation.method == AllocationMethod::dictionary)
        drives = dictionaryDrives (model, description, modes, design.growth);

    const auto limits = voltageLimits (model, description.allocation);
    const auto allocation = allocateDrives (model, description, modes, wanted, drives, playback);
    throwWhereBeyondLimit (allocation.certificate, description.allocation.method, limits, peakVelocity,
                           hasSlewLimits (model));

    design.program = programOf (drives, allocation.matrix, limits, description.focusTime);
    design.certificate = allocation.certificate;
    design.leastPeakVoltage = allocation.certificate.leastPeakRatio * limits.maxCoeff();

    if (description.transients.brake)
        appendBrake (design, model);

    return design;
}
} // namespace

double peakVoltage (const FocusDesign& design)
{
    if (design.program.samples)
        return design.program.samples->values.cwiseAbs().maxCoeff();

    // The certificate's ratio is against limits that are tightened for what lies between the samples of its grid.
    return design.certificate.peakRatio * gridLimitMargin() * design.program.voltageLimits.maxCoeff();
}

FocusDesign designFocus (const ModalModel& model, const FocusDescription& description, Playback playback,
                         DesignExtent extent)
{
    if (model.actuators() == 0)
        throw InputError ("device '" + model.name + "'", "has no ceramics, a focus needs at least one");

    checkTargets (model.surface, description.targets);
    const auto target = projectField (model, targetField (model.surface, description.targets, description.edgeWindow));

    if (! (target.energy > 0))
        throw InputError ("focus: /targets", "give no velocity anywhere on '" + model.name
                                                 + "': widen a target, or narrow the edge window");

    const auto selection = selectModes (model, target, description.modes);
    double peakVelocity = 0;

    for (const auto& wantedPlace : description.targets)
        peakVelocity = std::max (peakVelocity, wantedPlace.peakVelocity);

    auto design = designDrives (model, description, selection.modes, selection.wanted, playback, peakVelocity, extent);
    design.target = target;
    design.truncatedField = selection.truncated;
    design.captured = selection.captured;
    design.residue = std::sqrt (1 - selection.captured * selection.captured);
    addRemarks (design, model);
    return design;
}

FocusDesign designModes (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                         const Eigen::VectorXd& wanted, Playback playback)
{
    const Eigen::VectorXd field = model.shapes (Eigen::all, modes) * wanted;
    auto design =
        designDrives (model, description, modes, wanted, playback, field.cwiseAbs().maxCoeff(), DesignExtent::complete);
    design.target = projectField (model, field);
    design.truncatedField = field;
    design.captured = 1;
    addRemarks (design, model);
    return design;
}
} // namespace antinode
