#pragma once

#include "FreeSamples.h"
#include "FreeWaveform.h"

#include <antinode_allocation/BoundedWaveform.h>

#include <vector>

namespace antinode
{
/** What a free waveform was made for. What it refers to outlives it. */
struct QuietTask
{
    const ModalModel& model;
    const FocusDescription& description; ///< With `felt`.
    const BoundedWaveformProblem& problem;
    const std::vector<int>& modes; ///< Of the problem's rows.
    SampleRange range;
};

/** Changes a free waveform so that less is felt elsewhere. Rows keep their values to rounding and limits are kept; the
   waveform goes on after the focus.
    @throws InputError  as feltLines; Cancelled when a watch of this thread says no
    [worker] Docs/Theory.md, section 4.14. */
void makeQuieter (FreeWaveform&, const QuietTask&);

/** What belongs to a correction: splines on every ceramic, N_b x N_l, and how much of each row's own waveform is taken
   away, N_r. Slopes of what is minimised have the same parts. */
struct QuietCorrection
{
    Eigen::MatrixXd splines;
    Eigen::VectorXd rows;
};

/** Waveforms that correct a free waveform: splines, less as much of the rows' own waveforms as keeps the rows what they
   are. So every choice of splines is allowed, and none at all is the free waveform itself. N_l splines, N_r rows.
   [worker] Docs/Theory.md, section 4.14. */
class QuietBasis
{
public:
    /** @param samples  of the corrected waveform. The task outlives this. */
    QuietBasis (const QuietTask& task, Playback playback, Eigen::Index samples);

    /** N_l */
    Eigen::Index size() const { return splines.rows(); }
    /** N_l x samples, V */
    const Eigen::MatrixXd& splineWaves() const { return splines; }
    /** N_r x samples, V */
    Eigen::MatrixXd rowWaveforms() const { return withMirrorImage (rowWaves, range); }

    /** With the rows' waveforms that the splines make necessary. */
    QuietCorrection allowed (Eigen::MatrixXd s) const;

    /** The slope in the splines where those of all parts are known. */
    Eigen::MatrixXd slopeOf (const QuietCorrection& slope) const;

    /** The slope of half of the energy, guards included. */
    QuietCorrection energySlope (const QuietCorrection& change) const;

    /** A slope divided by the splines' own cost, for conjugate gradients. */
    Eigen::MatrixXd preconditioned (const Eigen::MatrixXd& slope) const;

    /** N_b x samples, V. */
    Eigen::MatrixXd voltages (const QuietCorrection& change) const;

    /** N_r: the rows' values of voltages. */
    Eigen::VectorXd rowValues (const Eigen::MatrixXd& samples) const;

private:
    Eigen::VectorXd valuesOf (const Eigen::MatrixXd& weights, const Eigen::MatrixXd& waves) const;
    Eigen::MatrixXd pullOf (const Eigen::MatrixXd& weights, const Eigen::VectorXd& multipliers) const;

    /** Multipliers of the rows' waveforms that have these values. */
    Eigen::VectorXd restored (const Eigen::VectorXd& values) const;

    static constexpr auto rounding = 1e-13; // of rows that almost repeat others
    const Eigen::MatrixXd& participation;
    const Eigen::VectorXd& costs;
    SampleRange range;
    Eigen::MatrixXd splines, rowWaves, plainWeights, plainRows, foldedRows;
    Eigen::MatrixXd gram, factor, energy, energyFactor;
    Eigen::VectorXd scale;
};
} // namespace antinode
