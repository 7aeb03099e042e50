#pragma once

#include "PointResponses.h"
#include "Waveforms.h"

#include <vector>

namespace antinode
{
/** What rests on the surface at the touched points. [worker] */
std::vector<SurfaceLoad> touchedLoads (const ModalModel&, const WaveformsDescription&);

/** Checks that the surface can move the touched points each in its own way: no more points than ceramics, and no two so
    near to each other, wherever they move, that over most of the band they move alike to within 5 %.
    @throws InputError  naming the points, their distance and the least that is allowed
    [worker] */
void requireDistinctPoints (const ModalModel&, const WaveformsDescription&);
} // namespace antinode
