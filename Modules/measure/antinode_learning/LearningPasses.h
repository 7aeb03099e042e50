#pragma once

#include "LearnModes.h"

#include <antinode_focus/SpillOver.h>

#include <functional>
#include <string>
#include <vector>

namespace antinode
{
/** Plays voltages on the surface at rest and records the sensors: N_b x N_s, V in, of the sample rate that was asked
    for.
    @param pass  0 for the first
    @return      with the voltages that were played, if others than these; with a delaySpan the delay is looked for */
using PassPlayer = std::function<PlayedRecording (const Eigen::MatrixXd& voltages, int pass)>;

struct LearningSettings
{
    double sampleRate = 96000; ///< Hz, of voltages and signals.
    double duration = 0.25;    ///< s, of each play from the trigger on.
    int passes = 4;            ///< How often is played at most; 0: the design is made only.
    double enough = 0;         ///< Of the field's error: a play that reaches it, as far as is known, is the last one.
};

/** The voltages of a design for so long: N_b x N_s, V.
    @param known  the modes that it is made for
    @throws InputError  as renderOffline
    [worker] */
Eigen::MatrixXd playedVoltages (const ModalModel& known, const FocusDesign&, const LearningSettings&);

/** One play of a focus and what was learnt from it. */
struct LearningPass
{
    FocusDesign design;         ///< That was played.
    Eigen::MatrixXd voltages;   ///< N_b x N_s, V
    double surprise = 0;        ///< RMS of what the model it was designed by did not predict, of the noise.
    double nominalSurprise = 0; ///< The same of the nominal model.
    double loudness = 1; ///< What sensors hear while voltages are played, of what the nominal model predicts: RMS,
                         ///< the median of the sensors.
    double delay = 0;    ///< s, of the recording, as it was known or found.
    double estimatedError = 0; ///< Of its field at the focus against that of the last design, by what is
                               ///< known in the end: RMS, of the latter's.
};

/** A focus after some plays. */
struct LearntFocus
{
    std::vector<LearningPass>
        passes;           ///< As they were played: fewer than wanted where the first signals are not explained.
    LearntModes learnt;   ///< From all recordings.
    WideModel wide;       ///< The nominal one with what was learnt.
    FocusDesign design;   ///< The one to play from now on.
    std::string refusal;  ///< Why what was learnt is not used, a sentence: the design is then one that was played;
                          ///< empty: it is.
    std::size_t kept = 0; ///< The play whose design that is: the first one, or the one that was predicted best where
                          ///< that was much better.
};

/** Plays a focus, learns, and designs it again, with as many modes as at first; a design that is hardly off is
   corrected instead. What was learnt is used only if it explains the signals, and if it predicted the last play much
   better than the nominal model: so a sensor that is unplugged, clipped or at another place makes nothing worse. Plays
   end where what was learnt misleads.
    @param nominal  with modes beyond those that are designed for
    @throws LimitError, InputError, Cancelled  as designFocus and learnModes
    [worker] Docs/Theory.md, section 7.6. */
LearntFocus learnFocus (const WideModel& nominal, const FocusDescription&, const std::vector<Sensor>&,
                        const ModeSpread&, const PassPlayer&, const LearningSettings&,
                        const std::function<void (double)>& progress = {});

/** Why no design can be made of what was learnt, a sentence; empty: one can.
    @param pass  the last one
    [any] Docs/Theory.md, section 7.6. */
std::string doubtOf (const LearningPass& pass, const LearntModes& learnt, const ModalModel& nominal,
                     const ModeSpread& deviations);

/** Why what was learnt is not used after all plays, a sentence; empty: it is. [any] */
std::string refusalOf (const LearntFocus&, const ModalModel& nominal, const ModeSpread& deviations);

/** Why what is used may still be wrong, a sentence; empty: nothing is known against it. [any] */
std::string warningOf (const LearntFocus&);

/** Whether so much stays unexplained or a frequency is moved so far, that the fit may be in the wrong minimum.
    @param settledMove  in deviations: a frequency that is moved about so far is no sign of it any more
    [any] */
bool isStuck (const LearntModes&, double settledMove = 0);

/** Whether a play was predicted three times worse than by the nominal model, and what was learnt from it is stuck too:
    no more is played then. [any] */
bool isMisled (const LearningPass&, const LearntModes& learnt);

/** The play that was predicted best by what it was designed with: its field is nearest to what was wanted. The first
    one, where none was predicted much better. [any] */
std::size_t bestPredicted (const std::vector<LearningPass>&);

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
