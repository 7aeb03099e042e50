#include "Waveforms.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>

namespace antinode
{
namespace
{
void requireInside (double value, double minimum, double maximum, const std::string& where)
{
    if (! (value >= minimum && value <= maximum))
        throw InputError (where, "is " + inWords (value * milli) + " mm, outside the surface; allowed: "
                                     + inWords (minimum * milli) + " to " + inWords (maximum * milli) + " mm");
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

std::string pointInWords (const WaveformsDescription& description, std::size_t point)
{
    const auto tracks = description.tracks.size();
    return point < tracks ? "track " + std::to_string (point + 1)
                          : "silent finger " + std::to_string (point - tracks + 1);
}

double tracksDuration (const WaveformsDescription& description)
{
    double duration = 0;

    for (const auto& track : description.tracks)
        duration = std::max (duration, track.start + signalDuration (track.signal));

    return duration;
}

Eigen::MatrixXd touchedShapes (const ModalModel& model, const WaveformsDescription& description)
{
    const auto& surface = model.surface;
    const auto points = touchedPoints (description);
    Eigen::MatrixXd shapes (static_cast<Eigen::Index> (points.size()), model.coordinates());

    for (std::size_t p = 0; p < points.size(); ++p)
    {
        const auto which = "waveforms: " + pointInWords (description, p);
        requireInside (points[p].x, surface.xMinimum, surface.xMaximum, which + " x");

        if (surface.kind == SurfaceKind::plate)
            requireInside (points[p].y, surface.yMinimum, surface.yMaximum, which + " y");
        else
            requireInside (points[p].y, 0, 0, which + " y");

        shapes.row (static_cast<Eigen::Index> (p)) = shapesAt (model, points[p].x, points[p].y);
    }

    return shapes;
}
} // namespace antinode
