#pragma once

#include "LearnModes.h"
#include "PlayedRecording.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** The delays at which a recording correlates most with what a model predicts, the most likely one first: maxima of at
    least a quarter of the largest, between the samples by a parabola. All lie between the recording's delay and its
   delaySpan beyond; at least one.
    @param predicted  samples x N: as the sensors would hear it without delay
    @param most       how many at most
    @return           s
    [worker] Docs/Theory.md, section 7.6. */
std::vector<double> likelyDelays (const PlayedRecording&, const Eigen::MatrixXd& predicted, std::size_t most);

/** Signals without the delay that they came with. */
struct AlignedSignals
{
    Eigen::MatrixXd signals; ///< N x N_s: the last ones, of the length of the delay, are not known and 0.
    double delay = 0;        ///< s
};

/** Signals that were recorded some time after what a model predicts of them, moved to where they correlate most with
    it.
    @param signals       N x N_s
    @param predicted     N x N_p, without delay, of the same rate
    @param longestDelay  s, that is looked for
    @throws InputError   when the numbers of rows differ, or nothing is predicted or recorded
    [worker] Docs/Theory.md, sections 4.15 and 7.6. */
AlignedSignals alignedWith (const Eigen::MatrixXd& signals, const Eigen::MatrixXd& predicted, double sampleRate,
                            double longestDelay);

/** The delays that the first play may have, to be tried on its whole record, s: one where its beginning tells it, else
    the best few.
    @param deviations  of the nominal device
    @param recording   with the range of delays that is looked through; without one its own delay is given
    @throws InputError, Cancelled  as learnModes
    [worker] Docs/Theory.md, section 7.6. */
std::vector<double> firstDelays (const ModalModel& nominal, const std::vector<Sensor>&, const ModeSpread& deviations,
                                 const PlayedRecording& recording);

/** What sensors hear until the voltages have ended, of what a model predicts of it: RMS, the median of the sensors.
    [worker] */
double loudnessOf (const ModalModel&, const std::vector<Sensor>&, const PlayedRecording&);

/** The model whose response is the mean response of devices with scattered frequencies: their phases drift apart, which
    acts like more damping.
    @param frequencyDeviations  N_m, relative
    [any] */
ModalModel meanModel (ModalModel, const Eigen::VectorXd& frequencyDeviations);

/** At most so many delays that a recording may have, by what a model predicts of it, s: the most likely one first; its
    own where that is known. [worker] Docs/Theory.md, section 7.6. */
std::vector<double> delaysBy (const ModalModel&, const std::vector<Sensor>&, const PlayedRecording&, std::size_t most);

/** The same recording with a delay that is known, s. [any] */
PlayedRecording withDelay (PlayedRecording, double delay);

/** RMS of what a device does not predict of a recording, of the noise, by the delay that suits this device best: within
    a few deviations of its own, or where it is looked for.
    @throws InputError, Cancelled  as learnModes
    [worker] Docs/Theory.md, section 7.6. */
double surprise (const LearntModes&, const ModeSpread&, const PlayedRecording&);
} // namespace antinode
