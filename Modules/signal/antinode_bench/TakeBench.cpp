#include "TakeBench.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace antinode
{
namespace
{
using namespace std::chrono_literals;

constexpr auto patience = 3s; // without a call of the device

Eigen::Index columnsFor (const std::vector<Eigen::Index>& columns, Eigen::Index sync)
{
    const auto last = std::max_element (columns.begin(), columns.end());
    return 1 + std::max (sync, last == columns.end() ? -1 : *last);
}
} // namespace

RunRecording TakeBench::play (const Excitation& excitation, Eigen::Index ceramic, Eigen::Index, Eigen::Index points)
{
    requireRate (excitation.settings.sampleRate);
    return playRun (playedRun (excitation, ceramic, layout.fullScale), points);
}

void TakeBench::requireRate (double wanted) const
{
    if (const auto open = sampleRate(); open != wanted)
        throw InputError ("audio device", "runs at " + inWords (open) + " Hz; allowed: " + inWords (wanted)
                                              + " Hz, the rate of the voltages");
}

RunRecording TakeBench::playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync, double rate,
                                      Eigen::Index points)
{
    requireRate (rate);
    Eigen::MatrixXd run (voltages.rows() + 1, voltages.cols());
    run << voltages / layout.fullScale, sync.transpose();

    if (! run.allFinite() || run.cwiseAbs().maxCoeff() > 1)
        throw InputError ("voltages", "are beyond full scale, " + inWords (layout.fullScale) + " V");

    return playRun (run, points);
}

/** @param run  (N_b + 1) x N_s, of full scale: ceramics, then the sync channel */
RunRecording TakeBench::playRun (const Eigen::MatrixXd& run, Eigen::Index points)
{
    constexpr int attempts = 3;
    Eigen::MatrixXf played = Eigen::MatrixXf::Zero (run.cols(), columnsFor (layout.ceramics, layout.syncOutput));

    for (Eigen::Index i = 0; i + 1 < run.rows(); ++i)
        played.col (layout.ceramics[static_cast<std::size_t> (i)]) = run.row (i).transpose().cast<float>();

    if (layout.syncOutput >= 0)
        played.col (layout.syncOutput) = run.bottomRows (1).transpose().cast<float>();

    for (int attempt = 0; attempt < attempts; ++attempt)
    {
        const auto take = std::make_shared<Take>();
        take->played = played;
        take->recorded = Eigen::MatrixXf::Zero (run.cols(), columnsFor (layout.sensors, layout.syncInput));
        const auto lostBefore = lostBlocks();
        begin (take);
        waitFor (*take);
        checkWatch();

        if (take->samples < run.cols() || isVoid())
            throw InputError ("measurement", whyEnded());

        if (lostBlocks() == lostBefore)
            return toRecording (*take, points);
    }

    throw InputError ("audio device", "keeps losing samples; choose a larger block, or stop other programs");
}

/** Waits until a take is done; a watch that says no ends it at 0 V. */
void TakeBench::waitFor (const Take& take)
{
    const auto mayGoOn = threadWatch();
    auto seenCalls = calls();
    auto called = std::chrono::steady_clock::now();

    while (! take.isDone)
    {
        std::this_thread::sleep_for (5ms);

        if (! mayGoOn())
            stop();

        if (const auto now = calls(); now != seenCalls)
        {
            seenCalls = now;
            called = std::chrono::steady_clock::now();
        }
        else if (std::chrono::steady_clock::now() - called > patience)
        {
            leave();
            checkWatch();
            throw InputError ("audio device", "has stopped");
        }
    }
}

RunRecording TakeBench::toRecording (const Take& take, Eigen::Index points) const
{
    RunRecording recording;
    recording.sensors.resize (points, take.recorded.rows());

    for (Eigen::Index sensor = 0; sensor < points; ++sensor)
        recording.sensors.row (sensor) =
            take.recorded.col (layout.sensors[static_cast<std::size_t> (sensor)]).cast<double>().transpose()
            * layout.velocity;

    if (layout.syncInput >= 0)
        recording.sync = take.recorded.col (layout.syncInput).cast<double>();

    return recording;
}
} // namespace antinode
