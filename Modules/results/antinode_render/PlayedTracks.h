#pragma once

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>
#include <antinode_tracks/TrackDesign.h>
#include <antinode_tracks/Waveforms.h>

#include <cstddef>
#include <vector>

namespace antinode
{
/** What a surface does with voltages, at points. */
struct PlayedTracks
{
    double sampleRate = 0;           ///< Hz
    Eigen::Index trigger = 0;        ///< The sample of the trigger.
    Eigen::MatrixXd displacements;   ///< points x N_s, m
    double modalRate = 0;            ///< Hz, of the modal velocities: a whole part of the sample rate.
    Eigen::MatrixXd modalVelocities; ///< N_c x N, m/s kg^1/2, from the first sample on.
};

/** Plays voltages on a surface, mode by mode from sample to sample, and lets it ring: what happens at the touched
   points, which may move. Knows nothing of a design.
    @param ringing     s after the last voltage
    @throws InputError  as requirePlaces
    @throws Cancelled  when a watch of this thread says no
    [worker] Docs/Theory.md, section 6.2. */
PlayedTracks playTracks (const ModalModel&, const WaveformsDescription&, const SampledVoltages&, double ringing);

/** What one finger gets, of what it should and of what it should not. */
struct FingerScore
{
    double wantedPeak = 0, reachedPeak = 0; ///< m
    double wantedRms = 0;                   ///< m, within the band, of the whole event.
    double errorRms = 0;                    ///< m, within the band: of reached minus wanted.
    double wideErrorRms = 0;                ///< m, of all frequencies.
};

/** Scores of waveforms at points. */
struct TrackScores
{
    std::vector<FingerScore> fingers; ///< Those with tracks first.
    double strongestRms = 0;          ///< m, within the band, of the strongest track.

    /** What a finger should not feel over the strongest track, within the band or with all frequencies, dB. */
    double suppression (std::size_t finger) const;
    double wideSuppression (std::size_t finger) const;

    /** Energy of the error over that of the wanted waveform, within the band; of fingers with a track. */
    double normalisedError (std::size_t finger) const;
};

/** Compares played with wanted motion. The band is cut out sharply, over the whole event with its ringing.
    @param wanted  N_s x points, m, at the rate of what was played, from the trigger on
    [worker] Docs/Theory.md, section 5.3. */
TrackScores scoreTracks (const PlayedTracks&, const Eigen::MatrixXd& wanted, TrackBand band);

/** When tracks begin in what was played. */
struct TrackAlignment
{
    Eigen::Index begin = 0; ///< The sample of the trigger.
    double likeness = 0;    ///< Correlation of reached and wanted motions there, all points as one signal: -1 to 1.
};

/** The sample at which wanted motions are most like what was reached, the same for all points.
    @param reached  points x N_s, m
    @param wanted   N_w x points, m, at the same rate; not all 0
    [worker] */
TrackAlignment alignTracks (const Eigen::MatrixXd& reached, const Eigen::MatrixXd& wanted);

/** What a surface did at the touched points: voltages that were played, and what was recorded. */
struct RecordedPass
{
    SampledVoltages voltages;
    Eigen::MatrixXd
        displacements;  ///< points x N_s, m, those with tracks first: from the first voltage on, at its rate.
    double latency = 0; ///< s, that the recording came with and that was removed.
};

/** What recorded passes say about the next one. */
struct TrackCorrection
{
    std::vector<double> errors;    ///< Of each pass, dB: of its worst finger, as TrackScores::suppression.
    std::vector<double> latencies; ///< Of each pass, s, as RecordedPass.
    std::size_t best = 0;          ///< The pass with the least error, from which the next one begins.
    double gain = 1;               ///< The share of its error that the next pass corrects: half for each later pass.
    TrackShift shift;              ///< For designTracks.
};

/** @throws InputError  when a pass has another number of points or ceramics or another rate than a design for these
                        waveforms, is shorter than its voltages, or is not finite
    [any] */
void requirePasses (const std::vector<RecordedPass>&, const ModalModel& known, const WaveformsDescription&,
                    double sampleRate);

/** Compares passes with what is wanted, and the best one with what the model says of its voltages.
    @param passes  in the order in which they were played, at least one
    @throws InputError  as requirePasses, and when what was recorded is far from what is wanted
    @throws Cancelled   when a watch of this thread says no
    [worker] Docs/Theory.md, section 4.15. */
TrackCorrection correctionFrom (const ModalModel& known, const WaveformsDescription&, const TrackSettings&,
                                const std::vector<RecordedPass>& passes);

/** What a model says of voltages at the touched points, with the fingers that the description knows.
    @param ringing  s after the last voltage
    @return         points x N_s, m
    @throws InputError, Cancelled  as playTracks
    [worker] */
Eigen::MatrixXd predictedDisplacements (const ModalModel& known, const WaveformsDescription&, const SampledVoltages&,
                                        double ringing);

/** Displacements of recorded velocities: integrated, without what lies below a quarter of the band's lower end.
    @param velocities  points x N_s, m/s @return  points x N_s, m [worker] */
Eigen::MatrixXd displacementsOf (const Eigen::MatrixXd& velocities, double sampleRate, TrackBand);
} // namespace antinode
