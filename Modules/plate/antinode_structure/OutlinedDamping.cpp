#include "OutlinedDamping.h"

#include <antinode_numerics/GaussLegendre.h>

#include <cmath>

namespace antinode
{
namespace
{
/** Twice the energy that is lost of foundations: integral loss k w^2. */
Eigen::VectorXd lostInFoundations (const OutlinedPlate& plate, const OutlinedProblem& scaled, const OutlinedGrid& grid,
                                   const Eigen::MatrixXd& shapes)
{
    const auto ceramicPatches = scaled.ceramicOfPatch.size();
    Eigen::VectorXd losses = Eigen::VectorXd::Zero (shapes.rows());

    for (Eigen::Index p = 0; p < losses.size(); ++p)
    {
        if (! (grid.areas()[p] > 0))
            continue;

        losses[p] = scaled.problem.foundation * plate.foundationLoss;
        const auto& isOn = grid.patchesAt (p);

        for (std::size_t a = 0; a < plate.areas.size(); ++a)
            if (isOn[ceramicPatches + a])
                losses[p] += scaled.problem.patches[ceramicPatches + a].foundation * plate.areas[a].lossFactor;
    }

    if (! losses.any())
        return Eigen::VectorXd::Zero (shapes.cols());

    return shapes.cwiseAbs2().transpose() * losses.cwiseProduct (grid.areas());
}

/** The same of springs along a piece of the boundary. */
Eigen::VectorXd lostAlong (const PathPiece& piece, const EdgeSupport& support, const BendingModes& modes,
                           double waveNumber)
{
    constexpr int places = 8;
    const auto rule = gaussLegendre (places, 1);
    const auto parts = std::max (1, static_cast<int> (std::ceil (waveNumber * piece.length (piece.from, piece.to))));
    const auto step = (piece.to - piece.from) / parts;
    Eigen::MatrixX2d at (parts * places, 2), normals (parts * places, 2);
    Eigen::VectorXd weights (parts * places);

    for (int i = 0; i < parts * places; ++i)
    {
        const auto part = i / places;
        const auto t = piece.from + step * (part + rule.nodes[i % places]);
        const auto derivative = piece.derivative (t);
        at.row (i) = piece.at (t).transpose();
        normals.row (i) << derivative.y() / derivative.norm(), -derivative.x() / derivative.norm();
        weights[i] = std::abs (step) * derivative.norm() * rule.weights[i % places];
    }

    const auto& [space, eigenvalues, coefficients, participation, rigid] = modes;
    Eigen::VectorXd lost =
        support.translation * space.evaluate (at, coefficients, 0, 0).cwiseAbs2().transpose() * weights;

    if (support.rotation > 0)
    {
        const Eigen::MatrixXd slopes = normals.col (0).asDiagonal() * space.evaluate (at, coefficients, 1, 0)
                                       + normals.col (1).asDiagonal() * space.evaluate (at, coefficients, 0, 1);
        lost += support.rotation * slopes.cwiseAbs2().transpose() * weights;
    }

    return lost;
}
} // namespace

Eigen::VectorXd dampingOfSupports (const OutlinedPlate& plate, const OutlinedSolution& solution,
                                   const OutlinedGrid& grid, const Eigen::MatrixXd& shapes)
{
    const auto& scaled = solution.scaled;
    const auto& problem = scaled.problem;
    const auto omegas = solution.modes.eigenvalues.cwiseSqrt();
    Eigen::VectorXd lost = lostInFoundations (plate, scaled, grid, shapes);
    Eigen::VectorXd dashpots = Eigen::VectorXd::Zero (lost.size());

    for (const auto& path : problem.outline.paths)
        for (const auto& piece : path)
            if (const auto edge = static_cast<std::size_t> (piece.edge); plate.edges[edge].lossFactor > 0)
                lost += plate.edges[edge].lossFactor
                        * lostAlong (piece, problem.edges[edge], solution.modes, solution.waveNumber);

    for (std::size_t i = 0; i < plate.points.size(); ++i)
    {
        const auto row = shapes.rows() - static_cast<Eigen::Index> (plate.points.size() - i);
        const Eigen::VectorXd squares = shapes.row (row).cwiseAbs2().transpose();
        lost += plate.points[i].lossFactor * problem.points[i].stiffness * squares;
        dashpots += plate.points[i].damping * squares;
    }

    // A dashpot in units of the problem: mass per area times length squared times the unit of frequency.
    const auto unit = scaled.massPerArea * scaled.length * scaled.length * std::sqrt (scaled.eigenvalueUnit());
    return (lost.array() / omegas.array().square() + dashpots.array() / unit / omegas.array()) / 2;
}
} // namespace antinode
