#pragma once

#include "BoundedWaveform.h"
#include "FreeGrams.h"

namespace antinode
{
/** The dual of a bounded waveform and its pieces, rows scaled so that each has a Gram entry of 1, and samples by the
    roots of their costs, so that each costs 1. Docs/Theory.md, section 4.9. [worker] */
class WaveformDual
{
public:
    explicit WaveformDual (const BoundedWaveformProblem&);

    /** A' y: what multipliers pull each sample to, N_b x N_s. */
    Eigen::MatrixXd computePulls (const Eigen::VectorXd& y) const;

    Eigen::MatrixXd clipped (const Eigen::MatrixXd& pulls) const;
    Eigen::VectorXd rowValues (const Eigen::MatrixXd& samples) const;

    /** Each sample's part of the dual is v f - v^2 / 2 with v = clip (f). */
    double value (const Eigen::VectorXd& y, const Eigen::MatrixXd& pulls) const;

    /** The minimised value, over samples. */
    double objective (const Eigen::MatrixXd& samples) const;

    /** The matrix of the Newton step: compliance and the rows as the samples within the limits see them. Lower
        triangle. [worker] */
    Eigen::MatrixXd curvature (const Eigen::MatrixXd& pulls, FreeGrams&) const;

    /** For the curvature: all samples are free. It refers to this. [worker] */
    FreeGrams freeGrams() const { return { weights, gram, participation.cols() }; }

    Eigen::VectorXd roots; ///< N_s: of the costs. Samples here are so many times those of the problem.
    Eigen::MatrixXd caps;  ///< N_b x N_s: the limits of samples.
    Eigen::MatrixXd weights, participation;
    Eigen::VectorXd wanted, compliance, scale;

private:
    Eigen::MatrixXd gram;
};
} // namespace antinode
