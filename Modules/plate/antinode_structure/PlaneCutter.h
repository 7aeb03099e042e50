#pragma once

#include <antinode_outline/Outline.h>

#include <vector>

namespace antinode
{
/** A rectangle along the axes. */
struct CellExtent
{
    double left = 0, right = 0, bottom = 0, top = 0;

    double area() const { return (right - left) * (top - bottom); }
};

/** Places within a part of a cell, to integrate over it: the integral of f is sum weights f (places). */
struct CellPoints
{
    std::vector<Eigen::Vector2d> places;
    std::vector<double> weights;      ///< All positive.
    std::vector<std::size_t> section; ///< Of each place: which of the sections.

    /** The combinations of patches that occur: whether a place lies on each. */
    std::vector<std::vector<bool>> sections;
};

/** Cuts cells by the outlines of a plate and of its patches. */
class PlaneCutter
{
public:
    /** @param plate, patches  must live as long as this */
    PlaneCutter (const Outline& plate, std::vector<const Outline*> patches);

    /** Whether any boundary passes through a cell. [any] */
    bool cuts (const CellExtent&) const;

    /** Points of the part of a cell that belongs to the plate, with all boundaries between them: exact for polynomials
       where these are straight, and to many digits where they are curved.
        @param degree  of the functions whose products are integrated, along either axis
        @param lines   further straight lines across which something is not smooth
        [worker] Docs/Theory.md, section 1.13. */
    CellPoints points (const CellExtent&, int degree, const std::vector<PathPiece>& lines) const;

private:
    std::vector<const Outline*> outlines; ///< The plate's first.
};

/** Whether a piece passes through the inside of a cell. [any] */
bool passesThrough (const PathPiece&, const CellExtent&);
} // namespace antinode
