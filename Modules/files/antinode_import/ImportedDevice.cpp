#include "ImportedDevice.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_identification/IdentifiedModel.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace antinode
{
namespace
{
using Nodes = std::vector<Eigen::Index>;

/** Nodes that a case loads by more than rounding. */
std::vector<bool> loadedNodes (const Eigen::MatrixX3d& forces)
{
    constexpr double rounding = 1e-6; // files carry six digits
    const Eigen::VectorXd sizes = forces.rowwise().norm();
    const auto least = rounding * sizes.maxCoeff();
    std::vector<bool> result (static_cast<std::size_t> (forces.rows()));

    for (std::size_t n = 0; n < result.size(); ++n)
        result[n] = sizes[static_cast<Eigen::Index> (n)] > least;

    return result;
}

/** The materials whose elements have all nodes that one of the cases loads: only they strain. Where the whole body is
   of one material it is none. */
std::set<std::int64_t> ceramicMaterials (const ElementResults& results)
{
    std::map<std::int64_t, std::vector<bool>> nodesOf;

    for (const auto& element : results.elements)
    {
        auto& nodes = nodesOf[element.material];
        nodes.resize (static_cast<std::size_t> (results.nodes()));

        for (const auto node : element.nodes)
            nodes[static_cast<std::size_t> (node)] = true;
    }

    std::set<std::int64_t> ceramics;

    for (const auto& forces : results.blockedForces)
    {
        const auto loaded = loadedNodes (forces);

        for (const auto& [material, nodes] : nodesOf)
            if (std::equal (loaded.begin(), loaded.end(), nodes.begin(),
                            [] (bool isLoaded, bool isOfMaterial) { return ! isLoaded || isOfMaterial; }))
                ceramics.insert (material);
    }

    return ceramics.size() < nodesOf.size() ? ceramics : std::set<std::int64_t> {};
}

/** Nodes of the body without its ceramics; all of a mesh without elements. */
Nodes bodyNodes (const ElementResults& results)
{
    const auto ceramics = ceramicMaterials (results);
    std::vector<bool> isOfBody (static_cast<std::size_t> (results.nodes()), results.elements.empty());

    for (const auto& element : results.elements)
        if (! ceramics.contains (element.material))
            for (const auto node : element.nodes)
                isOfBody[static_cast<std::size_t> (node)] = true;

    Nodes nodes;

    for (std::size_t n = 0; n < isOfBody.size(); ++n)
        if (isOfBody[n])
            nodes.push_back (static_cast<Eigen::Index> (n));

    return nodes;
}

/** Nodes by their place in the plane, one for each: places nearer than a tolerance are one. */
class Places
{
public:
    explicit Places (double nearness) : tolerance (nearness) {}

    /** Keeps the higher one of two at the same place. @param place  from the corner of all */
    void add (Eigen::Index node, const Eigen::Vector2d& place, double height)
    {
        const auto cell = cellOf (place);

        for (long i = -1; i <= 1; ++i)
            for (long j = -1; j <= 1; ++j)
                if (const auto found = cells.find ({ cell.first + i, cell.second + j });
                    found != cells.end() && (found->second.place - place).norm() <= tolerance)
                {
                    if (height > found->second.height)
                        found->second = { node, place, height };

                    return;
                }

        cells[cell] = { node, place, height };
    }

    struct Kept
    {
        Eigen::Index node = 0;
        Eigen::Vector2d place;
        double height = 0;
    };

    std::vector<Kept> kept() const
    {
        std::vector<Kept> result;

        for (const auto& [cell, each] : cells)
            result.push_back (each);

        std::sort (result.begin(), result.end(), [] (const Kept& a, const Kept& b) { return a.node < b.node; });
        return result;
    }

private:
    std::pair<long, long> cellOf (const Eigen::Vector2d& place) const
    {
        return { std::lround (place.x() / tolerance), std::lround (place.y() / tolerance) };
    }

    double tolerance;
    std::map<std::pair<long, long>, Kept> cells;
};

/** At most so many, the nearest to the middle of each cell of an even grid. */
std::vector<Places::Kept> thinned (const std::vector<Places::Kept>& all, int maximum)
{
    if (static_cast<int> (all.size()) <= maximum)
        return all;

    Eigen::Vector2d lower = all.front().place, upper = lower;

    for (const auto& each : all)
    {
        lower = lower.cwiseMin (each.place);
        upper = upper.cwiseMax (each.place);
    }

    // Points on a line, too, have as many cells.
    const Eigen::Vector2d extent = upper - lower;
    const auto side = std::max (std::sqrt (extent.prod() / maximum), extent.maxCoeff() / maximum);
    std::map<std::pair<long, long>, Places::Kept> cells;

    for (const auto& each : all)
    {
        const Eigen::Vector2d at = (each.place - lower) / side;
        const Eigen::Vector2d middle = at.array().floor() + 0.5;
        const auto [found, isNew] =
            cells.try_emplace ({ std::lround (middle.x() - 0.5), std::lround (middle.y() - 0.5) }, each);

        if (! isNew && (at - middle).norm() < ((found->second.place - lower) / side - middle).norm())
            found->second = each;
    }

    std::vector<Places::Kept> result;
    result.reserve (cells.size());

    for (const auto& [cell, each] : cells)
        result.push_back (each);

    return result;
}

LoadedArea loadedArea (const Eigen::MatrixX2d& places, const Eigen::MatrixX3d& forces)
{
    const auto loaded = loadedNodes (forces);
    LoadedArea area { 1e300, -1e300, 1e300, -1e300 };

    for (std::size_t n = 0; n < loaded.size(); ++n)
        if (const Eigen::RowVector2d place = places.row (static_cast<Eigen::Index> (n)); loaded[n])
            area = { std::min (area.xMinimum, place.x()), std::max (area.xMaximum, place.x()),
                     std::min (area.yMinimum, place.y()), std::max (area.yMaximum, place.y()) };

    return area;
}
} // namespace

TouchedSurface findTouchedSurface (const ElementResults& results, const SideChoice& side)
{
    constexpr double samePlace = 1e-5, flat = 1e-3; // of the extent; files carry six digits
    Eigen::MatrixX2d plane (results.nodes(), 2);
    plane << results.places.col ((side.axis + 1) % 3), results.places.col ((side.axis + 2) % 3);
    const Eigen::VectorXd heights = (side.isTop ? 1.0 : -1.0) * results.places.col (side.axis);
    const auto body = bodyNodes (results);

    if (body.empty())
        throw InputError ("finite-element results", "contain ceramics only; allowed: a body that carries them");

    const Eigen::MatrixX2d ofBody = plane (body, Eigen::all);
    const Eigen::RowVector2d corner = ofBody.colwise().minCoeff();
    const auto extent = (ofBody.colwise().maxCoeff() - corner).maxCoeff();
    const auto highest = Eigen::VectorXd (heights (body)).maxCoeff();
    Places places (std::max (samePlace * extent, 1e-12));

    for (const auto node : body)
        places.add (node, (plane.row (node) - corner).transpose(), heights[node]);

    std::vector<Places::Kept> kept;
    TouchedSurface surface;
    const auto depth = side.flatness > 0 ? side.flatness : flat * extent;

    for (const auto& each : places.kept())
        if (each.height >= highest - depth)
            kept.push_back (each);
        else
            ++surface.lower;

    surface.meshNodes = static_cast<Eigen::Index> (kept.size());
    kept = thinned (kept, side.maximumPoints);

    if (kept.size() < 3)
        throw InputError ("finite-element results", "have " + std::to_string (kept.size())
                                                        + " nodes on their outermost plane; allowed: 3 or more; choose "
                                                          "another normal axis or side, or a larger flatness");

    surface.points.resize (static_cast<Eigen::Index> (kept.size()), 2);

    for (std::size_t n = 0; n < kept.size(); ++n)
    {
        surface.nodes.push_back (kept[n].node);
        surface.points.row (static_cast<Eigen::Index> (n)) = plane.row (kept[n].node);
    }

    for (const auto& forces : results.blockedForces)
        surface.ceramics.push_back (loadedArea (plane, forces));

    return surface;
}

namespace
{
/** Modes that move the surface along its normal, ascending in frequency. */
std::vector<std::size_t> usefulModes (const ElementResults& results, const TouchedSurface& surface, int axis)
{
    constexpr double least = 1e-3; // of the surface's motion: below, modes move it within its plane
    std::vector<std::size_t> order;

    for (std::size_t k = 0; k < results.modes.size(); ++k)
    {
        const Eigen::MatrixX3cd moved = results.modes[k].shape (surface.nodes, Eigen::all);

        if (results.modes[k].frequency > 0 && moved.col (axis).squaredNorm() > least * moved.squaredNorm())
            order.push_back (k);
    }

    std::stable_sort (order.begin(), order.end(),
                      [&results] (auto a, auto b) { return results.modes[a].frequency < results.modes[b].frequency; });

    if (order.empty())
        throw InputError ("finite-element results", "contain no mode that moves the surface along its normal; choose "
                                                    "another normal axis");

    return order;
}

/** What a ceramic's forces at 1 V do to a mode; N kg^-1/2 / V. */
std::complex<double> participation (const Eigen::MatrixX3d& blockedForces, const ElementMode& mode, double voltage)
{
    return -(blockedForces.cast<std::complex<double>>().cwiseProduct (mode.shape)).sum() / voltage;
}

/** As if they had been measured at the surface's points. */
IdentifiedModes modesOnSurface (const ElementResults& results, const TouchedSurface& surface,
                                const std::vector<std::size_t>& order, const ImportSettings& settings)
{
    const auto modes = static_cast<Eigen::Index> (order.size());
    const auto ceramics = static_cast<Eigen::Index> (results.blockedForces.size());
    IdentifiedModes made;
    made.points = surface.points;
    made.angularFrequencies.resize (modes);
    made.dampingRatios.resize (modes);
    made.deviations.angularFrequencies = Eigen::VectorXd::Zero (modes);
    Eigen::MatrixXcd shapes (surface.points.rows(), modes), alpha (modes, ceramics);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto& mode = results.modes[order[static_cast<std::size_t> (k)]];
        made.angularFrequencies[k] = 2 * std::numbers::pi * mode.frequency;
        made.dampingRatios[k] = mode.dampingRatio > 0 ? mode.dampingRatio : settings.dampingRatio;
        shapes.col (k) = mode.shape (surface.nodes, settings.side.axis);

        for (Eigen::Index i = 0; i < ceramics; ++i)
            alpha (k, i) =
                participation (results.blockedForces[static_cast<std::size_t> (i)], mode, settings.caseVoltage);
    }

    made.shapes = shapes.real();
    made.participation = alpha.real();

    if (results.hasComplexModes())
    {
        made.complexShapes = shapes;
        made.complexParticipation = alpha;
    }

    for (Eigen::Index i = 0; i < ceramics; ++i)
        made.references.push_back ({ "C" + std::to_string (i + 1), {} });

    return made;
}

std::vector<Ceramic> makeCeramics (const TouchedSurface& surface, double voltageLimit)
{
    std::vector<Ceramic> ceramics;

    for (const auto& area : surface.ceramics)
    {
        Ceramic ceramic;
        ceramic.name = "C" + std::to_string (ceramics.size() + 1);
        ceramic.xMinimum = area.xMinimum;
        ceramic.xMaximum = area.xMaximum;
        ceramic.yMinimum = area.yMinimum;
        ceramic.yMaximum = area.yMaximum;
        ceramic.voltageLimit = voltageLimit;
        ceramics.push_back (ceramic);
    }

    return ceramics;
}

/** RMS over the surface of what sum phi alpha / omega^2 leaves of a static displacement at the case's voltage. */
double staticError (const ModalModel& model, Eigen::Index ceramic, const Eigen::VectorXd& measured, double voltage)
{
    const Eigen::VectorXd amplitudes =
        voltage * model.participation.col (ceramic).cwiseQuotient (model.angularFrequencies.cwiseAbs2());
    return (model.shapes * amplitudes - measured).norm() / measured.norm();
}

/** @param usualDamping  of modes for which the program says none */
void addWarnings (ImportedDevice& device, double usualDamping)
{
    constexpr double likely = 0.35, goodSum = 0.05, longest = 5; // m
    const auto& surface = device.model.surface;
    const auto length = std::max (surface.xMaximum - surface.xMinimum, surface.yMaximum - surface.yMinimum);

    if (length > longest)
        device.warnings.push_back ("The surface is " + inWords (length) + " m long: the files may be in mm.");

    if (device.totalMass && std::abs (device.mass / *device.totalMass - 1) > likely)
        device.warnings.push_back ("The shapes' norms give the surface " + inWords (1000 * device.mass)
                                   + " g, the program's table says " + inWords (1000 * *device.totalMass)
                                   + " g: shapes may not be mass-normalised.");

    for (std::size_t i = 0; i < device.staticErrors.size(); ++i)
        if (device.staticErrors[i] > goodSum)
            device.warnings.push_back ("The modes leave " + inWords (100 * device.staticErrors[i])
                                       + " % of the static displacement by ceramic " + std::to_string (i + 1)
                                       + ": more modes are needed, or the case is not that of the reaction forces.");

    if (device.withoutDamping > 0)
        device.warnings.push_back (
            std::to_string (device.withoutDamping) + " of " + std::to_string (device.model.modes())
            + " modes have no damping ratio in the files: they get " + inWords (usualDamping) + ".");
}
} // namespace

ImportedDevice importDevice (const ElementResults& results, const ImportSettings& settings)
{
    for (std::size_t i = 0; i < results.blockedForces.size(); ++i)
        if (! (results.blockedForces[i].cwiseAbs().maxCoeff() > 0))
            throw InputError ("ceramic " + std::to_string (i + 1),
                              "has no reaction forces in its case; allowed: those of "
                              "all nodes held while it strains");

    const auto surface = findTouchedSurface (results, settings.side);
    const auto order = usefulModes (results, surface, settings.side.axis);
    ImportedDevice device;
    MappedSurface mapped;
    mapped.name = settings.name;
    mapped.boundary = settings.boundary;
    mapped.ceramics = makeCeramics (surface, settings.voltageLimit);
    mapped.fullScaleVoltage = settings.fullScaleVoltage;
    device.model = toModalModel (modesOnSurface (results, surface, order, settings), mapped);
    device.model.frequencyErrors.resize (0); // Nobody knows them.
    device.model.origin = { ModeSource::drawn };
    device.meshNodes = results.nodes();
    device.nodesOfSurface = surface.meshNodes;
    device.leftOut = static_cast<int> (results.modes.size() - order.size());
    device.withoutDamping = static_cast<int> (
        std::count_if (order.begin(), order.end(), [&] (auto k) { return ! (results.modes[k].dampingRatio > 0); }));
    device.mass = device.model.surface.masses.sum();

    if (results.totalMass > 0)
        device.totalMass = results.totalMass;

    if (! device.model.hasComplexModes() && device.model.surface.kind == SurfaceKind::plate)
        for (std::size_t i = 0; i < results.staticDisplacements.size(); ++i)
            device.staticErrors.push_back (
                staticError (device.model, static_cast<Eigen::Index> (i),
                             results.staticDisplacements[i](surface.nodes, settings.side.axis), settings.caseVoltage));

    addWarnings (device, settings.dampingRatio);
    return device;
}
} // namespace antinode
