#include "PlateProblem.h"

#include "DescriptionChecks.h"
#include "ElementChain.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr double closestLines = 1.0 / 5000; // of the shorter side

/** The distinct ones of some places on a side, ascending; both ends of the side are among them. */
std::vector<double> distinct (std::vector<double> places, double length, double tolerance)
{
    std::sort (places.begin(), places.end());
    std::vector<double> lines { 0 };

    for (const auto place : places)
        if (place > lines.back() + tolerance && place < length - tolerance)
            lines.push_back (place);

    lines.push_back (length);
    return lines;
}

Eigen::Index nearest (const std::vector<double>& lines, double place)
{
    const auto above = std::lower_bound (lines.begin(), lines.end(), place) - lines.begin();
    const auto last = static_cast<std::ptrdiff_t> (lines.size()) - 1;
    const auto right = std::clamp<std::ptrdiff_t> (above, 1, last);
    const auto at = [&] (std::ptrdiff_t index) { return lines[static_cast<std::size_t> (index)]; };
    return place - at (right - 1) < at (right) - place ? right - 1 : right;
}

Eigen::VectorXd scaled (const std::vector<double>& lines, double unit)
{
    return Eigen::Map<const Eigen::VectorXd> (lines.data(), static_cast<Eigen::Index> (lines.size())) / unit;
}

int heldDerivatives (EdgeCondition condition)
{
    return condition == EdgeCondition::clamped ? 2 : condition == EdgeCondition::simplySupported ? 1 : 0;
}

/** The distances from a segment's end at which its first or last cell is divided further. */
std::vector<double> layerDistances (double cell, const PlateResolution& resolution)
{
    constexpr double narrowest = 1.0 / 1500; // of the longer side: much narrower cells cost more digits than they bring
    std::vector<double> distances;

    for (int layer = 0; layer < resolution.layers && cell * resolution.layerRatio > narrowest; ++layer)
        distances.insert (distances.begin(), cell *= resolution.layerRatio);

    return distances;
}
/** Segments longer than two cells get more of them: in short ones the layers at the ends help. */
int cellsOn (double length, double largestCell)
{
    const auto cells = length / largestCell;
    return std::max (1, static_cast<int> (std::ceil (cells + 0.8 * std::max (0.0, cells - 2) - 1e-9)));
}
} // namespace

PlateLayout makeLayout (const PlateDescription& plate)
{
    const auto tolerance = closestLines * std::min (plate.lengthX, plate.lengthY);
    std::vector<double> x, y;

    for (const auto& ceramic : plate.common.ceramics)
    {
        x.insert (x.end(), { ceramic.x, ceramic.x + ceramic.sizeX });
        y.insert (y.end(), { ceramic.y, ceramic.y + ceramic.sizeY });
    }

    x = distinct (std::move (x), plate.lengthX, tolerance);
    y = distinct (std::move (y), plate.lengthY, tolerance);

    PlateLayout layout;
    layout.unit = std::max (plate.lengthX, plate.lengthY);
    layout.linesX = scaled (x, layout.unit);
    layout.linesY = scaled (y, layout.unit);

    for (std::size_t i = 0; i < plate.common.ceramics.size(); ++i)
    {
        const auto& ceramic = plate.common.ceramics[i];
        const PlatePatch patch { nearest (x, ceramic.x), nearest (x, ceramic.x + ceramic.sizeX), nearest (y, ceramic.y),
                                 nearest (y, ceramic.y + ceramic.sizeY) };

        if (patch.left == patch.right || patch.bottom == patch.top)
            throw InputError (ceramicPlace (i, ceramic), "is too narrow; allowed: at least 1/5000 of the plate's "
                                                         "shorter side");

        layout.patches.push_back (patch);
    }

    return layout;
}

CeramicDescription onLines (const PlateDescription& plate, const PlateLayout& layout, std::size_t index)
{
    auto ceramic = plate.common.ceramics[index];
    const auto& [left, right, bottom, top] = layout.patches[index];
    ceramic.x = layout.unit * layout.linesX[left];
    ceramic.y = layout.unit * layout.linesY[bottom];
    ceramic.sizeX = layout.unit * (layout.linesX[right] - layout.linesX[left]);
    ceramic.sizeY = layout.unit * (layout.linesY[top] - layout.linesY[bottom]);
    return ceramic;
}

SplineBreaks divide (const Eigen::VectorXd& lines, const PlateResolution& resolution, EdgeCondition start,
                     EdgeCondition end)
{
    std::vector<double> places { lines[0] };
    std::vector<int> multiplicity { 1 };
    const auto add = [&] (double place, int times)
    {
        places.push_back (place);
        multiplicity.push_back (times);
    };

    for (Eigen::Index s = 0; s + 1 < lines.size(); ++s)
    {
        const auto length = lines[s + 1] - lines[s];
        const auto cells = cellsOn (length, resolution.largestCell);
        const auto cell = length / cells;
        const auto layers = layerDistances (cell, resolution);

        for (const auto distance : layers)
            add (lines[s] + distance, 1);

        for (int i = 1; i < cells; ++i)
            add (lines[s] + i * cell, 1);

        for (auto distance = layers.rbegin(); distance != layers.rend(); ++distance)
            add (lines[s + 1] - *distance, 1);

        add (lines[s + 1], resolution.degree - 1);
    }

    SplineBreaks breaks;
    breaks.places = Eigen::Map<const Eigen::VectorXd> (places.data(), static_cast<Eigen::Index> (places.size()));
    breaks.multiplicity =
        Eigen::Map<const Eigen::VectorXi> (multiplicity.data(), static_cast<Eigen::Index> (multiplicity.size()));
    breaks.heldAtStart = heldDerivatives (start);
    breaks.heldAtEnd = heldDerivatives (end);
    return breaks;
}

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
