#include "Waveforms.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_model/PlaceOnSurface.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
void requirePath (const Surface& surface, const TouchedPoint& point, const std::string& which)
{
    constexpr double fastest = 2, longest = 10; // m/s, m
    double length = 0;

    if (point.finger && ! point.path.empty())
        throw InputError (which + " finger", "moves, and so does its load; allowed: a path "
                                             "without a finger, or a finger that stays");

    for (std::size_t i = 0; i < point.path.size(); ++i)
    {
        const auto& to = point.path[i];
        const auto where = which + " path " + std::to_string (i + 1);
        requireOnSurface (surface, to.x, to.y, where);

        if (i == 0)
            continue;

        const auto& from = point.path[i - 1];
        const auto distance = std::hypot (to.x - from.x, to.y - from.y), duration = to.time - from.time;
        length += distance;

        if (! (duration > 0))
            throw InputError (where + " time", "is " + inWords (to.time * milli)
                                                   + " ms, not after the one before; "
                                                     "allowed: times that ascend");

        if (distance > fastest * duration)
            throw InputError (where, "is reached at " + inWords (distance / duration * milli)
                                         + " mm/s; allowed: " + inWords (fastest * milli) + " mm/s or less");
    }

    if (length > longest)
        throw InputError (which + " path",
                          "is " + inWords (length) + " m long; allowed: " + inWords (longest) + " m or less");
}

/** How far all points together have moved at the corners of their paths. */
struct Travel
{
    std::vector<double> times, distances; ///< Ascending, s; from the first time on, m.
};

Travel travelOf (const std::vector<TouchedPoint>& points)
{
    Travel travel;

    for (const auto& point : points)
        for (const auto& corner : point.path)
            travel.times.push_back (corner.time);

    std::sort (travel.times.begin(), travel.times.end());
    travel.times.erase (std::unique (travel.times.begin(), travel.times.end()), travel.times.end());

    for (std::size_t i = 0; i < travel.times.size(); ++i)
    {
        double distance = i > 0 ? travel.distances.back() : 0;

        for (const auto& point : points)
            if (i > 0)
            {
                const auto from = placeAt (point, travel.times[i - 1]), to = placeAt (point, travel.times[i]);
                distance += std::hypot (to.x - from.x, to.y - from.y);
            }

        travel.distances.push_back (distance);
    }

    return travel;
}
} // namespace

std::vector<TouchedPoint> touchedPoints (const WaveformsDescription& description)
{
    std::vector<TouchedPoint> points;

    for (const auto& track : description.tracks)
        points.push_back (track.point);

    points.insert (points.end(), description.silent.begin(), description.silent.end());
    return points;
}

std::vector<Finger> restingFingers (const WaveformsDescription& description)
{
    std::vector<Finger> fingers;

    for (const auto& point : touchedPoints (description))
        if (point.finger)
            fingers.push_back (*point.finger);

    return fingers;
}

std::string pointInWords (const WaveformsDescription& description, std::size_t point)
{
    const auto tracks = description.tracks.size();
    return point < tracks ? "track " + std::to_string (point + 1)
                          : "silent finger " + std::to_string (point - tracks + 1);
}

PathPoint placeAt (const TouchedPoint& point, double time)
{
    const auto& path = point.path;

    if (path.empty())
        return { time, point.x, point.y };

    const auto after =
        std::upper_bound (path.begin(), path.end(), time, [] (double t, const PathPoint& p) { return t < p.time; });

    if (after == path.begin() || after == path.end())
    {
        const auto& end = after == path.begin() ? path.front() : path.back();
        return { time, end.x, end.y };
    }

    const auto &from = *(after - 1), &to = *after;
    const auto share = (time - from.time) / (to.time - from.time);
    return { time, from.x + share * (to.x - from.x), from.y + share * (to.y - from.y) };
}

WaveformsDescription stillAt (const WaveformsDescription& description, double time)
{
    auto still = description;
    const auto stay = [&] (TouchedPoint& point)
    {
        const auto place = placeAt (point, time);
        point.x = place.x;
        point.y = place.y;
        point.path.clear();
    };

    for (auto& track : still.tracks)
        stay (track.point);

    for (auto& point : still.silent)
        stay (point);

    return still;
}

std::vector<double> timesOfPlaces (const WaveformsDescription& description, double step, int mostSteps)
{
    const auto travel = travelOf (touchedPoints (description));

    if (travel.times.empty())
        return { 0 };

    const auto steps = static_cast<int> (std::min<double> (mostSteps, std::ceil (travel.distances.back() / step)));
    std::vector<double> times { travel.times.front() };

    for (int i = 1; i <= steps; ++i)
    {
        const auto distance = travel.distances.back() * i / steps;
        const auto after = std::lower_bound (travel.distances.begin() + 1, travel.distances.end() - 1, distance)
                           - travel.distances.begin();
        const auto last = static_cast<std::size_t> (after);
        const auto span = travel.distances[last] - travel.distances[last - 1];
        const auto share = span > 0 ? std::min (1.0, (distance - travel.distances[last - 1]) / span) : 1;
        times.push_back (travel.times[last - 1] + share * (travel.times[last] - travel.times[last - 1]));
    }

    return times;
}

double tracksDuration (const WaveformsDescription& description)
{
    double duration = 0;

    for (const auto& track : description.tracks)
        duration = std::max (duration, track.start + signalDuration (track.signal));

    return duration;
}

void requirePlaces (const Surface& surface, const WaveformsDescription& description)
{
    const auto points = touchedPoints (description);

    for (std::size_t p = 0; p < points.size(); ++p)
    {
        const auto which = "waveforms: " + pointInWords (description, p);
        requireOnSurface (surface, points[p].x, points[p].y, which);
        requirePath (surface, points[p], which);
    }
}

Eigen::MatrixXd touchedShapes (const ModalModel& model, const WaveformsDescription& description)
{
    requirePlaces (model.surface, description);
    const auto points = touchedPoints (description);
    Eigen::MatrixXd shapes (static_cast<Eigen::Index> (points.size()), model.coordinates());

    for (std::size_t p = 0; p < points.size(); ++p)
        shapes.row (static_cast<Eigen::Index> (p)) = shapesAt (model, points[p].x, points[p].y);

    return shapes;
}
} // namespace antinode
