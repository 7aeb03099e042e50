#pragma once

#include "PointResponses.h"
#include "Waveforms.h"

#include <vector>

namespace antinode
{
/** What rests on the surface at the touched points. [worker] */
std::vector<SurfaceLoad> touchedLoads (const ModalModel&, const WaveformsDescription&);

/** Checks that there are no more touched points than ceramics: the surface can move so many each in its own way.
    @throws InputError  how many there are, and how many are allowed
    [any] */
void requireEnoughCeramics (const ModalModel&, const WaveformsDescription&);

/** Checks that no two touched points are so near to each other, at places every 3 mm of their ways, that over most of
   the band they move alike to within 5 %.
    @throws InputError  naming the points, their distance and the least that is allowed; as requirePlaces
    @throws Cancelled   when a watch of this thread says no
    [worker] */
void requireDistinctPoints (const ModalModel&, const WaveformsDescription&);
} // namespace antinode
