#pragma once

#include "TrackDesign.h"
#include "Waveforms.h"

#include <Eigen/Core>
#include <antinode_base/Progress.h>
#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** How filters from an audio input of each finger to voltages are designed. */
struct FilterSettings
{
    double sampleRate = 48000;    ///< Of inputs and voltages, Hz.
    double latency = 0.02;        ///< s from an input to the motion beneath its finger.
    double length = 0.1;          ///< s, of each filter.
    double regularisation = 3e-2; ///< Of the median smallest singular value in the band: what is not worth its volts.
};

/** How filters run in time. */
struct FilterTiming
{
    Eigen::Index factor = 1; ///< Samples per sample of the filters.
    Eigen::Index delay = 0;  ///< Samples of the filters, from their input to the motion.
    Eigen::Index taps = 0;   ///< Of each filter.

    /** From an input to the motion, with both changes of rate. [any] */
    Eigen::Index latencySamples() const;
};

/** The timing that filters of a band will have.
    @throws InputError  for a latency or a rate that is not allowed
    [any] */
FilterTiming filterTiming (TrackBand, const FilterSettings&);

/** One filter from each track to each ceramic. Inputs are decimated to their rate, voltages interpolated from it. */
struct FingerFilters
{
    double sampleRate = 0;             ///< Hz, of inputs and voltages.
    Eigen::Index factor = 1;           ///< Samples per sample of the filters.
    Eigen::Index delay = 0;            ///< Samples of the filters, from their input to the motion.
    std::vector<Eigen::MatrixXd> taps; ///< Per track N_taps x N_b, V per m of wanted displacement.
    double error = 0;   ///< Of the worst track: ||reached - wanted|| / ||wanted|| in the band, by the model.
    int iterations = 0; ///< Of conjugate gradients, in all.

    /** Of the filters, Hz. [any] */
    double rate() const { return sampleRate / static_cast<double> (factor); }

    /** From an input to the motion, with both changes of rate, s. [any] */
    double latency() const;
};

/** Filters by which every track's input, delayed, becomes the displacement at its own point within the band, and
    nothing moves at the others: least squares over the responses, causal within the latency.
    @param description  its points, fingers and band; signals and levels are not used
    @throws InputError  for points as designTracks, and a latency or a rate that is not allowed
    @throws Cancelled   when a watch of this thread says no
    [worker] Docs/Theory.md, section 4.16. */
FingerFilters designFingerFilters (const ModalModel&, const WaveformsDescription&, const FilterSettings&,
                                   const ShowProgress& progress = {});

/** Filters as they are played: one matrix, whose product with the inputs' past is a sample of all voltages. */
struct FilterBank
{
    Eigen::Index inputs = 0, taps = 0, factor = 1;
    Eigen::MatrixXf values;  ///< N_b x (inputs taps), V/m: for each input its taps, that of the oldest sample first.
    std::vector<bool> moves; ///< Per input: false where all of its taps are 0.
};

/** A bank with an input for each track. [worker] */
FilterBank filterBank (const FingerFilters&);

/** A bank that moves nothing. [worker] */
FilterBank silentBank (Eigen::Index ceramics, Eigen::Index inputs, FilterTiming);

/** A bank with more inputs than tracks; those without one move nothing.
    @param inputOfTrack  each below `inputs`
    [worker] */
FilterBank filterBank (const FingerFilters&, const std::vector<Eigen::Index>& inputOfTrack, Eigen::Index inputs);

/** What noise at an input that fills the band evenly gives at each ceramic, RMS for RMS: N_b x tracks, V/m. [worker] */
Eigen::MatrixXd noiseGains (const FingerFilters&, TrackBand);

/** Samples of the slower rate to each side that a change of rate reaches, which is also its delay. */
inline constexpr Eigen::Index rateChangeReach = 5;

/** A low-pass for changes of rate by a whole factor: Kaiser's windowed sinc, flat to a quarter of the slower rate,
   below -70 dB from three quarters on.
    @param factor  at least 1
    @return  2 rateChangeReach factor + 1 taps at the faster rate, for interpolation; over the factor, for decimation
    [worker] Docs/Theory.md, section 4.16. */
Eigen::VectorXf rateChangeTaps (Eigen::Index factor);
} // namespace antinode
