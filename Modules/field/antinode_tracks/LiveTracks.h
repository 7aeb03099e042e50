#pragma once

#include "FingerFilters.h"

namespace antinode
{
/** What designTracks gives, by filters that play live: its tracks are inputs, and voltages follow them.
    @throws InputError  as designFingerFilters and wantedAsPlayed, and for tracks that need more than 1 GiB
    @throws TrackLimitError  for levels beyond the limits
    @throws Cancelled   when a watch of this thread says no
    [worker] Docs/Theory.md, section 4.16. */
TrackDesign designLiveTracks (const ModalModel&, const WaveformsDescription&, const TrackSettings&,
                              const ShowProgress& progress = {});

/** The same by filters that are there.
    @param filters  of the tracks and silent fingers of the description, in their order
    [worker] */
TrackDesign liveTracks (const ModalModel&, const WaveformsDescription&, const TrackSettings&, const FingerFilters&);
} // namespace antinode
