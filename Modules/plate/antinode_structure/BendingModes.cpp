#include "BendingModes.h"

#include "ImmersedOperators.h"
#include "PlateSupports.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/BlockLanczos.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
using std::numbers::pi;

/** What edges take from the area's share of modes, in units of length times k / (4 pi). */
double edgeTerms (const BendingProblem& problem)
{
    double sum = 0;

    for (const auto& path : problem.outline.paths)
        for (const auto& piece : path)
        {
            const auto& support = problem.edges[static_cast<std::size_t> (piece.edge)];
            const auto isHeld = support.holdsDisplacement || support.translation > 0;
            const auto isClamped = isHeld && (support.holdsSlope || support.rotation > 0);
            sum += piece.length (piece.from, piece.to) * (isClamped ? 1.8 : isHeld ? 1.0 : 0.0);
        }

    return sum;
}

/** The greatest ratio of a patch's wave number to that of the plate. */
double shortestWaves (const BendingProblem& problem)
{
    double ratio = 1;

    for (const auto& patch : problem.patches)
    {
        const auto mass = 1 + patch.added.massPerArea / problem.section.massPerArea;
        const auto stiffness = 1
                               + (patch.added.stiffness (0, 0) + (patch.bonded ? patch.bonded->stiffness (0, 0) : 0))
                                     / problem.section.stiffness (0, 0);
        ratio = std::max (ratio, std::pow (mass / stiffness, 0.25));
    }

    return ratio;
}
} // namespace

double expectedWaveNumber (const BendingProblem& problem, int count)
{
    const auto& d = problem.section.stiffness;
    const auto softer = std::min (d (0, 0), d (1, 1));

    // Of waves along the softer direction; those of other directions are longer.
    const auto area = areaOf (problem.outline) * std::sqrt (softer / std::sqrt (d (0, 0) * d (1, 1)));
    const auto edges = edgeTerms (problem);
    return (edges / 2 + std::sqrt (edges * edges / 4 + 16 * pi * area * (count + 1))) / (2 * area);
}

ImmersedResolution resolutionFor (const BendingProblem& problem, int count, ModeAccuracy accuracy)
{
    constexpr int resolvedModes = 20; // At least: then few modes are right to many digits, and still cost little.
    const auto wavelength =
        2 * pi / (expectedWaveNumber (problem, std::max (count, resolvedModes)) * shortestWaves (problem));
    const auto isHigh = accuracy == ModeAccuracy::high;

    if (accuracy == ModeAccuracy::coarse)
        return {
            .degree = 3, .cell = 0.25 * wavelength, .cornerCell = 0.5, .holeCell = 1, .patchCell = 1, .bendCell = 1
        };

    const auto isHeld =
        std::any_of (problem.edges.begin(), problem.edges.end(),
                     [] (const EdgeSupport& edge) { return edge.holdsDisplacement || edge.holdsSlope; });
    ImmersedResolution resolution;
    resolution.cell = (isHeld ? 0.105 : 0.17) * (isHigh ? 0.7 : 1) * wavelength;
    resolution.holeCell = isHigh ? 0.2 : 0.3;
    resolution.patchCell = isHigh ? 0.05 : 0.08;
    return resolution;
}

namespace
{
[[noreturn]] void throwLengthsTooFarApart()
{
    throw InputError ("device", "has lengths, thicknesses or material constants too far apart to solve");
}

SplineBreaks axisBreaks (const OutlineExtent& extent, PlaneAxis axis, const ImmersedResolution& resolution,
                         const std::vector<SmallCells>& small)
{
    const auto index = axis == PlaneAxis::x ? 0 : 1;
    const auto before = resolution.offset * resolution.cell;
    const auto after = resolution.offset > 0 ? resolution.cell - before : 0;
    return breaksBetween (extent.least[index] - before, extent.largest[index] + after, resolution.cell, small);
}

/** The place with the widest gap above it among the last few of ascending values. */
Eigen::Index widestGap (const Eigen::VectorXd& values, Eigen::Index first)
{
    auto best = first;

    for (auto i = first; i + 1 < values.size(); ++i)
        if (values[i + 1] - values[i] > values[best + 1] - values[best])
            best = i;

    return best;
}

/** The lowest eigenpairs, of which none is missing; nothing where that cannot be proven. */
std::optional<Eigenpairs> provenPairs (const ImmersedOperators& operators, double shift, Eigen::Index count)
{
    const auto unknowns = operators.mass.size();
    const auto mass = [&] (const Eigen::MatrixXd& columns) -> Eigen::MatrixXd { return operators.mass * columns; };

    if (unknowns <= count)
        throw InputError ("device", "has " + std::to_string (unknowns) + " unknowns and cannot have so many modes");

    const auto factor = factorShifted (operators, shift);

    // Functions that hardly touch the plate on an edge that is held can make it indefinite.
    if (! factor.isUsable() || factor.negativePivots() > 0)
        return std::nullopt;

    for (const Eigen::Index more : { 4, 32 })
    {
        const auto all = std::min (count + more, unknowns);
        auto pairs = lowestEigenpairs (factor, mass, unknowns, shift, all);
        const auto last = widestGap (pairs.values, count - 1);
        const auto above = factorShifted (operators, (pairs.values[last] + pairs.values[last + 1]) / 2);

        if (pairs.areConverged && above.isUsable() && above.negativePivots() == last + 1)
        {
            pairs.values.conservativeResize (count);
            pairs.vectors.conservativeResize (Eigen::NoChange, count);
            return pairs;
        }
    }

    return std::nullopt;
}

/** The modes with cells laid as they are wanted; nothing where their number cannot be proven. */
std::optional<BendingModes> modesOn (const BendingProblem& problem, int count, const ImmersedResolution& resolution)
{
    const auto extent = extentOf (problem.outline);
    const auto small = smallCells (problem, resolution);
    const auto x = axisBreaks (extent, PlaneAxis::x, resolution, small.alongX);
    const auto y = axisBreaks (extent, PlaneAxis::y, resolution, small.alongY);
    constexpr Eigen::Index mostCells = 60000;

    if (x.places.size() * y.places.size() > mostCells)
        throw InputError ("device", "needs " + std::to_string (x.places.size()) + " x "
                                        + std::to_string (y.places.size())
                                        + " cells; allowed: " + std::to_string (mostCells)
                                        + ", so choose fewer modes, fewer corners and holes, or larger ceramics");

    ImmersedSpace space (problem, x, y, resolution.degree);
    const auto operators = immersedOperators (problem, space);
    const auto rigid = freeMotions (problem, space, operators.mass);
    const auto pairs = provenPairs (operators, -eigenvalueUnit (problem), rigid.cols() + count);
    constexpr double negligible = 0.03;

    // A rigid motion whose frequency is not negligible is rounding that spoils the flexible modes, too.
    if (! pairs || ! pairs->values.allFinite() || ! (pairs->values[rigid.cols()] > 0)
        || (rigid.cols() > 0
            && pairs->values.head (rigid.cols()).cwiseAbs().maxCoeff() > negligible * pairs->values[rigid.cols()]))
        return std::nullopt;

    Eigen::MatrixXd coefficients = pairs->vectors.rightCols (count);
    coefficients -= rigid * (rigid.transpose() * (operators.mass * coefficients));
    Eigen::MatrixXd participation = coefficients.transpose() * operators.loads;
    return BendingModes { std::move (space), pairs->values.tail (count), std::move (coefficients),
                          std::move (participation), static_cast<int> (rigid.cols()) };
}
} // namespace

BendingModes bendingModes (const BendingProblem& problem, int count, const ImmersedResolution& resolution)
{
    // Where the boundary leaves slivers of cells that cost too many digits, other cells have others.
    for (const auto shift : { 0.0, 0.37, 0.61, 0.13, 0.83 })
    {
        auto laid = resolution;
        laid.offset = std::fmod (resolution.offset + shift, 1);

        if (auto modes = modesOn (problem, count, laid))
            return std::move (*modes);
    }

    throwLengthsTooFarApart();
}

namespace
{
double sizeAt (double place, double cell, const std::vector<SmallCells>& small)
{
    for (const auto& near : small)
        cell = std::min (cell, near.cell + near.growth * std::abs (place - near.place));

    return cell;
}

/** Appends the breaks of a segment, without its first place. */
void addSegment (std::vector<double>& places, double from, double to, double cell, const std::vector<SmallCells>& small)
{
    constexpr double step = 0.05; // Of a cell.
    std::vector<double> at { from }, cells { 0 };

    while (at.back() < to)
    {
        const auto here = at.back();
        const auto guess = std::min (to, here + step * sizeAt (here, cell, small));
        const auto next = std::min (to, here + step * sizeAt ((here + guess) / 2, cell, small));
        const auto middle = sizeAt ((here + next) / 2, cell, small);
        cells.push_back (cells.back() + (next - here) / middle);
        at.push_back (next);
    }

    const auto count = std::max (1, static_cast<int> (std::ceil (cells.back() - 1e-6)));

    for (int i = 1; i < count; ++i)
    {
        const auto wanted = cells.back() * i / count;
        const auto above = std::upper_bound (cells.begin(), cells.end(), wanted) - cells.begin();
        const auto k = static_cast<std::size_t> (above);
        places.push_back (at[k - 1] + (at[k] - at[k - 1]) * (wanted - cells[k - 1]) / (cells[k] - cells[k - 1]));
    }

    places.push_back (to);
}
} // namespace

SplineBreaks breaksBetween (double from, double to, double cell, const std::vector<SmallCells>& small)
{
    std::vector<SmallCells> lines;
    const auto nearest = 1e-9 * (to - from);
    std::copy_if (small.begin(), small.end(), std::back_inserter (lines),
                  [&] (const SmallCells& s)
                  { return s.multiplicity > 0 && s.place > from + nearest && s.place < to - nearest; });
    std::sort (lines.begin(), lines.end(), [] (const auto& a, const auto& b) { return a.place < b.place; });

    std::vector<double> places { from };
    std::vector<int> multiplicity { 1 };

    for (const auto& line : lines)
    {
        if (line.place <= places.back() + nearest)
        {
            multiplicity.back() = std::max (multiplicity.back(), line.multiplicity);
            continue;
        }

        addSegment (places, places.back(), line.place, cell, small);
        multiplicity.resize (places.size(), 1);
        multiplicity.back() = line.multiplicity;
    }

    addSegment (places, places.back(), to, cell, small);
    multiplicity.resize (places.size(), 1);
    return { Eigen::Map<const Eigen::VectorXd> (places.data(), static_cast<Eigen::Index> (places.size())),
             Eigen::Map<const Eigen::VectorXi> (multiplicity.data(), static_cast<Eigen::Index> (multiplicity.size())) };
}

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
    constexpr double growth = 1.4; // The first cell is twice the share.
    const auto cell = resolution.bendCell * std::min (resolution.cell, 4 * 2 * kink.width);
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
