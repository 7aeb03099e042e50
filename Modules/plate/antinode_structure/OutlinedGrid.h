#pragma once

#include "OutlinedProblem.h"

#include <antinode_model/ShapeInterpolation.h>

namespace antinode
{
/** A grid over the extent of an outlined plate, and places in the cells of it that a boundary crosses, with weights by
   which fields are integrated exactly. In units of the problem. Docs/Theory.md, section 1.13. */
class OutlinedGrid
{
public:
    /** @param problem     must live as long as this
        @param waveNumber  of the shortest waves that fields have
        @param accuracy    coarse: few places where only edges of patches cross a cell
        [worker] */
    OutlinedGrid (const BendingProblem& problem, double waveNumber, ModeAccuracy accuracy = ModeAccuracy::usual);

    const GridAxis& x() const { return axisX; }
    const GridAxis& y() const { return axisY; }

    /** N_p x 2: the product of both axes, then the places in cells that are crossed, then the points of the problem. */
    const Eigen::MatrixX2d& points() const { return places; }

    /** N_p: the area that each point stands for; 0 where it only carries the grid, or a mass. */
    const Eigen::VectorXd& areas() const { return weights; }

    /** N_p: the mass that each point stands for. [worker] */
    Eigen::VectorXd masses() const;

    /** Of a point: which of the problem's patches it lies on. [any] */
    const std::vector<bool>& patchesAt (Eigen::Index point) const
    {
        return sections[sectionOf[static_cast<std::size_t> (point)]];
    }

    /** The shapes of modes at all points, N_p x N. Off the plate they are what the polynomial of a cut cell gives,
       bounded, and 0 in cells without any of the plate. [worker] */
    Eigen::MatrixXd shapes (const BendingModes&) const;

private:
    /** A cell of the grid that the plate's own boundary crosses: a part of its places lies outside. */
    struct CutCell
    {
        Eigen::Index column = 0, row = 0;
        Eigen::Index first = 0, count = 0; ///< Its own places, among the points.
    };

    void addCells (ModeAccuracy);
    Eigen::Index gridRow (Eigen::Index i, Eigen::Index j) const { return i + j * axisX.places.size(); }
    std::size_t numberOf (const std::vector<bool>& section);
    void extend (Eigen::MatrixXd& shapes, const CutCell&) const;

    const BendingProblem& problem;
    double waveNumber;
    GridAxis axisX, axisY;
    Eigen::MatrixX2d places;
    Eigen::VectorXd weights;
    std::vector<std::vector<bool>> sections;
    std::vector<std::size_t> sectionOf;
    std::vector<Eigen::Index> onPlate; ///< The points whose shapes follow from the modes.
    std::vector<CutCell> cutCells;
};

/** What the losses of supports add to the damping ratio of each mode: half the loss factor times their share of its
   energy, and of dashpots c phi^2 / (2 omega). N_m
    @param shapes  of the modes at the points of the grid, in units of the problem
    [worker] Docs/Theory.md, section 1.13. */
Eigen::VectorXd dampingOfSupports (const OutlinedPlate&, const OutlinedSolution&, const OutlinedGrid&,
                                   const Eigen::MatrixXd& shapes);
} // namespace antinode
