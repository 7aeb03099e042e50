#include "TracksAt.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>

#include <string>

namespace antinode
{
namespace
{
/** @throws InputError  for a point that moves */
void putAt (TouchedPoint& point, const std::pair<double, double>& place)
{
    if (! point.path.empty())
        throw InputError ("--at", "gives a place to a track with a path; allowed: tracks that stay");

    point.x = place.first;
    point.y = place.second;

    if (point.finger)
    {
        point.finger->x = point.x;
        point.finger->y = point.y;
    }
}

} // namespace

std::vector<Field> fields (TracksAt& at)
{
    return {
        Field ("--at",
               NumberRows { "X or X,Y in mm, for example 38,30", 1, 2, true,
                            [&at] (const auto& place)
                            { at.places.emplace_back (place[0] / milli, place.size() > 1 ? place[1] / milli : 0); } },
               "Place of a track, mm, in their order; a single track is played at each place (repeatable)")
            .as ("at_mm")
            .written ("X,Y", ',')
            .by ("the places of the waveforms"),
        Field ("--level-db-sl", &at.sensation,
               "Level of the tracks, of haptic content at intensity 1, dB over threshold")
            .as ("level_dB_SL")
            .within (-60, 120)
            .by ("that of the waveforms, else 25"),
        Field ("--level-um", &at.displacement, "The same as the largest displacement, um")
            .in (micro)
            .within (1e-6, 1e6)
            .by ("that of the waveforms")
            .without ("--level-db-sl"),
    };
}

WaveformsDescription placedWaveforms (WaveformsDescription waveforms, const TracksAt& at)
{
    auto& tracks = waveforms.tracks;
    const auto& places = at.places;

    if (! places.empty() && tracks.size() == 1)
        tracks.resize (places.size(), Track (tracks.front()));

    if (! places.empty() && places.size() != tracks.size())
        throw InputError ("--at", "gives " + std::to_string (places.size())
                                      + " places; allowed: " + std::to_string (tracks.size()) + ", one per track");

    for (std::size_t i = 0; i < places.size(); ++i)
        putAt (tracks[i].point, places[i]);

    for (auto& track : tracks)
        for (auto& event : track.events)
            if (at.displacement)
                event.level = { LevelKind::displacement, *at.displacement };
            else if (at.sensation)
                event.level = { LevelKind::sensation, *at.sensation };

    return withSummedTracks (std::move (waveforms));
}
} // namespace antinode
