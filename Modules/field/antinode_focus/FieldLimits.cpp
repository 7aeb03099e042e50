#include "FieldLimits.h"

#include <antinode_base/NumberText.h>
#include <antinode_model/RigidMotion.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double blindParticipation = 1e-9; // of the largest, as modes are chosen
constexpr int maximumPlateModes = 500;

std::string percent (double energy)
{
    return inWords (100 * std::sqrt (energy)) + " %";
}

std::string beyondInWords (const ModalModel& model, const FocusDesign& design, double energy)
{
    const auto count = std::to_string (model.modes());
    auto sentence = "Modes limit the field: all " + count + " of the device leave out " + percent (energy)
                    + " of it (square root of energy). ";

    if (model.unknowns == 0)
        return sentence + "They are measured: identify higher ones, or widen focus.targets.0.width_mm.";

    if (model.modes() < maximumPlateModes)
        sentence += "Set device.modes.count above " + count + ", ";

    if (! design.description.edgeWindow)
        sentence += "taper the field at held edges by focus.edge_window.tukey, ";

    return sentence + "or widen focus.targets.0.width_mm.";
}
} // namespace

CaptureLosses captureLosses (const ModalModel& model, const FocusDesign& design, const FocusMoment& moment)
{
    CaptureLosses losses;
    const auto missing = std::max (0.0, 1 - moment.captured * moment.captured);
    const Eigen::VectorXd strength = model.participation.cwiseAbs().rowwise().maxCoeff();
    double inModes = 0;

    // Shapes that are not orthogonal on a part of the body do not share energies.
    if (model.coversWholeBody)
        for (Eigen::Index k = suspensionModes (model); k < model.modes(); ++k)
        {
            if (std::binary_search (design.controlledModes.begin(), design.controlledModes.end(), static_cast<int> (k)))
                continue;

            const auto energy = std::pow (moment.target.modalVelocities[k], 2) / moment.target.energy;
            (strength[k] > blindParticipation * strength.maxCoeff() ? losses.uncontrolled : losses.blind) += energy;
            inModes += energy;
        }
    else if (design.controlledModes.size() < static_cast<std::size_t> (model.modes()))
        inModes = losses.uncontrolled = missing;

    losses.beyond = std::max (0.0, missing - inModes);
    return losses;
}

std::string lossInWords (const ModalModel& model, const FocusDesign& design, const FocusMoment& moment)
{
    const auto losses = captureLosses (model, design, moment);
    const auto largest = std::max ({ losses.uncontrolled, losses.blind, losses.beyond });

    if (losses.uncontrolled == largest)
        return "Modes limit the field: the " + std::to_string (design.controlledModes.size()) + " controlled of "
               + std::to_string (model.modes()) + " leave out " + percent (losses.uncontrolled)
               + " of it (square root of energy) that others have. Raise focus.modes.captured or focus.modes.count.";

    if (losses.blind == largest)
        return "Ceramics limit the field: modes that none of them moves have " + percent (losses.blind)
               + " of it (square root of energy). Move device.ceramics; 'antinode place' finds positions.";

    return beyondInWords (model, design, losses.beyond);
}

std::string transientInWords (const FocusDesign& design, const FocusMoment& moment,
                              const Eigen::VectorXd& modalVelocities, double error)
{
    const Eigen::VectorXd reached = modalVelocities (design.controlledModes);
    const auto missed = (reached - moment.wanted).squaredNorm();
    const auto uncontrolled = modalVelocities.squaredNorm() - reached.squaredNorm();
    const auto percentOfError = inWords (100 * error) + " % of error";

    if (uncontrolled >= missed)
        return "Time limits the field: " + inWords (moment.time * 1000)
               + " ms after the trigger, modes that are not controlled still move and add " + percentOfError
               + ". Raise focus.focus_time_ms, or control more modes by focus.modes.count.";

    if (design.description.allocation.robust)
        return "Robustness limits the field on the device as described: it costs " + percentOfError
               + ". Lower focus.allocation.robust.weight.";

    return "The allocation limits the field: controlled modes miss their velocities, " + percentOfError
           + ". Set focus.allocation.method to exact.";
}
} // namespace antinode
