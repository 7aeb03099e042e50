#pragma once

#include <Eigen/Core>

namespace antinode
{
/** The frequency response of an impulse response. N_f lines, from 0 Hz to half the sample rate. */
struct ImpulseSpectrum
{
    Eigen::VectorXd frequencies; ///< N_f: Hz
    Eigen::VectorXcd values;     ///< N_f, the samples' unit times s.
    double recordLength = 0; ///< s: T. What of the impulse response lies behind T is cut off, so that a pole s has its
                             ///< residue multiplied by 1 - e^{sT} on these lines.
};

/** The Fourier transform of samples with this interval, as far as their number has no prime factor above 5.
    @param samples   2 or more
    @param interval  s, more than 0
    [worker] Docs/Theory.md, section 8.1. */
ImpulseSpectrum impulseSpectrum (const Eigen::VectorXd& samples, double interval);
} // namespace antinode
