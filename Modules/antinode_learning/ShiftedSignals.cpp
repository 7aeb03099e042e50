#include "ShiftedSignals.h"

#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
Eigen::MatrixXd signalsEarlier (const PlayedRecording& recording, double delay, Eigen::Index samples)
{
    const auto late = delay * recording.sampleRate;
    const auto length = quickLength (static_cast<double> (recording.signals.cols()) + late);
    const auto turn = 2 * std::numbers::pi * late / static_cast<double> (length);
    const Eigen::VectorXcd turns = Eigen::VectorXcd::NullaryExpr (
        length / 2 + 1, [turn] (Eigen::Index k) { return std::polar (1.0, turn * static_cast<double> (k)); });
    Eigen::MatrixXd result (samples, recording.signals.rows());
    FourierTables tables;

    for (Eigen::Index m = 0; m < result.cols(); ++m)
        result.col (m) =
            tables.inverse (tables.forward (recording.signals.row (m).transpose(), length).cwiseProduct (turns), length)
                .head (samples);

    return result;
}

Eigen::Index comparableSamples (const PlayedRecording& recording)
{
    constexpr double edge = 128; // samples beside the end of a signal that is shifted by a part of a sample
    const auto late = std::ceil (recording.delay * recording.sampleRate) + edge;
    return std::max<Eigen::Index> (1, recording.voltages.cols() - static_cast<Eigen::Index> (late));
}
} // namespace antinode
