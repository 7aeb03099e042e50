#pragma once

#include "EstimatedResponses.h"
#include "HammerHits.h"

namespace antinode
{
/** Lines that all recordings of a test share. */
struct HammerLines
{
    Eigen::Index first = 1, last = 1; ///< Of a block's transform.
    Eigen::VectorXd frequencies;      ///< Hz
};

/** The magnitude of the force of all usable hits, from line 0 to half the sample rate, N s: block / 2 + 1 effective
   values over the hits. [worker] */
Eigen::VectorXd forceMagnitude (const std::vector<HammerRecording>&, const HammerTest&);

/** The lines up to the first one at which the mean force is 30 dB below its largest, or to a limit.
    @param lowest, highest  Hz; highest 0: by the force
    @throws InputError  where less than two lines are left [worker] */
HammerLines drivenLines (const std::vector<HammerRecording>&, const HammerTest&, double lowest, double highest);

/** Responses from the usable hits of some recordings of the same channels: transforms of windowed hits, averaged.

    The force is kept while the tip touches and faded out after it; force and responses get the test's exponential
   window, so that the response is that of the surface at i omega + windowDecay instead of i omega: exactly so if the
   hit is complete. Coherence and variances are empty where one hit alone is left.
    @param which  recordings by their number
    @return       N_f x N, the responses' unit per newton
    @throws InputError  where none of them has a usable hit
    [worker] Docs/Theory.md, section 8.11. */
EstimatedResponses hammerResponses (const std::vector<HammerRecording>&, const HammerTest&, const HammerLines&,
                                    const std::vector<std::size_t>& which, ResponseEstimator);
} // namespace antinode
