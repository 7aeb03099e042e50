#include "SmallFeatures.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
void add (SmallCellsOfAxes& small, const Eigen::Vector2d& place, SmallCells cells)
{
    cells.place = place.x();
    small.alongX.push_back (cells);
    cells.place = place.y();
    small.alongY.push_back (cells);
}

/** The angle by which a path turns from a piece to the next one, positive where it turns away from the plate. */
double reentrantTurn (const PathPiece& before, const PathPiece& after, double turn)
{
    const auto direction = [] (const PathPiece& piece, double t) -> Eigen::Vector2d
    { return (piece.to < piece.from ? -1 : 1) * piece.derivative (t).normalized(); };
    const auto in = direction (before, before.to), out = direction (after, after.from);
    return -turn * std::atan2 (in.x() * out.y() - in.y() * out.x(), in.dot (out));
}

bool areAlike (const EdgeSupport& a, const EdgeSupport& b)
{
    return a.holdsDisplacement == b.holdsDisplacement && a.holdsSlope == b.holdsSlope;
}

/** The curvature at the start or end of a piece, by which its path turns there; positive to the left. */
double curvatureAt (const PathPiece& piece, double t)
{
    if (piece.isStraight)
        return 0;

    const auto orientation = piece.cosine.x() * piece.sine.y() - piece.cosine.y() * piece.sine.x();
    return (piece.to < piece.from ? -1 : 1) * orientation / std::pow (piece.derivative (t).norm(), 3);
}

/** Lines with cells that shrink towards them where moments are unbounded: through re-entrant corners and where a smooth
   edge is held in another way from there on only the slope is continuous; other corners at which that changes need
   less. Held edges of very small cells would cost digits. */
void addCorners (SmallCellsOfAxes& small, const BendingProblem& problem, const ImmersedResolution& resolution)
{
    constexpr double corner = 0.05; // rad
    const auto support = [&] (const PathPiece& piece) -> const EdgeSupport&
    { return problem.edges[static_cast<std::size_t> (piece.edge)]; };

    for (const auto& path : problem.outline.paths)
        for (std::size_t i = 0; i < path.size(); ++i)
        {
            const auto& next = path[(i + 1) % path.size()];
            const auto turn = reentrantTurn (path[i], next, insideAtLeft (problem.outline, path));
            const auto changes = ! areAlike (support (path[i]), support (next));
            const auto bend = std::abs (curvatureAt (next, next.from) - curvatureAt (path[i], path[i].to));
            const auto bends = support (next).holdsDisplacement && bend * resolution.cell > 0.02;

            if (turn > corner)
                add (small, next.start, { 0, resolution.cornerCell * resolution.cell, 1.4, resolution.degree - 1 });
            else if ((changes || bends) && turn > -corner)
                add (small, next.start, { 0, 5 * resolution.cornerCell * resolution.cell, 1.4, resolution.degree - 1 });
            else if (changes)
                add (small, next.start, { 0, 20 * resolution.cornerCell * resolution.cell, 0.5, 0 });
        }
}

/** Whether an arc turns away from the plate: that of a hole, or of a rounded notch. */
bool isHollow (const PathPiece& piece, double turn)
{
    const auto orientation = piece.cosine.x() * piece.sine.y() - piece.cosine.y() * piece.sine.x();
    return ! piece.isStraight && turn * orientation * (piece.to - piece.from) < 0;
}

/** Cells of a part of the radius all over hollow arcs. */
void addHollows (SmallCellsOfAxes& small, const BendingProblem& problem, const ImmersedResolution& resolution)
{
    constexpr double growth = 0.4;

    for (const auto& path : problem.outline.paths)
        for (const auto& piece : path)
            if (isHollow (piece, insideAtLeft (problem.outline, path)))
            {
                const auto& edge = problem.edges[static_cast<std::size_t> (piece.edge)];
                const auto share = edge.holdsDisplacement || edge.holdsSlope ? 0.3 : 1.0;
                const auto cell = share * resolution.holeCell * std::min (piece.cosine.norm(), piece.sine.norm());
                const Eigen::Vector2d reach (std::hypot (piece.cosine.x(), piece.sine.x()),
                                             std::hypot (piece.cosine.y(), piece.sine.y()));

                for (const auto side : { -1, 0, 1 })
                    add (small, piece.centre + side * reach, { 0, cell, growth, 0 });
            }
}

void addPoints (SmallCellsOfAxes& small, const BendingProblem& problem, const ImmersedResolution& resolution)
{
    for (const auto& point : problem.points)
        add (small, point.place, { 0, resolution.cell / 16, 1, resolution.degree - 2 });
}

/** A line along an axis on which only the slope is continuous, with cells that shrink towards it: at the corners of a
   patch moments vary fast. */
void addBend (SmallCellsOfAxes& small, const KinkFunction& kink, const ImmersedResolution& resolution)
{
    constexpr double share = 0.05, ofWidth = 0.2, growth = 1.4; // The first cell is twice the share.
    const auto cell = std::min (share * resolution.cell, ofWidth * 2 * kink.width);
    auto& along = kink.gradient.y() == 0 ? small.alongX : small.alongY;
    along.push_back (
        { kink.gradient.y() == 0 ? kink.centre.x() : kink.centre.y(), cell, growth, resolution.degree - 1 });
}

/** Cells of a part of a patch's width, and of a wave, all over it, where its edges bend the plate along no axis. */
void addPatches (SmallCellsOfAxes& small, const BendingProblem& problem, const ImmersedResolution& resolution)
{
    // Where edges are held all cells are small already.
    constexpr double growth = 0.3, ofCell = 0.53, ofCellHeld = 0.86;
    const auto isHeld =
        std::any_of (problem.edges.begin(), problem.edges.end(),
                     [] (const EdgeSupport& edge) { return edge.holdsDisplacement || edge.holdsSlope; });
    const auto most = (isHeld ? ofCellHeld : ofCell) * resolution.cell;

    for (const auto& patch : problem.patches)
        for (const auto& kink : patch.kinks)
        {
            if (kink.isAlongAxis())
            {
                addBend (small, kink, resolution);
                continue;
            }

            const auto extent = extentOf (patch.outline);
            const auto cell = std::min (resolution.patchCell * 2 * kink.width, most);
            const auto steps = static_cast<int> (std::ceil (extent.size().maxCoeff() / cell));

            for (int i = 0; i <= steps; ++i)
                add (small, extent.least + static_cast<double> (i) / steps * extent.size(), { 0, cell, growth, 0 });
        }
}
} // namespace

SmallCellsOfAxes smallCells (const BendingProblem& problem, const ImmersedResolution& resolution)
{
    SmallCellsOfAxes small;
    addCorners (small, problem, resolution);
    addHollows (small, problem, resolution);
    addPoints (small, problem, resolution);
    addPatches (small, problem, resolution);
    return small;
}
} // namespace antinode
