#include "Brake.h"

#include "DesignRemarks.h"
#include "DriveGrid.h"
#include "Prediction.h"
#include "Transients.h"

#include <algorithm>

namespace antinode
{
namespace
{
AllocationProblem brakeProblem (const FocusDesign& design, const ModalModel& model,
                                const std::vector<std::vector<Oscillation>>& brakes)
{
    double end = 0;

    for (const auto& brake : brakes)
        end = std::max (end, brake.front().end);

    const auto count = static_cast<Eigen::Index> (brakes.size());
    AllocationProblem problem;
    problem.waveforms = sampleDrives (brakes, brakes.front().front().start, end);
    problem.participation = model.participation (design.controlledModes, Eigen::all);
    problem.rows = Eigen::MatrixXd::Identity (count, count);
    problem.wanted = Eigen::VectorXd::Ones (count);
    problem.voltageLimits = design.program.voltageLimits * gridLimitMargin();
    return problem;
}
} // namespace

void appendBrake (FocusDesign& design, const ModalModel& model)
{
    const auto time = design.program.focusTime + releaseDuration();
    const auto states = predictStates (model, design.program, time);
    const auto velocities = modalVelocities (model, states);
    const auto displacements = modalDisplacements (model, states);
    const auto decay = decayRates (model);
    const auto frequency = dampedFrequencies (model);
    std::vector<std::vector<Oscillation>> brakes;

    for (const auto mode : design.controlledModes)
        brakes.push_back ({ brakeMode (mode, decay[mode], frequency[mode], *design.description.transients.brake,
                                       displacements[mode], velocities[mode], time) });

    auto allocation = solveAllocation (brakeProblem (design, model, brakes), AllocationGoal::norm);

    if (allocation.certificate.status == AllocationStatus::infeasible)
    {
        const auto share = 1 / allocation.certificate.peakRatio;
        allocation.matrix *= share;
        design.warnings.push_back ("The voltage limit allows only " + inWords (100 * share)
                                   + " % of the brake: the field decays more slowly than asked for.");
    }

    const auto before = design.program.allocation.cols();
    design.program.allocation.conservativeResize (Eigen::NoChange, before + allocation.matrix.cols());
    design.program.allocation.rightCols (allocation.matrix.cols()) = allocation.matrix;

    for (const auto& brake : brakes)
        design.program.oscillations.push_back (brake.front());
}
} // namespace antinode
