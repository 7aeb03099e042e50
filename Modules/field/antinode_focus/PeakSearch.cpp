#include "PeakSearch.h"

#include "FocalGeometry.h"

#include <antinode_base/Watch.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
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
} // namespace antinode
