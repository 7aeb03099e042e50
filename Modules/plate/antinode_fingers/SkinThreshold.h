#pragma once

#include <Eigen/Core>

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
} // namespace antinode
