#include "PlayPasses.h"

#include <antinode_learning/RecordingDelays.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** A burst of white noise, then nothing: the sync channel of a pass, N_s, of full scale. */
Eigen::VectorXd syncBurst (Eigen::Index samples, Eigen::Index first, double sampleRate)
{
    constexpr double length = 0.02; // s
    const auto count = std::min (samples - first, static_cast<Eigen::Index> (length * sampleRate));
    RandomNumbers random (1);
    Eigen::VectorXd sync = Eigen::VectorXd::Zero (samples);

    for (Eigen::Index n = 0; n < count; ++n)
        sync[first + n] = syncLevel * (2 * random.uniform() - 1);

    return sync;
}

/** RMS of each sensor's samples. */
Eigen::VectorXd effectiveValues (const Eigen::MatrixXd& signals)
{
    return signals.rowwise().norm() / std::sqrt (static_cast<double> (signals.cols()));
}

/** The delay between the sync channel and its recording, s. */
double syncDelay (const Eigen::VectorXd& sync, const Eigen::VectorXd& recorded, const PassPlaySettings& settings)
{
    const PlayedRecording loop { settings.sampleRate,       {}, recorded.transpose(),
                                 Eigen::VectorXd::Ones (1), 0,  settings.longestDelay };
    return likelyDelays (loop, sync, 1).front();
}
} // namespace

PassPlayer playPasses (Bench& bench, Eigen::Index sensors, const PassPlaySettings& settings)
{
    return [&bench, sensors, settings] (const Eigen::MatrixXd& voltages, int)
    {
        constexpr double leastNoise = 1e-4; // of the signal
        const auto before = static_cast<Eigen::Index> (std::ceil (settings.silence * settings.sampleRate));
        const auto after = static_cast<Eigen::Index> (std::ceil (settings.longestDelay * settings.sampleRate));
        const auto count = voltages.cols();
        Eigen::MatrixXd played = Eigen::MatrixXd::Zero (voltages.rows(), before + count + after);
        played.middleCols (before, count) = voltages;
        const auto sync = syncBurst (played.cols(), before, settings.sampleRate);
        const auto run = bench.playTogether (played, sync, settings.sampleRate, sensors);
        PlayedRecording recording {
            settings.sampleRate, played.rightCols (count + after), run.sensors.rightCols (count + after), {}, 0, 0
        };
        recording.noise = effectiveValues (run.sensors.leftCols (before))
                              .cwiseMax ((leastNoise * effectiveValues (recording.signals)).cwiseMax (1e-30));

        if (settings.usesSync && run.sync.size() > 0)
            recording.delay = syncDelay (sync, run.sync, settings);
        else
            recording.delaySpan = settings.longestDelay;

        return recording;
    };
}
} // namespace antinode
