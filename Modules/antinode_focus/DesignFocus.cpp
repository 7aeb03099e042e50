#include "DesignFocus.h"

#include "Brake.h"
#include "DesignRemarks.h"
#include "DriveAllocation.h"
#include "DriveGrid.h"
#include "FocusMoments.h"
#include "LowerBound.h"
#include "Prediction.h"
#include "Projection.h"
#include "Repetition.h"
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

/** No waveform brings any of the foci with less. */
double lowerBound (const ModalModel& model, const std::vector<int>& modes, const std::vector<FocusMoment>& moments,
                   const Eigen::VectorXd& limits)
{
    WaveformBoundProblem problem;
    problem.poles = modalPoles (model) (modes);
    problem.participation = model.participation (modes, Eigen::all);
    problem.voltageLimits = limits;
    double bound = 0;

    for (const auto& moment : moments)
    {
        problem.wanted = moment.wanted;
        problem.duration = moment.time;
        bound = std::max (bound, anyWaveformPeakBound (problem));
    }

    return bound * limits.maxCoeff();
}

/** The drives of every moment, each before its own time. Growth and cycles are told of the first. */
DriveList drivesOf (FocusDesign& design, const ModalModel& model)
{
    DriveList drives;

    for (const auto& moment : design.moments)
        for (const auto& drive : driveModes (model, design.controlledModes, moment.time, design.description.transients))
        {
            drives.push_back (drive.oscillations);

            if (&moment != &design.moments.front())
                continue;

            design.growth.push_back (drive.growth);
            design.cycles.push_back (drive.cycles);
        }

    return drives;
}

FocusDesign designDrives (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                          std::vector<FocusMoment> moments, Playback playback, double peakVelocity, DesignExtent extent)
{
    checkRate (model, modes, playback);
    FocusDesign design;
    design.description = description;
    design.controlledModes = modes;
    design.moments = std::move (moments);
    const auto& first = design.moments.front();
    design.target = first.target;
    design.truncatedField = first.truncatedField;
    design.captured = first.captured;
    design.residue = std::sqrt (1 - first.captured * first.captured);

    const auto drives = drivesOf (design, model);
    const auto limits = voltageLimits (model, description.allocation);
    const auto allocation = allocateDrives (model, description, modes, design.moments, drives, playback);
    throwWhereBeyondLimit (allocation.certificate, description.allocation.method, limits, peakVelocity);

    design.program = programOf (drives, allocation.matrix, limits, first.time);
    design.certificate = allocation.certificate;
    design.playback = playback;
    design.leastPeakVoltage = allocation.certificate.leastPeakRatio * limits.maxCoeff();
    design.reachablePeakVelocity = peakVelocity;

    if (hasBrake (description.transients))
        appendBrake (design, model);

    if (extent == DesignExtent::complete)
    {
        design.lowerBoundVoltage = lowerBound (model, modes, design.moments, limits);
        design.shortestPeriod = shortestPeriod (model, design.program, timesOf (design.moments));
    }

    addRemarks (design, model);
    return design;
}
} // namespace

double peakVoltage (const FocusDesign& design)
{
    // The certificate's ratio is against limits that are tightened for what lies between the samples of its grid.
    return design.certificate.peakRatio * gridLimitMargin() * design.program.voltageLimits.maxCoeff();
}

FocusDesign designFocus (const ModalModel& model, const FocusDescription& description, Playback playback,
                         DesignExtent extent)
{
    if (model.actuators() == 0)
        throw InputError ("device '" + model.name + "'", "has no ceramics, a focus needs at least one");

    checkTargets (model.surface, description.targets);
    auto moments = focusMoments (model, description, playback);
    const auto modes = controlModes (model, description.modes, moments);
    double peakVelocity = 0;

    for (const auto& wantedPlace : description.targets)
        peakVelocity = std::max (peakVelocity, wantedPlace.peakVelocity);

    return designDrives (model, description, modes, std::move (moments), playback, peakVelocity, extent);
}

FocusDesign designModes (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                         const Eigen::VectorXd& wanted, Playback playback)
{
    const Eigen::VectorXd field = model.shapes (Eigen::all, modes) * wanted;
    FocusMoment moment { description.focusTime, description.targets, projectField (model, field), wanted, field, 1 };
    return designDrives (model, description, modes, { std::move (moment) }, playback, field.cwiseAbs().maxCoeff(),
                         DesignExtent::complete);
}
} // namespace antinode
