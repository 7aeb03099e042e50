#pragma once

#include "LearningPasses.h"

#include <vector>

namespace antinode
{
/** Learns a device from one play after the other, with all plays so far. One thread at a time. */
class PassLearner
{
public:
    /** All are kept by reference. [any] */
    PassLearner (const WideModel& nominal, const std::vector<Sensor>&, const ModeSpread&);

    /** Learns from a play and those before.
        @return  its voltages, surprises, loudness and delay
        @throws InputError, Cancelled  as learnModes
        [worker] Docs/Theory.md, section 7.6. */
    LearningPass hear (const PlayedRecording&);

    /** What is known by now. [any] */
    const LearntModes& now() const { return learnt; }

private:
    std::vector<double> delaysToTry (const PlayedRecording&, const ModeSpread&) const;
    LearntModes learntWith (const ModeSpread&);

    const WideModel& nominal;
    const std::vector<Sensor>& sensors;
    const ModeSpread& deviations;
    std::vector<PlayedRecording> recordings;
    LearntModes learnt;
    double settledMove = 0; ///< Of a frequency, in its deviations: a fit from the beginning does not take it back.
};
} // namespace antinode
