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
RegionProducts computeProducts (const PlateRegion& region, const PlateProblem& rows, const PlateProblem& columns)
{
    const auto x = splineProducts (rows.x(), columns.x(), region.beginX, region.endX);
    const auto y = splineProducts (rows.y(), columns.y(), region.beginY, region.endY);
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
} // namespace

std::vector<PlateRegion> makeRegions (const PlateDescription& plate, const PlateLayout& layout, const SplineAxis& x,
                                      const SplineAxis& y)
{
    const auto bare = bareSection (plate.common);
    std::vector<PlateRegion> regions { { 0, x.cells(), 0, y.cells(), relative (bare, bare) } };

    for (std::size_t i = 0; i < layout.patches.size(); ++i)
    {
        const auto& patch = layout.patches[i];
        const auto added = difference (ceramicSection (plate.common, plate.common.ceramics[i]), bare);
        regions.push_back ({ firstCell (x, layout.linesX[patch.left]), firstCell (x, layout.linesX[patch.right]),
                             firstCell (y, layout.linesY[patch.bottom]), firstCell (y, layout.linesY[patch.top]),
                             relative (added, bare) });
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
        addTerm (problem.mass, products, region.section.massPerArea * products.outer.values, products.inner.values);
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
        addTerm (mass, products, region.section.massPerArea * products.outer.values, products.inner.values);
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
