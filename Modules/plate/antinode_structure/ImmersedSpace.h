#pragma once

#include "BendingProblem.h"
#include "PlaneCutter.h"

#include <antinode_numerics/BlockBandedMatrix.h>
#include <antinode_numerics/SplineAxis.h>

namespace antinode
{
/** Where a cell lies. */
enum class CellKind
{
    outside,
    whole, ///< All of it on the plate, with no boundary within, and no functions but splines.
    cut
};

/** A cell that has a part of the plate. */
struct ImmersedCell
{
    Eigen::Index column = 0, row = 0; ///< Along x, along y.
    CellKind kind = CellKind::whole;
    CellPoints points {}; ///< Of a cut one; of a whole one a single place.
};

/** Functions that resolve a kink: its function, squared where it is positive, times each spline near it. */
struct KinkFamily
{
    std::size_t patch = 0;
    KinkFunction kink;
    std::vector<PathPiece> lines;        ///< A straight kink beyond the edge that it belongs to.
    std::vector<Eigen::Index> unknownOf; ///< Of every product of splines; -1: none.
};

/** Tensor products of splines on cells that are laid over a plate: those that live on it are the unknowns, and with
   them the functions of kinks. Docs/Theory.md, section 1.13. */
class ImmersedSpace
{
public:
    /** @param problem  must live as long as this
        [worker] */
    ImmersedSpace (const BendingProblem& problem, const SplineBreaks& x, const SplineBreaks& y, int degree);

    const SplineAxis& x() const { return axisX; }
    const SplineAxis& y() const { return axisY; }
    const std::vector<ImmersedCell>& cells() const { return activeCells; }
    CellExtent extent (Eigen::Index column, Eigen::Index row) const;
    Eigen::Index unknowns() const { return count; }

    /** A matrix of zeros for all pairs of functions that share a cell. [worker] */
    BlockBandedMatrix zeroMatrix() const;

    /** The active cell that holds a place, or nullptr. [any] */
    const ImmersedCell* cellAt (double xPlace, double yPlace) const;

    /** The active cell beside a place on the boundary, which may lie on a line between cells; or nullptr. [any] */
    const ImmersedCell* cellNear (double xPlace, double yPlace) const;

    /** The coefficients of c + a x + b y: unknowns x 1. [any] */
    Eigen::VectorXd plane (double c, double a, double b) const;

    /** Fields at places on the plate, on its boundary too.
        @param coefficients  unknowns x N
        @param dx, dy        derivatives along x and y
        @return              places x N
        [worker] */
    Eigen::MatrixXd evaluate (const Eigen::MatrixX2d& places, const Eigen::MatrixXd& coefficients, int dx,
                              int dy) const;

private:
    friend class CellFunctions;

    void findCells (const BendingProblem&);
    void findKinks (const BendingProblem&);
    std::vector<double> squares (const KinkFamily*) const;
    std::vector<bool> productsOnHeldEdges (const BendingProblem&) const;
    void numberUnknowns (const BendingProblem&);

    /** Calls a function for every product of splines on a cell. */
    template <typename Function>
    void forProducts (const ImmersedCell& cell, const Function& function) const
    {
        const auto column = static_cast<std::size_t> (cell.column), row = static_cast<std::size_t> (cell.row);

        for (Eigen::Index j = 0; j < countY[row]; ++j)
            for (Eigen::Index i = 0; i < countX[column]; ++i)
                function (static_cast<std::size_t> (tensorIndex (firstX[column] + i, firstY[row] + j)));
    }

    bool livesOn (const KinkFamily&, const ImmersedCell&) const;
    Eigen::Index tensorIndex (Eigen::Index ofX, Eigen::Index ofY) const { return ofX + ofY * axisX.size(); }

    SplineAxis axisX, axisY;
    std::vector<Eigen::Index> firstX, countX, firstY, countY; ///< Of each cell: its splines.
    std::vector<ImmersedCell> activeCells;
    std::vector<Eigen::Index> cellNumber; ///< Of every cell: its place among the active ones; -1: outside.
    std::vector<Eigen::Index> unknownOf;  ///< Of every product of splines; -1: none.
    std::vector<KinkFamily> families;
    std::vector<Eigen::Index> blockSizes;
    bool outerIsX = true;
    Eigen::Index count = 0;
};

/** The functions that live on a cell, at places of it. */
class CellFunctions
{
public:
    /** @param highest  derivative that is asked for, along one axis
        [worker] */
    CellFunctions (const ImmersedSpace&, const ImmersedCell&, const std::vector<Eigen::Vector2d>& places, int highest);

    const std::vector<Eigen::Index>& unknowns() const { return numbers; }

    /** places x functions: a derivative. [worker] */
    Eigen::MatrixXd derivative (int dx, int dy) const;

    /** The same, written into a matrix of that size. [worker] */
    void writeDerivative (int dx, int dy, Eigen::Ref<Eigen::MatrixXd> result) const;

private:
    /** An unknown as a product of splines, by their numbers on the cell, and of a kink's function. */
    struct Member
    {
        Eigen::Index ofX = 0, ofY = 0;
        const KinkFunction* kink = nullptr;
    };

    Eigen::VectorXd kinkDerivative (const KinkFunction&, int dx, int dy) const;

    std::vector<Eigen::Vector2d> places;
    std::vector<Eigen::MatrixXd> alongX, alongY; ///< Of each derivative: places x splines.
    std::vector<Member> members;
    std::vector<Eigen::Index> numbers;
};
} // namespace antinode
