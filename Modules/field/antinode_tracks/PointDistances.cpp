#include "PointDistances.h"

#include "PointResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_numerics/Median.h>

#include <cmath>
#include <optional>
#include <string>

namespace antinode
{
namespace
{
constexpr double leastDifference = 0.05;  // of the motion of two points: less cannot be told apart
constexpr double lookedAgainAfter = 3e-3; // m that points move
constexpr double distanceStep = 2.5e-4;   // m, in which the least distance is looked for

/** How much of the motion of each pair is its own, the median over the band: 0 where two points move alike. */
double differenceOf (const PointResponses& responses, TrackBand band, Eigen::Index p, Eigen::Index q)
{
    const auto step = responses.sampleRate / static_cast<double> (responses.length);
    std::vector<double> shares;

    for (auto line = static_cast<Eigen::Index> (std::ceil (band.lower / step));
         line <= static_cast<Eigen::Index> (band.upper / step); ++line)
    {
        const auto response = responses.atLine (line);
        const auto alike = std::norm (response.row (p).dot (response.row (q)));
        const auto both = response.row (p).squaredNorm() * response.row (q).squaredNorm();
        shares.push_back (both > 0 ? std::sqrt (std::max (0.0, 1 - alike / both)) : 0);
    }

    return median (shares);
}

/** The responses at lines 10 Hz apart: enough to compare points by. */
PointResponses coarseResponses (const ModalModel& model, const Eigen::MatrixXd& shapes, TrackBand band)
{
    constexpr double spacing = 10; // Hz
    const auto rate = 4 * band.upper;
    return pointResponses (model, shapes, {}, rate, 2 * static_cast<Eigen::Index> (std::ceil (rate / spacing / 2)));
}

/** The least distance from a point, in a direction, at which another one is told apart; none on the surface. */
std::optional<double> leastDistance (const ModalModel& model, TrackBand band, const TouchedPoint& from,
                                     const TouchedPoint& to)
{
    const auto distance = std::hypot (to.x - from.x, to.y - from.y);
    const auto alongX = distance > 0 ? (to.x - from.x) / distance : 1;
    const auto alongY = distance > 0 ? (to.y - from.y) / distance : 0;
    const auto& surface = model.surface;

    for (auto far = distanceStep * (std::floor (distance / distanceStep) + 1);; far += distanceStep)
    {
        const auto x = from.x + far * alongX, y = from.y + far * alongY;

        if (! liesOn (surface, x, y))
            return {};

        Eigen::MatrixXd shapes (2, model.coordinates());
        shapes << shapesAt (model, from.x, from.y), shapesAt (model, x, y);

        if (differenceOf (coarseResponses (model, shapes, band), band, 0, 1) >= leastDifference)
            return far;
    }
}

/** The same of points that stay. @param when  for messages */
void requireDistinct (const ModalModel& model, const WaveformsDescription& description, const std::string& when)
{
    const auto points = touchedPoints (description);
    const auto responses = coarseResponses (model, touchedShapes (model, description), description.band);

    for (std::size_t q = 1; q < points.size(); ++q)
        for (std::size_t p = 0; p < q; ++p)
            if (differenceOf (responses, description.band, static_cast<Eigen::Index> (p), static_cast<Eigen::Index> (q))
                < leastDifference)
            {
                const auto least = leastDistance (model, description.band, points[p], points[q]);
                const auto distance = std::hypot (points[q].x - points[p].x, points[q].y - points[p].y);
                throw InputError (
                    "waveforms: " + pointInWords (description, q),
                    "is " + inWords (distance * milli) + " mm from " + pointInWords (description, p) + when
                        + ", too near for the surface to move them apart"
                        + (least ? "; allowed: " + inWords (*least * milli) + " mm or more in this direction"
                                 : "; allowed: another place"));
            }
}
} // namespace

std::vector<SurfaceLoad> touchedLoads (const ModalModel& model, const WaveformsDescription& description)
{
    std::vector<SurfaceLoad> loads;

    for (const auto& point : touchedPoints (description))
        if (const auto& finger = point.finger; finger && finger->isKnown)
        {
            requireKnownScale (model, "fingers");
            loads.push_back ({ contactShapes (model, *finger), finger->mass, finger->damping, finger->stiffness });
        }

    return loads;
}

void requireEnoughCeramics (const ModalModel& model, const WaveformsDescription& description)
{
    const auto points = description.tracks.size() + description.silent.size();

    if (static_cast<Eigen::Index> (points) > model.actuators())
        throw InputError ("waveforms", "touch " + std::to_string (points) + " points; allowed: at most "
                                           + std::to_string (model.actuators()) + ", one per ceramic");
}

void requireDistinctPoints (const ModalModel& model, const WaveformsDescription& description)
{
    const auto times = timesOfPlaces (description, lookedAgainAfter);
    auto places = description;

    for (auto& track : places.tracks)
        track.signal = {}; // A recording is long, and would be copied every time.

    for (const auto time : times)
        requireDistinct (model, stillAt (places, time),
                         times.size() > 1 ? " at " + inWords (time * milli) + " ms" : std::string());
}
} // namespace antinode
