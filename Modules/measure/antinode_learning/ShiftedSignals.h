#pragma once

#include "PlayedRecording.h"

#include <antinode_numerics/Fourier.h>

namespace antinode
{
/** The signals of a recording, to be shifted by any part of a sample again and again. One thread at a time. */
class ShiftedSignals
{
public:
    /** [worker] */
    explicit ShiftedSignals (const PlayedRecording&);

    /** Earlier by a delay: samples x N, one column per sensor. Near the ends, 128 samples, the signals are rounded off
        where they are cut.
        @param delay    s, 0 or more
        @param samples  how many, of the first
        [worker] */
    const Eigen::MatrixXd& earlier (double delay, Eigen::Index samples);

    /** By how much `earlier` changes per second of the delay: samples x N. [worker] */
    Eigen::MatrixXd slopesEarlier (double delay, Eigen::Index samples);

private:
    /** The signals whose spectra are the kept ones, each line times a factor: samples x N. */
    Eigen::MatrixXd filtered (const Eigen::VectorXcd& factors, Eigen::Index samples);

    /** What a delay that is taken out does to each line. */
    Eigen::VectorXcd turnsOf (double delay) const;

    double rate, shiftedBy = -1; ///< The delay of `shifted`, s.
    Eigen::Index length;
    Eigen::MatrixXcd spectra; ///< Lines x N
    Eigen::MatrixXd shifted;
    FourierTables tables;
};

/** The same once. [worker] */
Eigen::MatrixXd signalsEarlier (const PlayedRecording&, double delay, Eigen::Index samples);

/** The slopes of band-limited rows, samples x rows, per s. [worker] */
Eigen::MatrixXd slopesOf (const Eigen::MatrixXd& rows, double sampleRate);

/** How many samples of a recording can be compared with a prediction: the last ones, of the length of its delay, answer
    to voltages before its end only. [any] */
Eigen::Index comparableSamples (const PlayedRecording&);
} // namespace antinode
