#pragma once

#include <Eigen/Core>

#include <memory>

namespace antinode
{
/** The lines 0 to N/2 of a real signal's discrete Fourier transform, sum_n x_n exp (-2 pi i k n / N): a delay decreases
   the phase.
    @param signal  N samples, at least 1
    [worker] */
Eigen::VectorXcd forwardFourier (const Eigen::VectorXd& signal);

/** The same of a signal that is followed by zeros up to a length. @param length  at least that of the signal [worker]
 */
Eigen::VectorXcd forwardFourier (const Eigen::VectorXd& signal, Eigen::Index length);

/** The real signal of such lines: the inverse of forwardFourier.
    @param spectrum  length/2 + 1 lines
    [worker] */
Eigen::VectorXd inverseFourier (const Eigen::VectorXcd& spectrum, Eigen::Index length);

/** Both transforms, bit for bit, for several signals of few lengths: keeps the tables of each length, which take as
   long as a transform. One thread at a time. */
class FourierTables
{
public:
    FourierTables();
    ~FourierTables();
    FourierTables (const FourierTables&) = delete;
    FourierTables& operator= (const FourierTables&) = delete;

    /** As the functions of these names. [worker] */
    Eigen::VectorXcd forward (const Eigen::VectorXd& signal);
    Eigen::VectorXcd forward (const Eigen::VectorXd& signal, Eigen::Index length);
    Eigen::VectorXd inverse (const Eigen::VectorXcd& spectrum, Eigen::Index length);

private:
    struct Tables;
    std::unique_ptr<Tables> tables;
};

/** The least length from a number on that is 4 times a product of 2, 3 and 5: transforms of these are quick. [any] */
Eigen::Index quickLength (double atLeast);

/** The largest absolute value of the band-limited waveform that samples stand for: it is larger than that of the
   samples. Four points a sample, which misses at most 8 % for a tone at the Nyquist frequency and 1 % at a third of it.
   [worker] */
double peakBetweenSamples (const Eigen::VectorXd& signal);
} // namespace antinode
