#include "IdentifiedModel.h"

#include <antinode_base/InputError.h>
#include <antinode_model/Surface.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace antinode
{
namespace
{
/** Largest part of a shape that another one may seem to hold where the points cover the whole body. */
constexpr double minimumOverlap = 0.02;

bool isLine (const Eigen::MatrixX2d& points)
{
    return points.col (1).maxCoeff() - points.col (1).minCoeff() <= 1e-9;
}

/** Points with data, on a line ascending in x. */
std::vector<Eigen::Index> usedPoints (const IdentifiedModes& modes)
{
    std::vector<Eigen::Index> used;

    for (Eigen::Index p = 0; p < modes.points.rows(); ++p)
        if (modes.shapes.row (p).allFinite())
            used.push_back (p);

    if (used.empty())
        throw InputError ("identified modes", "have no point with data");

    if (isLine (modes.points (used, Eigen::all)))
        std::stable_sort (used.begin(), used.end(),
                          [&modes] (auto a, auto b) { return modes.points (a, 0) < modes.points (b, 0); });

    return used;
}

void checkDistances (const Eigen::MatrixX2d& points)
{
    for (Eigen::Index p = 0; p < points.rows(); ++p)
        for (Eigen::Index q = 0; q < p; ++q)
            if ((points.row (p) - points.row (q)).norm() < 1e-9)
                throw InputError ("points " + std::to_string (q + 1) + " and " + std::to_string (p + 1),
                                  "have the same position; allowed: distinct positions");
}

Surface makeSurface (const Eigen::MatrixX2d& points)
{
    checkDistances (points);
    Surface surface;
    surface.kind = isLine (points) ? SurfaceKind::line : SurfaceKind::plate;
    surface.points = points;
    surface.xMinimum = points.col (0).minCoeff();
    surface.xMaximum = points.col (0).maxCoeff();

    if (surface.kind == SurfaceKind::line)
    {
        surface.points.col (1).setZero();
        surface.areas = lineCells (points.col (0));
        return surface;
    }

    surface.yMinimum = points.col (1).minCoeff();
    surface.yMaximum = points.col (1).maxCoeff();
    surface.areas = voronoiCells (points);
    return surface;
}

/** Masses proportional to the areas, so that the median shape has modal mass 1. */
Eigen::VectorXd massesByShapes (const Eigen::MatrixXd& shapes, const Eigen::VectorXd& areas)
{
    const Eigen::VectorXd modalAreas = shapes.cwiseAbs2().transpose() * areas;
    std::vector<double> sorted (modalAreas.begin(), modalAreas.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t> (sorted.size() / 2);
    std::nth_element (sorted.begin(), middle, sorted.end());
    return areas / std::max (*middle, 1e-300);
}

bool areOrthonormal (const Eigen::MatrixXd& shapes, const Eigen::VectorXd& masses)
{
    const Eigen::MatrixXd gram = shapes.transpose() * masses.asDiagonal() * shapes;
    return (gram - Eigen::MatrixXd::Identity (gram.rows(), gram.cols())).cwiseAbs().maxCoeff() < minimumOverlap;
}

std::vector<Ceramic> makeCeramics (const IdentifiedModes& modes, const MappedSurface& mapped)
{
    if (! mapped.ceramics.empty())
        return mapped.ceramics;

    std::vector<Ceramic> ceramics;

    for (const auto& reference : modes.references)
    {
        Ceramic ceramic;
        ceramic.name = reference.name;
        ceramic.voltageLimit = mapped.voltageLimit;
        ceramics.push_back (ceramic);
    }

    return ceramics;
}

/** Real parts, and of complex modes imaginary parts behind them. */
void takeShapes (ModalModel& model, const IdentifiedModes& modes, const std::vector<Eigen::Index>& used)
{
    model.shapes = modes.shapes (used, Eigen::all);
    model.participation = modes.participation;

    if (modes.complexShapes.size() == 0)
        return;

    const Eigen::MatrixXcd shapes = modes.complexShapes (used, Eigen::all);
    model.shapes.resize (shapes.rows(), 2 * shapes.cols());
    model.shapes << shapes.real(), shapes.imag();
    model.participation.resize (2 * shapes.cols(), modes.complexParticipation.cols());
    model.participation << modes.complexParticipation.real(), modes.complexParticipation.imag();
}

/** Of real modes, where it is known at all points. */
Eigen::MatrixXd staticShareOf (const IdentifiedModes& modes, const std::vector<Eigen::Index>& used)
{
    if (modes.staticShare.size() == 0 || modes.complexShapes.size() > 0)
        return {};

    Eigen::MatrixXd share = modes.staticShare (used, Eigen::all);
    return share.allFinite() ? share : Eigen::MatrixXd();
}

/** How far the shape and participation of the middle mode are off, RMS over RMS: by their deviations, or by all that
   the modes leave of the responses where nobody knows these. */
double unexplainedShare (const IdentifiedModes& modes, const std::vector<Eigen::Index>& used)
{
    const auto& deviations = modes.deviations;
    std::vector<double> errors;

    if (deviations.shapes.cols() == modes.modes() && deviations.participation.rows() == modes.modes())
        for (Eigen::Index k = 0; k < modes.modes(); ++k)
            errors.push_back (
                std::hypot (deviations.shapes (used, k).norm() / modes.shapes (used, k).norm(),
                            deviations.participation.row (k).norm() / modes.participation.row (k).norm()));

    const auto areKnown =
        std::all_of (errors.begin(), errors.end(), [] (double error) { return std::isfinite (error); });

    return areKnown && ! errors.empty() ? std::min (1.0, median (std::move (errors)))
                                        : std::pow (10.0, std::min (0.0, modes.reconstructionError) / 20);
}

void check (const IdentifiedModes& modes, const MappedSurface& mapped)
{
    if (modes.drive != DriveQuantity::voltage)
        throw InputError ("identified modes", "were excited by forces; allowed for a device: voltages of ceramics");

    if (! mapped.ceramics.empty() && mapped.ceramics.size() != modes.references.size())
        throw InputError ("ceramics", "are " + std::to_string (mapped.ceramics.size())
                                          + "; allowed: one for each of the " + std::to_string (modes.references.size())
                                          + " references");

    if (mapped.masses.size() != 0 && mapped.masses.size() != modes.points.rows())
        throw InputError ("masses", "are " + std::to_string (mapped.masses.size()) + "; allowed: one for each of the "
                                        + std::to_string (modes.points.rows()) + " points");
}
} // namespace

ModalModel toModalModel (const IdentifiedModes& modes, const MappedSurface& mapped)
{
    check (modes, mapped);
    const auto used = usedPoints (modes);
    ModalModel model;
    model.name = mapped.name;
    model.surface = makeSurface (modes.points (used, Eigen::all));

    if (mapped.boundary)
    {
        model.surface = boundedBy (model.surface, *mapped.boundary);
        model.surface.areas = voronoiCells (model.surface.points, mapped.boundary->outline);
    }

    model.angularFrequencies = modes.angularFrequencies;
    model.dampingRatios = modes.dampingRatios;
    takeShapes (model, modes, used);
    model.staticShare = staticShareOf (modes, used);
    model.ceramics = makeCeramics (modes, mapped);
    model.fullScaleVoltage = mapped.fullScaleVoltage;
    model.surface.masses = mapped.masses.size() > 0
                               ? Eigen::VectorXd (mapped.masses (used))
                               : massesByShapes (model.shapes.leftCols (modes.modes()), model.surface.areas);
    model.coversWholeBody = ! model.hasComplexModes()
                            && mapped.coversWholeBody.value_or (areOrthonormal (model.shapes, model.surface.masses));
    model.frequencyErrors = modes.deviations.angularFrequencies.cwiseQuotient (modes.angularFrequencies);
    model.warnings = modes.warnings;
    model.origin = { ModeSource::measured, static_cast<int> (used.size()), unexplainedShare (modes, used),
                     modes.scaling != ShapeScaling::convention };

    if (model.surface.kind == SurfaceKind::line && model.points() > 1)
        model = withSplineSlopes (std::move (model));

    validate (model);
    return model;
}

namespace
{
using Polygon = std::vector<Eigen::Vector2d>;

/** The part of a convex polygon where normal . (x - origin) <= 0. */
Polygon clipped (const Polygon& polygon, const Eigen::Vector2d& origin, const Eigen::Vector2d& normal)
{
    Polygon result;

    for (std::size_t n = 0; n < polygon.size(); ++n)
    {
        const auto& from = polygon[n];
        const auto& to = polygon[(n + 1) % polygon.size()];
        const auto heightFrom = normal.dot (from - origin), heightTo = normal.dot (to - origin);

        if (heightFrom <= 0)
            result.push_back (from);

        if ((heightFrom < 0 && heightTo > 0) || (heightFrom > 0 && heightTo < 0))
            result.push_back (from + heightFrom / (heightFrom - heightTo) * (to - from));
    }

    return result;
}

double polygonArea (const Polygon& polygon)
{
    double twice = 0;

    for (std::size_t n = 0; n < polygon.size(); ++n)
    {
        const auto& from = polygon[n];
        const auto& to = polygon[(n + 1) % polygon.size()];
        twice += from.x() * to.y() - from.y() * to.x();
    }

    return twice / 2;
}
/** The Voronoi cell of a point within a rectangle, counter-clockwise. */
Polygon cellOf (const Eigen::MatrixX2d& points, Eigen::Index p, const Eigen::Vector2d& lower,
                const Eigen::Vector2d& upper)
{
    Polygon cell { lower, { upper.x(), lower.y() }, upper, { lower.x(), upper.y() } };
    const Eigen::Vector2d here = points.row (p);

    for (Eigen::Index q = 0; q < points.rows() && ! cell.empty(); ++q)
        if (const Eigen::Vector2d there = points.row (q); q != p)
            cell = clipped (cell, (here + there) / 2, there - here);

    return cell;
}

Polygon asPolygon (const ClosedPath& path)
{
    constexpr int chords = 16;
    Polygon polygon;

    for (const auto& piece : path)
        for (int i = 0; i < (piece.isStraight ? 1 : chords); ++i)
            polygon.push_back (piece.at (piece.from + (piece.to - piece.from) * i / chords));

    return polygon;
}

/** What a convex cell, counter-clockwise, has of any polygon. */
double areaWithin (Polygon polygon, const Polygon& cell)
{
    for (std::size_t n = 0; n < cell.size(); ++n)
    {
        const Eigen::Vector2d along = cell[(n + 1) % cell.size()] - cell[n];
        polygon = clipped (polygon, cell[n], { along.y(), -along.x() });
    }

    return cell.empty() ? 0 : std::abs (polygonArea (polygon));
}
} // namespace

Eigen::VectorXd lineCells (const Eigen::VectorXd& x)
{
    const auto points = x.size();
    Eigen::VectorXd result = Eigen::VectorXd::Zero (points);

    if (points == 1)
        return Eigen::VectorXd::Ones (1);

    for (Eigen::Index p = 0; p + 1 < points; ++p)
    {
        const auto half = (x[p + 1] - x[p]) / 2;
        result[p] += half;
        result[p + 1] += half;
    }

    return result;
}

Eigen::VectorXd voronoiCells (const Eigen::MatrixX2d& points)
{
    const Eigen::Vector2d lower = points.colwise().minCoeff(), upper = points.colwise().maxCoeff();
    Eigen::VectorXd result (points.rows());

    for (Eigen::Index p = 0; p < points.rows(); ++p)
        result[p] = polygonArea (cellOf (points, p, lower, upper));

    return result;
}

Eigen::VectorXd voronoiCells (const Eigen::MatrixX2d& points, const Outline& outline)
{
    const auto extent = extentOf (outline);
    const Eigen::Vector2d lower = extent.least.cwiseMin (points.colwise().minCoeff().transpose());
    const Eigen::Vector2d upper = extent.largest.cwiseMax (points.colwise().maxCoeff().transpose());
    std::vector<Polygon> paths;

    for (const auto& path : outline.paths)
        paths.push_back (asPolygon (path));

    Eigen::VectorXd result (points.rows());

    for (Eigen::Index p = 0; p < points.rows(); ++p)
    {
        const auto cell = cellOf (points, p, lower, upper);
        result[p] = areaWithin (paths.front(), cell);

        for (std::size_t hole = 1; hole < paths.size(); ++hole)
            result[p] -= areaWithin (paths[hole], cell);

        result[p] = std::max (result[p], 0.0); // rounding
    }

    return result;
}
} // namespace antinode
