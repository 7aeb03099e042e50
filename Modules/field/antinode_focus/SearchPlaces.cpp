#include "SearchPlaces.h"

#include "FocalGeometry.h"

#include <antinode_base/Watch.h>
#include <antinode_model/ShapeInterpolation.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace antinode
{
namespace
{
Eigen::VectorXd evenPlaces (double from, double to, Eigen::Index points, double density)
{
    const auto count = std::max<Eigen::Index> (8, std::llround (density * static_cast<double> (points)));
    return Eigen::VectorXd::LinSpaced (count + 1, from, to);
}

/** Fills places and shapes of an even grid, column by column of modes. */
void placeEvenly (SearchPlaces& places, const ModalModel& model, double density)
{
    const auto& surface = model.surface;
    const auto& grid = *surface.grid;
    const auto x = evenPlaces (surface.xMinimum, surface.xMaximum, grid.x.places.size(), density);
    const auto y = evenPlaces (surface.yMinimum, surface.yMaximum, grid.y.places.size(), density);
    const auto rowsX = interpolationRows (grid.x, x), rowsY = interpolationRows (grid.y, y);
    places.steps = { x[1] - x[0], y[1] - y[0], 0 };
    places.shapes.resize (x.size() * y.size(), model.coordinates());

    for (const auto placeY : y)
        for (const auto placeX : x)
            places.starts.push_back ({ { placeX, placeY }, -1, 0 });

    for (Eigen::Index k = 0; k < model.coordinates(); ++k)
    {
        checkWatch();
        const Eigen::Map<const Eigen::MatrixXd> shape (model.shapes.col (k).data(), rowsX.cols(), rowsY.cols());
        const Eigen::MatrixXd half = rowsX * shape;
        Eigen::Map<Eigen::MatrixXd> (places.shapes.col (k).data(), x.size(), y.size()).noalias() =
            half * rowsY.transpose();
    }
}

/** Keeps some of the places. */
void keep (SearchPlaces& places, const std::function<bool (const FieldPeak&)>& isKept)
{
    std::vector<PeakStart> kept;
    std::vector<Eigen::Index> rows;

    for (std::size_t i = 0; i < places.starts.size(); ++i)
        if (isKept (places.starts[i].at))
        {
            kept.push_back (places.starts[i]);
            rows.push_back (static_cast<Eigen::Index> (i));
        }

    places.shapes = places.shapes (rows, Eigen::all).eval();
    places.starts = std::move (kept);
}

/** Appends places with their shapes. */
void append (SearchPlaces& places, const ModalModel& model, const std::vector<PeakStart>& more)
{
    const auto before = places.shapes.rows();
    places.shapes.conservativeResize (before + static_cast<Eigen::Index> (more.size()), Eigen::NoChange);

    for (std::size_t i = 0; i < more.size(); ++i)
    {
        places.shapes.row (before + static_cast<Eigen::Index> (i)) = shapesAt (model, more[i].at.x, more[i].at.y);
        places.starts.push_back (more[i]);
    }
}

/** Of even places those on the surface, and places all along its boundary: free edges move most. */
void bound (SearchPlaces& places, const ModalModel& model)
{
    const auto& surface = model.surface;
    keep (places, [&] (const FieldPeak& at) { return liesOn (surface, at.x, at.y); });
    std::vector<PeakStart> along;

    for (const auto& path : surface.boundary->outline.paths)
        for (const auto& piece : path)
        {
            const auto step = std::max (places.steps.x, places.steps.y);
            const auto count =
                static_cast<int> (std::ceil (std::min (1e4, piece.length (piece.from, piece.to) / step)));

            for (int i = 0; i < count; ++i)
            {
                const auto place = piece.at (piece.from + (piece.to - piece.from) * i / count);
                along.push_back ({ { place.x(), place.y() }, -1, 0 });
            }
        }

    append (places, model, along);
    places.alongBoundary = along.size();
}

void placeOnLine (SearchPlaces& places, const ModalModel& model, double density)
{
    const auto& surface = model.surface;
    const auto x = evenPlaces (surface.xMinimum, surface.xMaximum, surface.points.rows(), density);
    places.steps = { x[1] - x[0], 0, 0 };
    places.shapes.resize (x.size(), model.coordinates());

    for (Eigen::Index i = 0; i < x.size(); ++i)
    {
        places.starts.push_back ({ { x[i], 0 }, -1, 0 });
        places.shapes.row (i) = shapesAt (model, x[i], 0);
    }
}

void placeOnPoints (SearchPlaces& places, const ModalModel& model)
{
    const auto& surface = model.surface;
    const auto perSide = std::sqrt (static_cast<double> (surface.points.rows()));
    places.steps = { (surface.xMaximum - surface.xMinimum) / perSide, (surface.yMaximum - surface.yMinimum) / perSide,
                     0 };
    places.shapes = model.shapes;

    for (const auto& point : surface.points.rowwise())
        places.starts.push_back ({ { point[0], point[1] }, -1, 0 });
}

void leaveOut (SearchPlaces& places, const Surface& surface, const std::vector<FocalSpot>& spots)
{
    const auto isLine = surface.kind == SurfaceKind::line;
    keep (places, [&] (const FieldPeak& at) { return liesOutside (spots, isLine, at.x, at.y); });
}

/** How many places the boundary of a spot has: two on a line. */
int boundaryPlaces (const FocalSpot& spot, const SearchPlaces& places, bool isLine)
{
    constexpr double fewest = 32, most = 360;
    const auto around = std::numbers::pi * (spot.radiusX + spot.radiusY);
    return isLine ? 2
                  : static_cast<int> (
                      std::clamp (std::ceil (around / std::min (places.steps.x, places.steps.y)), fewest, most));
}

void addBoundaries (SearchPlaces& places, const ModalModel& model, const std::vector<FocalSpot>& spots)
{
    const auto isLine = model.surface.kind == SurfaceKind::line;
    std::vector<PeakStart> more;

    for (std::size_t s = 0; s < spots.size(); ++s)
    {
        const auto count = boundaryPlaces (spots[s], places, isLine);

        for (int i = 0; i < count; ++i)
        {
            const auto angle = 2 * std::numbers::pi * i / count;
            const auto at = placeOnBoundary (spots[s], angle);

            if (! liesOn (model.surface, at.x, at.y) || ! liesOutside (spots, isLine, at.x, at.y))
                continue;

            more.push_back ({ at, static_cast<int> (s), angle });
        }
    }

    append (places, model, more);
}
} // namespace

SearchPlaces searchPlaces (const ModalModel& model, double density, const std::vector<FocalSpot>& outside)
{
    SearchPlaces places;

    if (model.surface.kind == SurfaceKind::line)
        placeOnLine (places, model, density);
    else if (model.surface.grid)
        placeEvenly (places, model, density);
    else
        placeOnPoints (places, model);

    if (model.surface.boundary && model.surface.grid)
        bound (places, model);

    if (! outside.empty())
    {
        leaveOut (places, model.surface, outside);
        addBoundaries (places, model, outside);
    }

    return places;
}
} // namespace antinode
