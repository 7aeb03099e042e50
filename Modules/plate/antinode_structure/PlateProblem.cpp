#include "PlateProblem.h"

#include "ElementChain.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
Eigen::Index firstCell (const SplineAxis& axis, double line)
{
    // Lines are breaks; half a cell keeps rounding from choosing the one before.
    const auto cell = axis.cellAt (line);
    return line - axis.cellStart (cell) > axis.cellLength (cell) / 2 ? cell + 1 : cell;
}

PlateSection relative (const PlateSection& section, const PlateSection& unit)
{
    return { section.massPerArea / unit.massPerArea,
             section.d11 / unit.d11,
             section.d22 / unit.d11,
             section.d12 / unit.d11,
             section.d66 / unit.d11,
             0,
             0 };
}

PlateSection difference (const PlateSection& a, const PlateSection& b)
{
    return { a.massPerArea - b.massPerArea, a.d11 - b.d11, a.d22 - b.d22, a.d12 - b.d12, a.d66 - b.d66, 0, 0 };
}

/** What a ceramic adds, where its bond hands nothing over, and what it hands over. */
PlateRegion addedBy (const StructureCommon& common, const CeramicDescription& ceramic, const PlateSection& bare,
                     double unit)
{
    PlateRegion region;
    const auto bond = ceramicBond (common, ceramic, 0);
    const auto everywhere = bond ? alongAxes (bond->loose) : ceramicSection (common, ceramic);
    region.section = relative (difference (everywhere, bare), bare);
    region.section.rotaryInertia = addedRotaryInertia (common, ceramic) / (bare.massPerArea * unit * unit);

    if (bond)
        region.bonded = scaledPart (bond->part, unit, bare.d11);

    return region;
}

std::pair<SplineAxis, SplineAxis> makeAxes (const PlateDescription& plate, const PlateLayout& layout,
                                            const PlateResolution& resolution)
{
    return { SplineAxis (divide (layout.linesX, resolution, plate.left, plate.right), resolution.degree),
             SplineAxis (divide (layout.linesY, resolution, plate.bottom, plate.top), resolution.degree) };
}

struct RegionProducts
{
    SplineProducts outer, inner;
};

/** The products of a region's splines on the axes of two problems. */
RegionProducts computeProducts (const PlateRegion& region, const PlateProblem& rows, const PlateProblem& columns,
                                const AxisWeight& weightX = {}, const AxisWeight& weightY = {})
{
    const auto x = splineProducts (rows.x(), columns.x(), region.beginX, region.endX, weightX);
    const auto y = splineProducts (rows.y(), columns.y(), region.beginY, region.endY, weightY);
    return rows.outerIsX ? RegionProducts { x, y } : RegionProducts { y, x };
}

TensorOperator emptyOperator (const PlateProblem& rows, const PlateProblem& columns)
{
    return { rows.outer.size(), rows.inner.size(), columns.outer.size(), columns.inner.size(), {} };
}

void addTerm (TensorOperator& tensor, const RegionProducts& products, const Eigen::MatrixXd& outer,
              const Eigen::MatrixXd& inner)
{
    tensor.terms.push_back ({ products.outer.firstRow, products.outer.firstColumn, products.inner.firstRow,
                              products.inner.firstColumn, outer, inner });
}

/** Twice the strain energy of bending, paper (10): D11 w,xx^2 + D22 w,yy^2 + 2 D12 w,xx w,yy + 4 D66 w,xy^2. */
void addStiffness (PlateProblem& problem, const PlateRegion& region, const RegionProducts& products)
{
    const auto& [outer, inner] = products;
    const auto& section = region.section;
    const auto along = problem.outerIsX ? section.d11 : section.d22;
    const auto across = problem.outerIsX ? section.d22 : section.d11;
    const auto add = [&] (const Eigen::MatrixXd& o, const Eigen::MatrixXd& i)
    { addTerm (problem.stiffness, products, o, i); };
    add (along * outer.curvatures, inner.values);
    add (across * outer.values, inner.curvatures);
    add (4 * section.d66 * outer.slopes, inner.slopes);
    add (section.d12 * outer.curvatureValue, inner.curvatureValue.transpose());
    add (section.d12 * outer.curvatureValue.transpose(), inner.curvatureValue);
}

/** The same of what is bonded, each part by what it needs to build up. */
void addBonded (PlateProblem& problem, const PlateRegion& region, const RegionProducts& whole)
{
    const auto& part = *region.bonded;
    const auto parts = BondedStiffness::of (part.stiffness);
    const auto products = [&] (const Eigen::Vector2d& lengths)
    {
        const auto share = [&] (Eigen::Index side) -> AxisWeight
        { return [&part, &lengths, side] (double place) { return part.shareAlong (side, place, lengths); }; };
        return computeProducts (region, problem, problem, share (0), share (1));
    };
    const auto stretched = products (part.lengths), sheared = products (part.shearLengths);
    const auto& [outer, inner] = stretched;
    const auto add = [&] (const Eigen::MatrixXd& o, const Eigen::MatrixXd& i)
    { addTerm (problem.stiffness, whole, o, i); };
    const auto along = problem.outerIsX ? parts.first : parts.second;
    const auto across = problem.outerIsX ? parts.second : parts.first;
    const auto bothAlong = problem.outerIsX ? parts.bothFirst : parts.bothSecond;
    const auto bothAcross = problem.outerIsX ? parts.bothSecond : parts.bothFirst;
    add (outer.curvatures, along * whole.inner.values + bothAlong * inner.values);
    add (across * whole.outer.values + bothAcross * outer.values, inner.curvatures);
    add (4 * parts.shear * sheared.outer.slopes, sheared.inner.slopes);
    add (parts.coupling * outer.curvatureValue, inner.curvatureValue.transpose());
    add (parts.coupling * outer.curvatureValue.transpose(), inner.curvatureValue);
}

void addMass (TensorOperator& mass, const PlateRegion& region, const RegionProducts& products)
{
    const auto& [outer, inner] = products;
    addTerm (mass, products, region.section.massPerArea * outer.values, inner.values);

    if (const auto inertia = region.section.rotaryInertia; inertia != 0)
    {
        addTerm (mass, products, inertia * outer.slopes, inner.values);
        addTerm (mass, products, inertia * outer.values, inner.slopes);
    }
}
} // namespace

std::vector<PlateRegion> makeRegions (const PlateDescription& plate, const PlateLayout& layout, const SplineAxis& x,
                                      const SplineAxis& y)
{
    const auto bare = bareSection (plate.common);
    std::vector<PlateRegion> regions { { 0, x.cells(), 0, y.cells(), relative (bare, bare), {} } };

    for (std::size_t i = 0; i < layout.patches.size(); ++i)
    {
        const auto& patch = layout.patches[i];
        auto region = addedBy (plate.common, onLines (plate, layout, i), bare, layout.unit);
        region.beginX = firstCell (x, layout.linesX[patch.left]);
        region.endX = firstCell (x, layout.linesX[patch.right]);
        region.beginY = firstCell (y, layout.linesY[patch.bottom]);
        region.endY = firstCell (y, layout.linesY[patch.top]);
        regions.push_back (std::move (region));
    }

    return regions;
}

Eigen::MatrixXd PlateProblem::coefficients (const Eigen::VectorXd& field) const
{
    const Eigen::Map<const Eigen::MatrixXd> innerByOuter (field.data(), inner.size(), outer.size());
    return outerIsX ? Eigen::MatrixXd (innerByOuter.transpose()) : Eigen::MatrixXd (innerByOuter);
}

Eigen::VectorXd PlateProblem::field (const Eigen::MatrixXd& coefficients) const
{
    const Eigen::MatrixXd innerByOuter = outerIsX ? Eigen::MatrixXd (coefficients.transpose()) : coefficients;
    return Eigen::Map<const Eigen::VectorXd> (innerByOuter.data(), innerByOuter.size());
}

PlateProblem plateProblem (const PlateDescription& plate, const PlateLayout& layout, const SplineAxis& x,
                           const SplineAxis& y)
{
    const auto outerIsX = x.cells() >= y.cells();
    PlateProblem problem { outerIsX ? x : y, outerIsX ? y : x, outerIsX, {}, {} };
    problem.stiffness = problem.mass = emptyOperator (problem, problem);

    for (const auto& region : makeRegions (plate, layout, x, y))
    {
        checkWatch();
        const auto products = computeProducts (region, problem, problem);
        addStiffness (problem, region, products);
        addMass (problem.mass, region, products);

        if (region.bonded)
            addBonded (problem, region, products);
    }

    return problem;
}

PlateProblem plateProblem (const PlateDescription& plate, const PlateLayout& layout, const PlateResolution& resolution)
{
    const auto [x, y] = makeAxes (plate, layout, resolution);
    return plateProblem (plate, layout, x, y);
}

Eigen::Index expectedUnknowns (const PlateDescription& plate, const PlateLayout& layout,
                               const PlateResolution& resolution)
{
    constexpr double maximumCells = 2e4; // Along a side: more are beyond any use, and not even to be listed.

    if (! (resolution.largestCell * maximumCells > 1))
        return std::numeric_limits<Eigen::Index>::max();

    const auto [x, y] = makeAxes (plate, layout, resolution);
    return x.size() * y.size();
}

TensorOperator massBetween (const PlateDescription& plate, const PlateLayout& layout, const PlateProblem& rows,
                            const PlateProblem& columns)
{
    auto mass = emptyOperator (rows, columns);

    for (const auto& region : makeRegions (plate, layout, columns.x(), columns.y()))
    {
        checkWatch();
        const auto products = computeProducts (region, rows, columns);
        addMass (mass, region, products);
    }

    return mass;
}

std::optional<Eigen::Index> eigenvaluesBelow (const PlateProblem& problem, double value)
{
    const auto factor = factorShifted (problem.stiffness, problem.mass, value, problem.outer);
    return factor.isUsable() ? std::optional (factor.negativePivots()) : std::nullopt;
}

namespace
{
/** The place with the widest relative gap above it among the last few of ascending values. */
Eigen::Index widestGap (const Eigen::VectorXd& values, Eigen::Index first)
{
    auto best = first;

    for (auto i = first; i + 1 < values.size(); ++i)
        if (values[i + 1] - values[i] > values[best + 1] - values[best])
            best = i;

    return best;
}
} // namespace

Eigenpairs solve (const PlateProblem& problem, Eigen::Index count)
{
    constexpr double shift = -1; // About the size of the lowest eigenvalue of a plate with free edges.

    if (problem.unknowns() <= count)
        throw InputError ("device", "has " + std::to_string (problem.unknowns())
                                        + " unknowns and cannot have so many modes; allowed: up to "
                                        + std::to_string (problem.unknowns() - 1) + " modes");

    const auto factor = factorShifted (problem.stiffness, problem.mass, shift, problem.outer);

    if (! factor.isUsable() || factor.negativePivots() > 0)
        throwNumbersTooFarApart();

    // Some more than wanted: the count is proven in the widest gap among them. More of them bring to light what a few
    // have missed.
    for (const Eigen::Index more : { 4, 32 })
    {
        const auto all = std::min (count + more, problem.unknowns());
        auto pairs = lowestEigenpairs (factor, std::cref (problem.mass), problem.unknowns(), shift, all);
        const auto last = widestGap (pairs.values, count - 1);
        const auto below = eigenvaluesBelow (problem, (pairs.values[last] + pairs.values[last + 1]) / 2);

        if (pairs.areConverged && below == last + 1)
        {
            pairs.values.conservativeResize (count);
            pairs.vectors.conservativeResize (Eigen::NoChange, count);
            return pairs;
        }
    }

    throwNumbersTooFarApart();
}
} // namespace antinode
