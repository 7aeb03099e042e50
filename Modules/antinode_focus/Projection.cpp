#include "Projection.h"

#include <antinode_model/InputError.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double defaultCapture = 0.99;

/** Coefficients of the fit of a field by the given shapes, in the mass-weighted least-squares sense. */
Eigen::VectorXd leastSquares (const Eigen::MatrixXd& shapes, const Eigen::VectorXd& masses,
                              const Eigen::VectorXd& field)
{
    const Eigen::VectorXd root = masses.cwiseSqrt();
    return (root.asDiagonal() * shapes).completeOrthogonalDecomposition().solve (root.cwiseProduct (field));
}

std::vector<int> drivableModes (const ModalModel& model)
{
    const Eigen::VectorXd strength = model.participation.rowwise().norm();
    std::vector<int> modes;

    for (int k = 0; k < strength.size(); ++k)
        if (strength[k] > 1e-9 * strength.maxCoeff())
            modes.push_back (k);

    if (modes.empty())
        throw InputError ("device '" + model.name + "'", "no ceramic moves any of its modes, at least one must");

    return modes;
}

void sortByEnergy (std::vector<int>& modes, const ModalModel& model, const ProjectedTarget& target)
{
    const Eigen::VectorXd norms = model.shapes.cwiseAbs2().transpose() * model.surface.masses;
    const auto energy = [&] (int k)
    { return (model.coversWholeBody ? 1.0 : norms[k]) * target.modalVelocities[k] * target.modalVelocities[k]; };
    std::stable_sort (modes.begin(), modes.end(), [&] (int a, int b) { return energy (a) > energy (b); });
}

std::vector<int> modesForCapture (const ModalModel& model, const ProjectedTarget& target, std::vector<int> modes,
                                  double wanted, bool isDefault)
{
    double best = 0;

    for (std::size_t count = 1; count <= modes.size(); ++count)
    {
        std::vector<int> chosen (modes.begin(), modes.begin() + static_cast<std::ptrdiff_t> (count));
        best = restrictToModes (model, target, chosen).captured;

        if (best >= wanted)
            return chosen;
    }

    if (isDefault)
        return modes;

    throw InputError ("focus: /modes/captured", "is " + std::to_string (wanted) + ", but all "
                                                    + std::to_string (modes.size()) + " modes together capture "
                                                    + std::to_string (best)
                                                    + ": ask for less, widen the target, or simulate more modes");
}
} // namespace

ProjectedTarget projectField (const ModalModel& model, const Eigen::VectorXd& field)
{
    ProjectedTarget target;
    target.field = field;
    target.energy = model.surface.masses.dot (field.cwiseAbs2());
    target.modalVelocities =
        model.coversWholeBody ? Eigen::VectorXd (model.shapes.transpose() * model.surface.masses.cwiseProduct (field))
                              : leastSquares (model.shapes, model.surface.masses, field);
    return target;
}

ModeSelection restrictToModes (const ModalModel& model, const ProjectedTarget& target, std::vector<int> modes)
{
    std::sort (modes.begin(), modes.end());
    const Eigen::MatrixXd shapes = model.shapes (Eigen::all, modes);
    ModeSelection selection;
    double carried = 0;

    if (model.coversWholeBody)
    {
        selection.wanted = target.modalVelocities (modes);
        carried = selection.wanted.squaredNorm();
    }
    else
    {
        selection.wanted = leastSquares (shapes, model.surface.masses, target.field);
        carried = model.surface.masses.dot ((shapes * selection.wanted).cwiseAbs2());
    }

    selection.truncated = shapes * selection.wanted;
    selection.captured = target.energy > 0 ? std::sqrt (std::min (carried / target.energy, 1.0)) : 0.0;
    selection.modes = std::move (modes);
    return selection;
}

ModeSelection selectModes (const ModalModel& model, const ProjectedTarget& target, const ModeChoice& choice)
{
    auto modes = drivableModes (model);

    if (choice.maximumFrequency)
    {
        std::erase_if (modes, [&] (int k) { return model.frequencyHz (k) > *choice.maximumFrequency; });

        if (modes.empty())
            throw InputError ("focus: /modes/maximum_frequency_Hz",
                              "is " + std::to_string (*choice.maximumFrequency) + ", but the lowest mode of '"
                                  + model.name + "' is at " + std::to_string (model.frequencyHz (0)) + " Hz");

        return restrictToModes (model, target, modes);
    }

    if (choice.order == ModeOrder::energy)
        sortByEnergy (modes, model, target);

    if (! choice.count)
        return restrictToModes (model, target,
                                modesForCapture (model, target, modes, choice.captured.value_or (defaultCapture),
                                                 ! choice.captured.has_value()));

    if (*choice.count > static_cast<int> (modes.size()))
        throw InputError ("focus: /modes/count", "is " + std::to_string (*choice.count) + ", but '" + model.name
                                                     + "' has " + std::to_string (modes.size())
                                                     + " simulated modes that its ceramics move: allowed is 1 to that");

    modes.resize (static_cast<std::size_t> (*choice.count));
    return restrictToModes (model, target, modes);
}
} // namespace antinode
