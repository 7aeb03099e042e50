#pragma once

#include "Waveforms.h"

#include <antinode_fingers/SkinThreshold.h>

namespace antinode
{
/** What the touched points are to do from the trigger to the end of the last track, at its levels; silence is 0.
    @return  N_s x points, m: the last sample not before the end
    @throws InputError  for a track without motion in the band
    [worker] Docs/Theory.md, section 4.13. */
Eigen::MatrixXd wantedMotion (const WaveformsDescription&, const SkinThreshold&, double sampleRate);
} // namespace antinode
