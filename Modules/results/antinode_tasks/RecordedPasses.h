#pragma once

#include "RecordedSignals.h"

#include <antinode_render/TrackCorrection.h>

#include <string>
#include <vector>

namespace antinode
{
/** Passes that were played and recorded: from each folder voltages.wav and summary.json of antinode perform and what
   was recorded meanwhile, recorded.csv (headings with _um or _mm_s) or recorded.wav (velocities).
    @throws InputError  for what is missing or cannot be read, and recorded.wav without a sensitivity
    [worker] Docs/FileFormats.md. */
std::vector<RecordedPass> readRecordedPasses (const std::vector<std::filesystem::path>& folders, const ModalModel&,
                                              TrackBand, const SensorScale&);

/** The same passes without the latency of their recordings, each its own, found by what the model expects of the
    voltages.
    @param sampleRate      Hz, of the next design
    @param longestLatency  s, that is looked for; 0: as they are
    @throws InputError  as requirePasses and predictedDisplacements, and for a recording that is silent
    [worker] Docs/Theory.md, section 4.15. */
std::vector<RecordedPass> withoutLatency (std::vector<RecordedPass>, const ModalModel& known,
                                          const WaveformsDescription&, double sampleRate, double longestLatency);
} // namespace antinode
