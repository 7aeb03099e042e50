#include "RigidMotion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
bool isFree (const ModalModel& model)
{
    const auto source = model.origin.source;

    if (model.rigidBodyModes > 0 || source == ModeSource::drawn || source == ModeSource::retuned)
        return model.rigidBodyModes > 0;

    return model.surface.kind == SurfaceKind::plate && model.surface.boundary && model.surface.boundary->held.empty();
}

/** Whether the points stand for all of the body, with its mass: of measured ones an outline says where it ends. */
bool standsForWholeBody (const ModalModel& model)
{
    return model.coversWholeBody || (model.origin.source == ModeSource::measured && model.surface.boundary);
}

/** Translation and turns, points x at most 2 or 3, orthonormal by mass; without those that the points do not show, as
   of a row of points a turn about it. */
Eigen::MatrixXd rigidShapes (const Surface& surface)
{
    const auto& masses = surface.masses;
    const auto isLine = surface.kind == SurfaceKind::line;
    Eigen::MatrixXd shapes (surface.points.rows(), isLine ? 2 : 3);
    shapes.col (0).setOnes();
    shapes.rightCols (shapes.cols() - 1) = surface.points.leftCols (shapes.cols() - 1);
    Eigen::Index count = 0;

    for (Eigen::Index k = 0; k < shapes.cols(); ++k)
    {
        Eigen::VectorXd shape = shapes.col (k);
        const auto whole = shape.cwiseAbs2().dot (masses);

        for (Eigen::Index j = 0; j < count; ++j)
            shape -= shapes.col (j) * shapes.col (j).dot (masses.cwiseProduct (shape));

        if (const auto rest = shape.cwiseAbs2().dot (masses); rest > 1e-12 * whole)
            shapes.col (count++) = shape / std::sqrt (rest);
    }

    return shapes.leftCols (count);
}

/** Those that no mode of the device has already: those of a drawn suspension are modes. */
std::vector<Eigen::Index> missing (const ModalModel& model, const Eigen::MatrixXd& rigid)
{
    constexpr double mostlyThere = 0.5;
    const Eigen::MatrixXd there = model.shapes.transpose() * model.surface.masses.asDiagonal() * rigid;
    std::vector<Eigen::Index> columns;

    for (Eigen::Index k = 0; k < rigid.cols(); ++k)
        if (there.col (k).squaredNorm() < mostlyThere)
            columns.push_back (k);

    return columns;
}

template <typename Matrix>
Matrix below (const Matrix& first, const Matrix& then)
{
    Matrix all (first.rows() + then.rows(), then.cols());
    all << first, then;
    return all;
}

Eigen::MatrixXd beside (const Eigen::MatrixXd& first, const Eigen::MatrixXd& then)
{
    Eigen::MatrixXd all (then.rows(), first.cols() + then.cols());
    all << first, then;
    return all;
}

/** d/dx of shapes that are planes. */
Eigen::MatrixXd slopesOf (const Surface& surface, const Eigen::MatrixXd& planes)
{
    const auto last = surface.points.rows() - 1;
    const auto length = surface.points (last, 0) - surface.points (0, 0);
    return ((planes.row (last) - planes.row (0)) / length).replicate (planes.rows(), 1);
}
} // namespace

ModalModel withRigidMotion (ModalModel model)
{
    if (model.hasComplexModes() || ! standsForWholeBody (model) || ! model.origin.scaleIsKnown || ! isFree (model))
        return model;

    const auto all = rigidShapes (model.surface);
    const auto columns = missing (model, all);

    if (columns.empty())
        return model;

    // What is free hardly moves against the air: far below all that is played, and damped.
    constexpr double slow = 2 * std::numbers::pi, damped = 0.5; // rad/s
    const auto count = static_cast<Eigen::Index> (columns.size());
    const Eigen::MatrixXd rigid = all (Eigen::all, columns);
    const auto frequency = std::min (slow, model.angularFrequencies[0] / 10);
    model.angularFrequencies =
        below<Eigen::VectorXd> (Eigen::VectorXd::Constant (count, frequency), model.angularFrequencies);
    model.dampingRatios = below<Eigen::VectorXd> (Eigen::VectorXd::Constant (count, damped), model.dampingRatios);
    model.participation =
        below<Eigen::MatrixXd> (Eigen::MatrixXd::Zero (count, model.actuators()), model.participation);
    model.shapes = beside (rigid, model.shapes);

    if (model.slopes.size() > 0)
        model.slopes = beside (slopesOf (model.surface, rigid), model.slopes);

    if (model.frequencyErrors.size() > 0)
        model.frequencyErrors = below<Eigen::VectorXd> (Eigen::VectorXd::Zero (count), model.frequencyErrors);

    model.rigidBodyModes = 0;
    return model;
}

int suspensionModes (const ModalModel& model)
{
    constexpr double plane = 0.995;
    constexpr Eigen::Index fewestPoints = 12; // Through few points any shape is a plane.

    if (model.points() < fewestPoints || model.hasComplexModes() || ! model.coversWholeBody)
        return 0;

    const auto rigid = rigidShapes (model.surface);
    const auto& masses = model.surface.masses;
    int count = 0;

    for (const auto most = std::min (rigid.cols(), model.modes()); count < most; ++count)
    {
        const Eigen::VectorXd weighted = masses.cwiseProduct (model.shapes.col (count));

        if ((rigid.transpose() * weighted).squaredNorm() < plane * weighted.dot (model.shapes.col (count)))
            break;
    }

    return count;
}

double rigidEnergy (const ModalModel& model, const Eigen::VectorXd& field, const Eigen::VectorXd& modalVelocities)
{
    if (model.hasComplexModes() || ! standsForWholeBody (model) || ! model.origin.scaleIsKnown)
        return 0;

    const auto suspended = suspensionModes (model);

    if (suspended == 0 && ! isFree (model))
        return 0;

    // What bends takes nothing of it, also where one edge is held and only one motion is free.
    const auto bending = modalVelocities.size() - suspended;
    const Eigen::VectorXd rest = field - model.shapes.middleCols (suspended, bending) * modalVelocities.tail (bending);
    return (rigidShapes (model.surface).transpose() * model.surface.masses.cwiseProduct (rest)).squaredNorm();
}
} // namespace antinode
