#include "PlateModel.h"

#include <utility>

namespace antinode
{
namespace
{
constexpr double smallestMotion = 1e-200;

/** Sets what is too small to matter to 0: denormal numbers cost a hundred times the time of others. */
template <typename Values>
void dropDenormals (Values&& values)
{
    values = (values.abs() < smallestMotion).select (0.0, values);
}
} // namespace

PlateModel::PlateModel (const ModalModel& model, Playback playback, Eigen::MatrixXd shapes)
    : recursion (modalRecursion (model, playback)), participation (model.participation),
      probeShapes (std::move (shapes)), dampedFrequency (dampedFrequencies (model)),
      decayPerTurn (decayRates (model).array() / dampedFrequency), turned (model.modes()),
      forces (participation.rows(), 2 * recursion.tapsReal.cols())
{
    requirePlayable (model, probeShapes);
    reset();
}

void PlateModel::reset()
{
    stateReal.setZero (turned.size());
    stateImaginary.setZero (turned.size());
    velocity.setZero (forces.rows());
    displacement.setZero (forces.rows());
    forces.setZero();
    newest = 0;
}

void PlateModel::pushForces (const Eigen::Ref<const Eigen::VectorXd>& voltages)
{
    const auto length = recursion.tapsReal.cols();
    newest = (newest + 1) % length;
    auto force = forces.col (newest);
    force.setZero();

    // Column by column: every force is added up in the same order, whatever the alignment of the voltages.
    for (Eigen::Index ceramic = 0; ceramic < participation.cols(); ++ceramic)
        force += participation.col (ceramic).array() * voltages[ceramic];

    dropDenormals (force);
    forces.col (newest + length) = force;
}

void PlateModel::advance (const Eigen::Ref<const Eigen::VectorXd>& voltages)
{
    pushForces (voltages);
    turned = recursion.transitionReal * stateReal - recursion.transitionImaginary * stateImaginary;
    stateImaginary = recursion.transitionReal * stateImaginary + recursion.transitionImaginary * stateReal;
    stateReal.swap (turned);

    for (Eigen::Index tap = 0; tap < recursion.tapsReal.cols(); ++tap)
    {
        const auto force = forces.col (newest + 1 + tap).head (turned.size());
        stateReal += recursion.tapsReal.col (tap) * force;
        stateImaginary += recursion.tapsImaginary.col (tap) * force;
    }

    if (forces.rows() > turned.size())
        addTurned();

    dropDenormals (stateReal);
    dropDenormals (stateImaginary);
    velocity.head (turned.size()).array() = stateReal - decayPerTurn * stateImaginary;

    if (forces.rows() > turned.size())
        velocity.tail (turned.size()).array() = -stateImaginary - decayPerTurn * stateReal;
}

/** Adds what the imaginary parts of the forces on complex modes do. */
void PlateModel::addTurned()
{
    for (Eigen::Index tap = 0; tap < recursion.tapsReal.cols(); ++tap)
    {
        const auto force = forces.col (newest + 1 + tap).tail (turned.size());
        stateReal -= recursion.tapsImaginary.col (tap) * force;
        stateImaginary += recursion.tapsReal.col (tap) * force;
    }
}

void PlateModel::takeDisplacements()
{
    displacement.head (turned.size()).array() = stateImaginary / dampedFrequency;

    if (forces.rows() > turned.size())
        displacement.tail (turned.size()).array() = stateReal / dampedFrequency;
}

void PlateModel::process (Eigen::Ref<const Eigen::MatrixXd> voltages, Eigen::Ref<Eigen::MatrixXd> velocities)
{
    for (Eigen::Index n = 0; n < voltages.cols(); ++n)
    {
        advance (voltages.col (n));
        velocities.col (n).setZero();

        for (Eigen::Index k = 0; k < velocity.size(); ++k)
            velocities.col (n) += probeShapes.col (k) * velocity[k];
    }

    takeDisplacements();
}

void PlateModel::processModes (Eigen::Ref<const Eigen::MatrixXd> voltages, Eigen::Ref<Eigen::MatrixXd> velocities)
{
    for (Eigen::Index n = 0; n < voltages.cols(); ++n)
    {
        advance (voltages.col (n));
        velocities.col (n) = velocity;
    }

    takeDisplacements();
}
} // namespace antinode
