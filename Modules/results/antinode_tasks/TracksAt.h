#pragma once

#include "Field.h"

#include <antinode_tracks/Waveforms.h>

#include <optional>
#include <utility>
#include <vector>

namespace antinode
{
/** Where tracks are played and how strongly, in place of what their waveforms say. */
struct TracksAt
{
    std::vector<std::pair<double, double>>
        places;                         ///< m: of the tracks, in their order; of one track any number of copies.
    std::optional<double> displacement; ///< m: the level of all events, times their amplitudes.
    std::optional<double> sensation;    ///< dB over threshold: the same.
};

/** [any] */
std::vector<Field> fields (TracksAt&);

/** Waveforms at these places and with this level. @throws InputError  for another number of places than of tracks, a
   place for a track with a path [any] */
WaveformsDescription placedWaveforms (WaveformsDescription, const TracksAt&);
} // namespace antinode
