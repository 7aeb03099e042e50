#include "BendingModes.h"

#include "CellSizes.h"
#include "ImmersedOperators.h"
#include "RigidMotions.h"
#include "SmallFeatures.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/BlockLanczos.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
[[noreturn]] void throwNumbersTooFarApart()
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

    throwNumbersTooFarApart();
}
} // namespace antinode
