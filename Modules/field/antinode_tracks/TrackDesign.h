#pragma once

#include "Waveforms.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Progress.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_model/VoltageProgram.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace antinode
{
/** How tracks are designed. */
struct TrackSettings
{
    double sampleRate = 48000;    ///< Of the voltages, Hz.
    SkinThreshold threshold;      ///< For levels in dB over threshold.
    double regularisation = 1e-2; ///< Of the median smallest singular value in the band: what is not worth its volts.
    double latency = 0;           ///< Of designLiveTracks, s.
};

/** What waveforms that were played say about the next ones. */
struct TrackShift
{
    Eigen::MatrixXd predicted; ///< N_s x points, m, at the rate of the voltages: what the model says of them.
    Eigen::MatrixXd missing;   ///< N_s x points, m: what the surface did not do of what is wanted. Without: no shift.
    double firstTime = 0;      ///< s from the trigger, of the first sample.
};

/** What is given up where a limit binds. */
struct TrackLimitUse
{
    double unlimitedPeak = 0; ///< Of the least-norm voltages, over their limit.
    double peakBound = 0;     ///< No voltages of any form reach this error with a smaller peak over the limit.
};

/** Voltages that give every finger its own track. */
struct TrackDesign
{
    WaveformsDescription description;
    SampledVoltages voltages; ///< As they are played: within all limits.
    double designRate = 0;    ///< Hz: the voltages are interpolated from this rate; nothing is above half of it.
    Eigen::MatrixXd wanted;   ///< N_s x points, m: at the rate of the voltages, the first sample at the trigger.
    double error = 0;         ///< ||reached - wanted|| / ||wanted||, by the design's own model.
    Eigen::VectorXd peaks;    ///< N_b, V
    TrackLimitUse limitUse;
    int iterations = 0; ///< Of conjugate gradients.
    double latency = 0; ///< s from an input to the motion, where the voltages follow inputs; else 0.
    std::vector<std::string> warnings;
};

/** The largest error of motion that a design may leave, relative: -30 dB. */
inline constexpr double acceptedTrackError = 0.0316;

/** The wanted levels cannot be reached within the limits. The text says what share of them can. */
class TrackLimitError : public InputError
{
public:
    TrackLimitError (const std::string& where, const std::string& wrong, double shareToUse, double boundToUse)
        : InputError (where, wrong), share (shareToUse), bound (boundToUse)
    {
    }

    double share; ///< Of the wanted levels: what the limits allow at acceptedTrackError.
    double bound; ///< For that share, no voltages of any form do with less than this share of the limits.
};

/** Designs waveforms at touched points. Docs/Theory.md, section 4.13; Docs/Design/tracks.md.
    @param progress  may be empty
    @param shift     the design is for what was predicted and what is missing, as far as voltages can well bring it:
                     of that only the band counts, and less and less to half of its lower and twice its upper end
    @throws InputError  for points outside the surface or too near to each other to be told apart, tracks longer than
                        memory, a rate too low for the band
    @throws TrackLimitError  for levels beyond the limits
    @throws Cancelled   when a watch of this thread says no
    [worker] */
TrackDesign designTracks (const ModalModel&, const WaveformsDescription&, const TrackSettings&,
                          const ShowProgress& progress = {}, const TrackShift& shift = {});

/** What such a design wants, as in TrackDesign. @throws InputError  for a rate too low for the band, tracks that are
    silent within it [worker] */
Eigen::MatrixXd wantedAsPlayed (const ModalModel&, const WaveformsDescription&, const TrackSettings&);
} // namespace antinode
