#pragma once

#include "ShapeInterpolation.h"

#include <antinode_outline/Outline.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The arrangement of the points of a surface. */
enum class SurfaceKind
{
    line, ///< A beam's top: y = 0, x ascending.
    plate ///< Any points in the plane.
};

/** Edges at which the surface cannot move: targets are tapered there. Of a line only left and right count. */
struct HeldEdges
{
    bool left = true, right = true, bottom = true, top = true;
};

/** The boundary of a plate that does not fill its extent, or is held along parts of its sides. m */
struct SurfaceBoundary
{
    Outline outline;
    std::vector<PathPiece> held; ///< The parts of it at which the surface cannot move: targets are tapered there.
};

/** The part of a device that is touched, as points on which mode shapes and fields are given. N_p points. */
struct Surface
{
    SurfaceKind kind = SurfaceKind::line;
    double xMinimum = 0, xMaximum = 0; ///< Extent, m.
    double yMinimum = 0, yMaximum = 0; ///< Extent, m; both 0 on a line.
    Eigen::MatrixX2d points;           ///< N_p x 2: x and y, m. On a line ascending in x.
    Eigen::VectorXd masses; ///< N_p: mass each point stands for, kg; sum m phi_k phi_l is the Gram matrix of the part.
    Eigen::VectorXd areas;  ///< N_p: share of the surface each point stands for, m^2 (any common factor). Those with
                            ///< none only carry the grid, or a mass at a point; they may lie outside the boundary.
    std::optional<PlateGrid> grid; ///< Of a computed plate: its first points are the product of two axes.
    HeldEdges held;                ///< All of them where it is not known. Where there is a boundary, it says it.
    std::optional<SurfaceBoundary> boundary; ///< None: the surface is its extent.
};

/** Whether a place lies on a surface, its edges included. y is ignored on a line. [any] */
bool liesOn (const Surface&, double x, double y);

/** Where a place does not lie on a surface, the nearest one that does, else the place itself. [any] */
Eigen::Vector2d nearestOn (const Surface&, double x, double y);

/** Refuses a place within the extent of a surface that lies outside its boundary or in a hole.
    @param where  how errors name the place
    @throws InputError  one sentence [any] */
void requireWithinBoundary (const Surface&, double x, double y, const std::string& where);

/** The indices of the points that stand for a part of the surface. [any] */
std::vector<Eigen::Index> pointsOn (const Surface&);

/** Puts a surface on a grid: points, areas and extent. Masses are made as many, and left to be given. [any] */
void placeOnGrid (Surface&, const PlateGrid&);

/** A plate of given points that ends at a boundary, to which it then extends.
    @throws InputError  where the points are a line, or one lies outside the boundary or in a hole by more than a
    thousandth of the extent [worker] */
Surface boundedBy (Surface, SurfaceBoundary);

/** Where a plate ends: its boundary, or the rectangle of its extent with the edges at which it is held. None of a line.
    [any] */
std::optional<SurfaceBoundary> boundaryOf (const Surface&);

/** Refuses a y other than 0 where the surface is a line.
    @param where  how errors name the coordinate
    @throws InputError  one sentence [any] */
void requireOnLine (const Surface&, double y, const std::string& where);

/** Refuses a place that is not on a surface: beyond its extent, beside a line, in a hole.
    @param where  how errors name the place: "focus: target 1"
    @throws InputError  one sentence, with the places that are allowed [any] */
void requireOnSurface (const Surface&, double x, double y, const std::string& where);

/** The extent of a surface in a grid of cells that are about square, row by row from below. */
struct SquareCells
{
    Eigen::Index columns = 0, rows = 0; ///< One row on a line.
    Eigen::MatrixX2d centres;           ///< columns * rows x 2: x and y, m; outside the boundary, too.
};

/** @param about  how many cells, roughly on a plate, exactly on a line; at least 1
    [any] */
SquareCells squareCells (const Surface&, int about);
} // namespace antinode
