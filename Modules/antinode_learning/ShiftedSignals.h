#pragma once

#include "PlayedRecording.h"

namespace antinode
{
/** The signals of a recording, earlier by a delay: samples x N, one column per sensor. Near the ends, 128 samples, the
   signals are rounded off where they are cut.
    @param delay    s, 0 or more
    @param samples  how many, of the first
    [worker] */
Eigen::MatrixXd signalsEarlier (const PlayedRecording&, double delay, Eigen::Index samples);

/** How many samples of a recording can be compared with a prediction: the last ones, of the length of its delay, answer
    to voltages before its end only. [any] */
Eigen::Index comparableSamples (const PlayedRecording&);
} // namespace antinode
