#pragma once

#include "RunRecording.h"

#include <antinode_model/ModalModel.h>

#include <cstdint>

namespace antinode
{
/** A simulated bench: its sensors, amplifiers and converters. */
struct SimulatedBenchSettings
{
    double sampleRate = 96000; ///< Hz
    double signalToNoise =
        40; ///< dB: effective value of each sensor over that of its white noise, while the surface moves.
    double delay = 0.00123456; ///< s, from output to input, of sensors and sync channel alike.
    double cubic =
        0; ///< Share of the voltage cubed: u becomes u (1 + cubic (u / largest)^2), as ceramics with hysteresis do.
    std::uint64_t seed = 1; ///< Of the noise.
};

/** The recording of the sensors of such a bench for played voltages: each mode's response, line by line of a transform
   so long that nothing folds.

    @param shapes    N x N_m: the rows of mode shapes at the sensors (shapesAt), kg^-1/2
    @param voltages  N_b x N_s, V, of ceramics; silent at the end
    @param sync      N_s: what the sync channel plays; it returns delayed and otherwise as it is
    @return          N_s samples of every channel; no reference
    @throws InputError  where sizes do not agree or a number is not usable
    [worker] Docs/Theory.md, section 8.10. */
RunRecording simulateBench (const ModalModel&, const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& voltages,
                            const Eigen::VectorXd& sync, const SimulatedBenchSettings&);
} // namespace antinode
