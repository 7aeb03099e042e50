#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/SampledVoltages.h>
#include <antinode_tracks/TrackDesign.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace antinode
{
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
