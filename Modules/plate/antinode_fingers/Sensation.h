#pragma once

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

#include <string>

namespace antinode
{
/** The least displacement that skin feels, by frequency. A model of a resting fingertip, not of a person. */
struct SkinThreshold
{
    std::string source;            ///< Where the numbers are from.
    Eigen::VectorXd frequencies;   ///< N, ascending, Hz.
    Eigen::VectorXd displacements; ///< N: peak of a tone that is just felt, m.
};

/** The threshold at one frequency: a straight line of logarithms between the numbers; beyond both ends it rises by 24
   dB an octave.
    @param frequency  Hz, above 0
    @return           m
    [any] Docs/Theory.md, section 5.1. */
double thresholdAt (const SkinThreshold&, double frequency);

/** Checks a threshold: at least two numbers, frequencies above 0 and ascending, displacements above 0, all finite.
    @throws InputError  naming the source and the first thing that is wrong. [any] */
void validate (const SkinThreshold&);

/** A displacement as skin weighs it: each frequency is divided by the threshold, without a shift in time; what rests is
   not felt.
    @param displacement  N_s samples, m, at rest before and after
    @return              N_s, times the threshold
    [worker] Docs/Theory.md, section 5.1. */
Eigen::RowVectorXd feltDisplacement (const Eigen::VectorXd& displacement, double sampleRate, const SkinThreshold&);

/** The motion of modes as skin weighs it: displacement over threshold, at a rate that is enough for skin. */
struct FeltMotion
{
    double sampleRate = 0; ///< Hz, 8 to 16 kHz, or that of the motion where it is lower.
    Eigen::MatrixXd modal; ///< N_c x N_s, kg^1/2: times mode shapes, how many times the threshold a place moves.
};

/** Weighs recorded motion. Each frequency is divided by the threshold without a shift in time. After the last sample
   modes go on as they decay freely, fading out within .4 s.
    @param modalVelocities  N_c x N_s, at least two samples, m/s kg^1/2; at rest before the first one, without drive at
   the last two
    @throws Cancelled  when a watch of this thread says no
    [worker] Docs/Theory.md, section 5.1. */
FeltMotion feltMotion (const ModalModel&, const Eigen::MatrixXd& modalVelocities, double sampleRate,
                       const SkinThreshold&);

/** How many times the threshold a weighted motion is felt: the larger of its peak and root 2 times its largest RMS
   within 100 ms.
    @param weighted  N_s, times the threshold
    [any] Docs/Theory.md, section 5.1. */
double feltAmount (const Eigen::Ref<const Eigen::RowVectorXd>& weighted, double sampleRate);

/** The sensation level of an amount, dB over threshold; at least -120 dB. [any] */
double sensationLevel (double amount);
} // namespace antinode
