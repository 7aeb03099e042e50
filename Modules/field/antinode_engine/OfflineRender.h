#pragma once

#include "PlateModel.h"

#include <antinode_model/VoltageProgram.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace antinode
{
/** The settings of a render. */
struct RenderSettings
{
    Playback playback;           ///< With a rate of more than 0.
    double duration = 0;         ///< s, from the trigger.
    int blockSize = 512;         ///< Any, 1 or more: the result does not depend on it.
    Eigen::MatrixXd probeShapes; ///< N_probes x N_c
};

/** A whole event: voltages and what the plate does with them. */
struct Render
{
    double sampleRate = 0;                    ///< Hz
    std::int64_t focusSample = 0;             ///< The sample on which the focus falls.
    Eigen::MatrixXd voltages;                 ///< N_b x N_s, V, after the limiter.
    Eigen::MatrixXd probeVelocities;          ///< N_probes x N_s, m/s, aligned with the voltages.
    Eigen::MatrixXd modalVelocities;          ///< N_c x N_s, m/s kg^1/2, aligned with the voltages.
    Eigen::VectorXd focusVelocities;          ///< N_c: modal velocities at the focus sample.
    std::vector<std::int64_t> limitedSamples; ///< Per ceramic, how many samples the limiter had to clamp.
};

/** Plays a program through synthesiser, limiter and plate model, offline. The plate is at rest before the first sample;
   the voltages before it are 0, those after the last one are what the program goes on with.
    @param progress  called with 0..1 after about every hundredth; may be empty
    @throws InputError  when the rate is not 8 kHz to 2 MHz, the duration not above 0 to 60 s or too long for 1 GiB of
   results or too short for the focus, the block size below 1, sizes do not agree, voltages overflow double precision,
   or a free waveform was made for another rate or reconstruction [worker] Docs/Theory.md, section 6. */
Render renderOffline (const ModalModel&, const VoltageProgram&, const RenderSettings&,
                      const std::function<void (double)>& progress = {});
} // namespace antinode
