#include "DesignFocus.h"

#include "Brake.h"
#include "DesignRemarks.h"
#include "DriveGrid.h"
#include "LowerBound.h"
#include "Prediction.h"
#include "Projection.h"
#include "TargetField.h"
#include "Transients.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
using Drives = std::vector<std::vector<Oscillation>>;

double millimetresPerSecond (double velocity)
{
    return velocity * 1000;
}

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

/** The modes guarded: the lowest of those that are not controlled. */
std::vector<int> guardsFor (const ModalModel& model, const std::vector<int>& controlled, const AllocationChoice& choice)
{
    std::vector<int> guards;

    for (int k = 0; k < model.modes(); ++k)
        if (! std::binary_search (controlled.begin(), controlled.end(), k))
            guards.push_back (k);

    if (choice.guardModes && *choice.guardModes < static_cast<int> (guards.size()))
        guards.resize (static_cast<std::size_t> (*choice.guardModes));

    return guards;
}

double firstStart (const Drives& drives)
{
    auto first = drives.front().front().start;

    for (const auto& drive : drives)
        first = std::min (first, drive.front().start);

    return first;
}

/** Each mode by the ceramic that moves it most. */
Eigen::MatrixXd oneToOneAllocation (const Eigen::MatrixXd& participation, const Eigen::VectorXd& wanted)
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero (participation.cols(), participation.rows());

    for (Eigen::Index k = 0; k < participation.rows(); ++k)
    {
        Eigen::Index best = 0;
        participation.row (k).cwiseAbs().maxCoeff (&best);
        matrix (best, k) = wanted[k] / participation (k, best);
    }

    return matrix;
}

AllocationProblem allocationProblem (const ModalModel& model, const FocusDescription& description,
                                     const std::vector<int>& modes, const Eigen::VectorXd& wanted, const Drives& drives,
                                     Playback playback)
{
    const auto& choice = description.allocation;
    const auto isExact = choice.method == AllocationMethod::exact || choice.method == AllocationMethod::minimumPeak;
    const auto time = description.focusTime;
    const auto first = choice.window ? std::max (time - *choice.window, firstStart (drives)) : firstStart (drives);
    const auto count = static_cast<Eigen::Index> (modes.size());

    AllocationProblem problem;
    problem.waveforms = sampleDrives (drives, first, time + releaseDuration());
    problem.participation = model.participation (modes, Eigen::all);
    problem.wanted = wanted;
    problem.voltageLimits = voltageLimits (model, choice) * gridLimitMargin();

    if (! isExact)
    {
        problem.rows = Eigen::MatrixXd::Identity (count, count);
        return problem;
    }

    const auto guards = guardsFor (model, modes, choice);
    problem.rows = terminalVelocities (model, modes, drives, time, playback);
    problem.guardParticipation = model.participation (guards, Eigen::all);
    problem.guardRows = terminalVelocities (model, guards, drives, time, playback);
    problem.guardWeight = choice.guardWeight;
    return problem;
}

Allocation allocate (const AllocationProblem& problem, AllocationMethod method)
{
    if (method == AllocationMethod::minimumPeak)
        return solveAllocation (problem, AllocationGoal::peak);

    if (method == AllocationMethod::exact || method == AllocationMethod::paper)
        return solveAllocation (problem, AllocationGoal::norm);

    Allocation allocation;
    allocation.matrix = method == AllocationMethod::oneToOne
                            ? oneToOneAllocation (problem.participation, problem.wanted)
                            : minimumNormAllocation (problem);
    const Eigen::MatrixXd voltages = allocation.matrix * problem.waveforms;
    allocation.certificate.objective = 0.5 * voltages.squaredNorm();
    allocation.certificate.peakRatio =
        voltages.cwiseAbs().rowwise().maxCoeff().cwiseQuotient (problem.voltageLimits).maxCoeff();
    return allocation;
}

void throwWhereBeyondLimit (const AllocationCertificate& certificate, AllocationMethod method,
                            const Eigen::VectorXd& limits, double peakVelocity)
{
    const auto isBeyond = certificate.status == AllocationStatus::infeasible
                          || (method == AllocationMethod::minimumPeak && certificate.peakRatio > 1);

    if (! isBeyond)
        return;

    const auto ratio = certificate.peakRatio;
    const auto least = limits.maxCoeff() * ratio;
    const auto reachable = peakVelocity / ratio;
    throw LimitError ("focus: /allocation/voltage_limit_V",
                      inWords (limits.maxCoeff()) + " V cannot bring " + inWords (millimetresPerSecond (peakVelocity))
                          + " mm/s: these drives need at least " + inWords (least) + " V; at this limit "
                          + inWords (millimetresPerSecond (reachable)) + " mm/s can be reached",
                      least, reachable);
}

/** A drive's oscillations share its column of the matrix. */
VoltageProgram programOf (const Drives& drives, const Eigen::MatrixXd& matrix, const Eigen::VectorXd& limits,
                          double focusTime)
{
    VoltageProgram program;
    std::vector<Eigen::Index> columns;

    for (std::size_t l = 0; l < drives.size(); ++l)
        for (const auto& oscillation : drives[l])
        {
            program.oscillations.push_back (oscillation);
            columns.push_back (static_cast<Eigen::Index> (l));
        }

    program.allocation = matrix (Eigen::all, columns);
    program.voltageLimits = limits;
    program.focusTime = focusTime;
    return program;
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

FocusDesign designDrives (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                          const Eigen::VectorXd& wanted, Playback playback, double peakVelocity, DesignExtent extent)
{
    checkRate (model, modes, playback);
    const auto modeDrives = driveModes (model, modes, description.focusTime, description.transients);
    FocusDesign design;
    Drives drives;

    for (const auto& drive : modeDrives)
    {
        drives.push_back (drive.oscillations);
        design.growth.push_back (drive.growth);
        design.cycles.push_back (drive.cycles);
    }

    const auto limits = voltageLimits (model, description.allocation);
    const auto problem = allocationProblem (model, description, modes, wanted, drives, playback);
    const auto allocation = allocate (problem, description.allocation.method);
    throwWhereBeyondLimit (allocation.certificate, description.allocation.method, limits, peakVelocity);

    design.description = description;
    design.controlledModes = modes;
    design.program = programOf (drives, allocation.matrix, limits, description.focusTime);
    design.certificate = allocation.certificate;
    design.playback = playback;
    design.leastPeakVoltage = allocation.certificate.leastPeakRatio * limits.maxCoeff();
    design.reachablePeakVelocity = peakVelocity;

    if (extent == DesignExtent::complete)
        design.lowerBoundVoltage = lowerBound (model, modes, wanted, limits, description.focusTime);

    if (description.transients.brake)
        appendBrake (design, model);

    return design;
}
} // namespace

LimitError::LimitError (const std::string& where, const std::string& wrong, double leastPeakVoltageToUse,
                        double reachableVelocityToUse)
    : InputError (where, wrong), leastPeakVoltage (leastPeakVoltageToUse), reachableVelocity (reachableVelocityToUse)
{
}

Eigen::VectorXd voltageLimits (const ModalModel& model, const AllocationChoice& choice)
{
    Eigen::VectorXd limits (model.actuators());

    for (Eigen::Index i = 0; i < limits.size(); ++i)
    {
        const auto own = model.ceramics[static_cast<std::size_t> (i)].voltageLimit;
        limits[i] = std::min (own, choice.voltageLimit.value_or (own));
    }

    return limits;
}

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
