#pragma once

#include "TrackDesign.h"
#include "Waveforms.h"
#include <antinode_base/ShowProgress.h>
#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

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
} // namespace antinode
