#include "Projection.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_model/RigidMotion.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace antinode
{
namespace
{
/** Coefficients of the fit of a field by the given shapes, in the mass-weighted least-squares sense. */
Eigen::VectorXd fitted (const Eigen::MatrixXd& shapes, const Eigen::VectorXd& masses, const Eigen::VectorXd& field)
{
    const Eigen::VectorXd root = masses.cwiseSqrt();
    return leastSquares (root.asDiagonal() * shapes, root.cwiseProduct (field));
}

std::vector<int> drivableModes (const ModalModel& model, std::optional<int> among)
{
    Eigen::VectorXd strength = model.participation.topRows (model.modes()).rowwise().norm();

    if (model.hasComplexModes())
        for (Eigen::Index k = 0; k < strength.size(); ++k)
            strength[k] = std::hypot (strength[k], model.participation.row (strength.size() + k).norm());

    std::vector<int> modes;

    for (int k = suspensionModes (model); k < std::min<Eigen::Index> (strength.size(), among.value_or (model.modes()));
         ++k)
        if (strength[k] > 1e-9 * strength.maxCoeff())
            modes.push_back (k);

    if (modes.empty())
        throw InputError ("device '" + model.name + "'", "no ceramic excites any of its modes; at least one must");

    return modes;
}

void sortByEnergy (std::vector<int>& modes, const ModalModel& model, const ProjectedTarget& target)
{
    Eigen::VectorXd energies = target.modalVelocities.cwiseAbs2();

    // Of complex shapes some are nearly alike, under a finger for example: their coefficients would cancel each other.
    if (model.hasComplexModes())
        for (Eigen::Index k = 0; k < energies.size(); ++k)
        {
            const Eigen::VectorXd weighted = model.surface.masses.cwiseProduct (model.shapes.col (k));
            energies[k] = std::pow (weighted.dot (target.field), 2) / weighted.dot (model.shapes.col (k));
        }
    else if (! model.coversWholeBody)
        for (Eigen::Index k = 0; k < energies.size(); ++k)
            energies[k] *= model.surface.masses.dot (model.shapes.col (k).cwiseAbs2());

    std::stable_sort (modes.begin(), modes.end(), [&] (int a, int b) { return energies[a] > energies[b]; });
}

double capturedShare (double represented, const ProjectedTarget& target)
{
    return target.energy > 0 ? std::sqrt (std::min (represented / target.energy, 1.0)) : 0.0;
}

/** The energy of the part of a field that a growing set of shapes represents, mass-weighted least squares: each shape's
   part that is orthogonal to those before it adds its own. */
class FittedEnergy
{
public:
    FittedEnergy (const ModalModel& modelToUse, const ProjectedTarget& target, std::size_t maximumModes)
        : model (modelToUse), root (model.surface.masses.cwiseSqrt()), field (root.cwiseProduct (target.field)),
          basis (model.points(), std::min (model.points(), static_cast<Eigen::Index> (maximumModes)))
    {
    }

    double with (int mode)
    {
        Eigen::VectorXd rest = root.cwiseProduct (model.shapes.col (mode));
        const auto whole = rest.norm();
        const auto before = basis.leftCols (count);

        // Gram and Schmidt twice: once loses the orthogonality where shapes are nearly dependent.
        for (int pass = 0; pass < 2; ++pass)
            rest -= before * (before.transpose() * rest).eval();

        // What is left of a shape that depends on those before it is rounding, of no direction.
        if (count < basis.cols() && rest.norm() > 1e-12 * whole)
        {
            basis.col (count) = rest.normalized();
            const auto part = basis.col (count++).dot (field);
            represented += part * part;
        }

        return represented;
    }

private:
    const ModalModel& model;
    Eigen::VectorXd root, field;
    Eigen::MatrixXd basis;
    Eigen::Index count = 0;
    double represented = 0;
};

/** The energy that each prefix of a list of modes represents, up to the first prefix that reaches the wanted one. */
std::vector<double> carriedByPrefixes (const ModalModel& model, const ProjectedTarget& target,
                                       const std::vector<int>& modes, double wanted)
{
    std::vector<double> energies;
    std::optional<FittedEnergy> fitted;
    double represented = 0;

    if (! model.coversWholeBody)
        fitted.emplace (model, target, modes.size());

    for (const auto mode : modes)
    {
        const auto velocity = target.modalVelocities[mode];
        represented = fitted ? fitted->with (mode) : represented + velocity * velocity;
        energies.push_back (represented);

        if (capturedShare (represented, target) >= wanted)
            break;
    }

    return energies;
}

std::vector<int> modesForCapture (const ModalModel& model, const ProjectedTarget& target, std::vector<int> modes,
                                  double wanted, bool isDefault)
{
    // By default a device that moves as a rigid body, too, has as many modes as one that is short of their energy: few
    // modes beside many guards can be beyond what its drives keep apart.
    auto sought = target;
    sought.energy += isDefault ? target.rigidEnergy : 0;
    const auto energies = carriedByPrefixes (model, sought, modes, wanted);
    const auto best = capturedShare (energies.back(), target);

    if (best < wanted && ! isDefault)
        throw InputError ("focus: captured fraction", "is " + inWords (wanted) + "; allowed: up to " + inWords (best)
                                                          + ", which all " + std::to_string (modes.size())
                                                          + " modes together capture; or widen the target, or simulate "
                                                            "more modes");

    modes.resize (energies.size());
    return modes;
}
} // namespace

ProjectedTarget projectField (const ModalModel& model, const Eigen::VectorXd& field)
{
    ProjectedTarget target;
    target.field = field;
    target.modalVelocities =
        model.coversWholeBody ? Eigen::VectorXd (model.shapes.transpose() * model.surface.masses.cwiseProduct (field))
                              : fitted (model.shapes.leftCols (model.modes()), model.surface.masses, field);
    target.rigidEnergy = rigidEnergy (model, field, target.modalVelocities);
    target.energy = std::max (0.0, model.surface.masses.dot (field.cwiseAbs2()) - target.rigidEnergy);
    return target;
}

ModeSelection restrictToModes (const ModalModel& model, const ProjectedTarget& target, std::vector<int> modes)
{
    std::sort (modes.begin(), modes.end());
    ModeSelection selection;
    selection.wanted = model.coversWholeBody
                           ? Eigen::VectorXd (target.modalVelocities (modes))
                           : fitted (model.shapes (Eigen::all, modes), model.surface.masses, target.field);
    selection.truncated = Eigen::VectorXd::Zero (model.points());

    for (std::size_t i = 0; i < modes.size(); ++i)
        selection.truncated += selection.wanted[static_cast<Eigen::Index> (i)] * model.shapes.col (modes[i]);

    selection.captured =
        capturedShare (model.coversWholeBody ? selection.wanted.squaredNorm()
                                             : model.surface.masses.dot (selection.truncated.cwiseAbs2()),
                       target);
    selection.modes = std::move (modes);
    return selection;
}

ModeSelection selectModes (const ModalModel& model, const ProjectedTarget& target, const ModeChoice& choice)
{
    auto modes = drivableModes (model, choice.among);

    if (choice.maximumFrequency)
    {
        std::erase_if (modes, [&] (int k) { return model.frequencyHz (k) > *choice.maximumFrequency; });

        if (modes.empty())
            throw InputError ("focus: maximum frequency",
                              "is " + inWords (*choice.maximumFrequency) + " Hz; allowed: at least "
                                  + inWords (model.frequencyHz (0)) + " Hz, the lowest mode of '" + model.name + "'");

        return restrictToModes (model, target, modes);
    }

    if (choice.order == ModeOrder::energy)
        sortByEnergy (modes, model, target);

    // Nobody knows what shapes do between points that are far apart: such modes are controlled where somebody asks.
    if (! choice.count && ! choice.captured)
        if (const auto hidden =
                std::stable_partition (modes.begin(), modes.end(), [&] (int k) { return k < resolvedModes (model); });
            hidden != modes.begin())
            modes.erase (hidden, modes.end());

    if (! choice.count)
        return restrictToModes (model, target,
                                modesForCapture (model, target, modes, choice.captured.value_or (defaultCapture()),
                                                 ! choice.captured.has_value()));

    if (*choice.count > static_cast<int> (modes.size()))
        throw InputError ("focus: number of modes", "is " + std::to_string (*choice.count) + "; allowed: 1 to "
                                                        + std::to_string (modes.size()) + ", the simulated modes of '"
                                                        + model.name + "' that its ceramics excite");

    modes.resize (static_cast<std::size_t> (*choice.count));
    return restrictToModes (model, target, modes);
}

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
