#include "PeakSearch.h"

#include <Eigen/Cholesky>
#include <antinode_base/Watch.h>
#include <antinode_model/ShapeInterpolation.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
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

namespace
{
constexpr auto nowhere = -std::numeric_limits<double>::infinity();
constexpr double minimumScale = 0.01; // of a step: some 1e-6 of a peak
constexpr int maximumRounds = 60;

/** A place and its height. */
struct Reached
{
    Eigen::VectorXd at;
    double height = nowhere;
};

/** The best of the neighbourhood and of the top of the parabola through it. */
Reached stepUp (const std::function<double (const Eigen::VectorXd&)>& height, const Reached& from,
                const Eigen::VectorXd& steps)
{
    const auto n = steps.size();
    auto best = from;
    const auto look = [&] (const Eigen::VectorXd& move)
    {
        Eigen::VectorXd at = from.at + steps.cwiseProduct (move);
        const auto value = height (at);

        if (value > best.height)
            best = { std::move (at), value };

        return value;
    };
    Eigen::VectorXd gradient (n);
    Eigen::MatrixXd curvature (n, n);
    const auto unit = [n] (Eigen::Index i) -> Eigen::VectorXd { return Eigen::VectorXd::Unit (n, i); };

    for (Eigen::Index i = 0; i < n; ++i)
    {
        const auto up = look (unit (i)), down = look (-unit (i));
        gradient[i] = 0.5 * (up - down);
        curvature (i, i) = 2 * from.height - up - down;

        for (Eigen::Index j = 0; j < i; ++j)
            curvature (i, j) = 0.25
                               * (look (unit (i) - unit (j)) + look (unit (j) - unit (i)) - look (unit (i) + unit (j))
                                  - look (-unit (i) - unit (j)));
    }

    if (const Eigen::LLT<Eigen::MatrixXd> factor (curvature);
        gradient.allFinite() && curvature.allFinite() && factor.info() == Eigen::Success)
        look (factor.solve (gradient).cwiseMax (-2).cwiseMin (2));

    return best;
}

/** What a search may change, as a vector, and the place and time that it stands for. */
class Directions
{
public:
    Directions (const PeakStart& start, const PeakSteps& steps, const PeakExtent& extentToUse)
        : begin (start), extent (extentToUse), isLine (extent.surface.kind == SurfaceKind::line)
    {
        if (start.spot < 0)
            add (start.at.x, steps.x);

        if (start.spot < 0 && ! isLine)
            add (start.at.y, steps.y);

        if (start.spot >= 0 && ! isLine)
            add (start.angle, steps.x / std::max (spot().radiusX, spot().radiusY));

        if (steps.time > 0)
            add (start.at.time, steps.time);
    }

    FieldPeak at (const Eigen::VectorXd& values) const
    {
        auto peak = begin.at;
        Eigen::Index next = 0;

        if (begin.spot < 0)
            peak.x = std::clamp (values[next++], extent.surface.xMinimum, extent.surface.xMaximum);

        if (begin.spot < 0 && ! isLine)
            peak.y = std::clamp (values[next++], extent.surface.yMinimum, extent.surface.yMaximum);

        if (begin.spot < 0 && extent.surface.boundary)
        {
            const auto on = nearestOn (extent.surface, peak.x, peak.y);
            peak.x = on.x();
            peak.y = on.y();
        }

        if (begin.spot >= 0 && ! isLine)
            peak = placeOnBoundary (spot(), values[next++]);

        peak.time = next < values.size() ? std::clamp (values[next], extent.firstTime, extent.lastTime) : begin.at.time;
        return peak;
    }

    /** Whether a place counts: boundaries must not leave the surface, nor enter another spot. */
    bool isAllowed (const FieldPeak& peak) const
    {
        return liesOn (extent.surface, peak.x, peak.y) && liesOutside (extent.outside, isLine, peak.x, peak.y);
    }

    bool isOnBoundary() const { return begin.spot >= 0; }

    Eigen::VectorXd from, steps;

private:
    const FocalSpot& spot() const { return extent.outside[static_cast<std::size_t> (begin.spot)]; }

    void add (double value, double step)
    {
        from.conservativeResize (from.size() + 1);
        steps.conservativeResize (steps.size() + 1);
        from[from.size() - 1] = value;
        steps[steps.size() - 1] = step;
    }

    const PeakStart& begin;
    const PeakExtent& extent;
    bool isLine;
};
} // namespace

std::vector<PeakStart> chooseStarts (std::vector<PeakStart> starts, const PeakSteps& steps, double share,
                                     std::size_t most)
{
    constexpr double apart = 2; // steps
    const auto size = [] (const PeakStart& start) { return std::abs (start.at.velocity); };
    std::stable_sort (starts.begin(), starts.end(),
                      [&] (const PeakStart& a, const PeakStart& b) { return size (a) > size (b); });
    std::vector<PeakStart> chosen;
    const auto isNear = [&] (const FieldPeak& a, const FieldPeak& b)
    {
        return std::abs (a.x - b.x) <= apart * steps.x && std::abs (a.y - b.y) <= apart * steps.y
               && std::abs (a.time - b.time) <= apart * steps.time;
    };

    for (const auto& start : starts)
    {
        if (chosen.size() == most || size (start) < share * size (starts.front()))
            break;

        if (std::none_of (chosen.begin(), chosen.end(),
                          [&] (const PeakStart& other)
                          { return other.spot == start.spot && isNear (other.at, start.at); }))
            chosen.push_back (start);
    }

    return chosen;
}

Eigen::VectorXd climb (const std::function<double (const Eigen::VectorXd&)>& height, const Eigen::VectorXd& from,
                       const Eigen::VectorXd& steps)
{
    Reached reached { from, height (from) };
    double scale = 1;

    for (int round = 0; round < maximumRounds && scale >= minimumScale; ++round)
    {
        auto next = stepUp (height, reached, scale * steps);
        const auto isFar = next.height > reached.height
                           && ((next.at - reached.at).cwiseQuotient (steps)).cwiseAbs().maxCoeff() > 0.5 * scale;
        reached = std::move (next);

        if (! isFar)
            scale *= 0.3;
    }

    return reached.at;
}

FieldPeak climbToPeak (const VelocityFunction& velocity, const std::vector<PeakStart>& starts, const PeakSteps& steps,
                       const PeakExtent& extent)
{
    FieldPeak largest;

    for (const auto& start : starts)
    {
        checkWatch();
        const Directions directions (start, steps, extent);
        const auto sign = start.at.velocity < 0 ? -1.0 : 1.0;
        const auto height = [&] (const Eigen::VectorXd& values)
        {
            const auto at = directions.at (values);
            return directions.isOnBoundary() && ! directions.isAllowed (at) ? nowhere
                                                                            : sign * velocity (at.x, at.y, at.time);
        };
        auto peak = directions.at (directions.steps.size() > 0 ? climb (height, directions.from, directions.steps)
                                                               : directions.from);
        peak.velocity = velocity (peak.x, peak.y, peak.time);

        if (directions.isAllowed (peak) && std::abs (peak.velocity) > std::abs (largest.velocity))
            largest = peak;
    }

    return largest;
}

namespace
{
bool liesIn (const FocalSpot& spot, bool isLine, double x, double y)
{
    constexpr double onBoundary = 1 - 1e-9;
    return std::hypot ((x - spot.x) / spot.radiusX, isLine ? 0.0 : (y - spot.y) / spot.radiusY) < onBoundary;
}
} // namespace

bool liesOutside (const std::vector<FocalSpot>& spots, bool isLine, double x, double y)
{
    return std::none_of (spots.begin(), spots.end(),
                         [&] (const FocalSpot& spot) { return liesIn (spot, isLine, x, y); });
}

FieldPeak placeOnBoundary (const FocalSpot& spot, double angle)
{
    return { spot.x + spot.radiusX * std::cos (angle), spot.y + spot.radiusY * std::sin (angle) };
}
} // namespace antinode
