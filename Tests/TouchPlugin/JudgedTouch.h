#pragma once

#include "PlayedTouch.h"

#include <antinode_render/PlayedTracks.h>

namespace antinode::test
{
inline constexpr double judgedRate = 48000; ///< Hz
inline constexpr int restSamples = 4800;    ///< That voltages last after their inputs.

/** Inputs, and silence until their voltages have ended. */
inline Eigen::MatrixXd withRest (const Eigen::MatrixXd& inputs)
{
    Eigen::MatrixXd longer = Eigen::MatrixXd::Zero (inputs.rows(), inputs.cols() + restSamples);
    longer.leftCols (inputs.cols()) = inputs;
    return longer;
}

/** The processor's device with half as many modes again as the filters know. */
inline ModalModel judgeOf (TouchProcessor& processor)
{
    const auto model = processor.session().snapshot()->model;
    const auto modes = 3 * (model->modes() - model->actuators()) / 2;
    return solveDeviceWithStaticShare (processor.device()->description, static_cast<int> (modes), true);
}

/** What a device does at the fingers under voltages, from sample to sample: no filter, no transform.
    @param judge  has more modes than the filters know */
inline TrackScores judgedBy (const ModalModel& judge, TouchProcessor& processor, const Eigen::MatrixXd& played,
                             const Eigen::MatrixXd& inputs)
{
    const auto model = processor.session().snapshot()->model;
    const auto settings = processor.parameters().settings();
    const auto description = waveformsFor (model->surface, settings, processor.inputs());
    const auto latency = static_cast<double> (processor.getLatencySamples()) / judgedRate;
    const SampledVoltages voltages { { Reconstruction::bandLimited, judgedRate },
                                     -latency,
                                     played.topRows (model->actuators()) * model->fullScaleVoltage };
    const auto levels = processor.parameters().controls().levels;
    const auto tracks = std::ssize (description.tracks);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero (inputs.cols(), tracks + std::ssize (description.silent));

    for (Eigen::Index k = 0; k < tracks; ++k)
        wanted.col (k) = levels[static_cast<std::size_t> (k)] * inputs.row (k).transpose();

    return scoreTracks (playTracks (judge, description, voltages, 0.3), wanted, description.band);
}

/** The same by judgeOf(). */
inline TrackScores judged (TouchProcessor& processor, const Eigen::MatrixXd& played, const Eigen::MatrixXd& inputs)
{
    return judgedBy (judgeOf (processor), processor, played, inputs);
}
} // namespace antinode::test
