#include "LikelyDelays.h"

#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double leastShare = 0.25; // of the largest correlation

/** By lags from 0 on, in samples: all sensors together, by their noise. */
Eigen::VectorXd correlation (const PlayedRecording& recording, const Eigen::MatrixXd& predicted)
{
    const auto length = quickLength (static_cast<double> (recording.signals.cols() + predicted.rows()));
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero (length / 2 + 1);
    FourierTables tables;

    for (Eigen::Index m = 0; m < predicted.cols(); ++m)
        sum += tables.forward (predicted.col (m), length)
                   .conjugate()
                   .cwiseProduct (tables.forward (recording.signals.row (m).transpose(), length))
               / (recording.noise[m] * recording.noise[m]);

    return tables.inverse (sum, length);
}
} // namespace

std::vector<double> likelyDelays (const PlayedRecording& recording, const Eigen::MatrixXd& predicted, std::size_t most)
{
    const auto values = correlation (recording, predicted);
    const auto first = static_cast<Eigen::Index> (std::floor (recording.delay * recording.sampleRate));
    const auto span = static_cast<Eigen::Index> (std::ceil (recording.delaySpan * recording.sampleRate));
    const auto end = std::min (first + span + 1, values.size() - 1);
    std::vector<std::pair<double, double>> maxima; // correlation, lag

    for (auto n = first; n < end; ++n)
    {
        const auto before = n > 0 ? values[n - 1] : values[values.size() - 1];
        const auto curvature = before - 2 * values[n] + values[n + 1];

        if (values[n] > before && values[n] >= values[n + 1])
            maxima.emplace_back (values[n], static_cast<double> (n) + (before - values[n + 1]) / (2 * curvature));
    }

    std::sort (maxima.rbegin(), maxima.rend());
    std::vector<double> delays;

    for (const auto& [value, lag] : maxima)
        if (delays.size() < most && value >= leastShare * maxima.front().first)
            delays.push_back (
                std::clamp (lag / recording.sampleRate, recording.delay, recording.delay + recording.delaySpan));

    if (delays.empty())
        delays.push_back (recording.delay);

    return delays;
}
} // namespace antinode
