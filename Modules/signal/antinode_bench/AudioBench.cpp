#include "AudioBench.h"

#include <antinode_audio/Interruption.h>
#include <antinode_audio/QuietLibraries.h>
#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <thread>
#include <utility>

namespace antinode
{
namespace
{
using namespace std::chrono_literals;

constexpr auto patience = 3s; // without a call of the device

/** The channels of several roles, ascending. @throws InputError  where two roles share one */
std::vector<int> distinct (std::vector<int> wanted, const std::string& kind)
{
    std::sort (wanted.begin(), wanted.end());

    if (const auto twice = std::adjacent_find (wanted.begin(), wanted.end()); twice != wanted.end())
        throw InputError (kind + " " + std::to_string (*twice + 1), "has two roles; allowed: one");

    return wanted;
}

std::vector<int> usedOutputs (const BenchChannels& channels, Eigen::Index ceramics)
{
    std::vector<int> outputs (static_cast<std::size_t> (ceramics));
    std::iota (outputs.begin(), outputs.end(), 0);
    outputs.push_back (channels.syncOutput);
    return distinct (outputs, "output");
}

std::vector<int> usedInputs (const BenchChannels& channels)
{
    auto inputs = channels.sensors;

    if (channels.syncInput >= 0)
        inputs.push_back (channels.syncInput);

    return distinct (inputs, "input");
}

/** Where an open channel stands among the open ones. */
Eigen::Index channelColumn (const std::vector<int>& open, int channel)
{
    return std::find (open.begin(), open.end(), channel) - open.begin();
}
} // namespace

AudioBench::AudioBench (AudioChoice choice, BenchChannels channelsToUse, Eigen::Index ceramics, double fullScale,
                        double fullScaleVelocity)
    : channels (std::move (channelsToUse)), openOutputs (usedOutputs (channels, ceramics)),
      openInputs (usedInputs (channels)), outputFullScale (fullScale), velocity (fullScaleVelocity)
{
    choice.outputs = openOutputs;
    choice.inputs = openInputs;
    openAudio (manager, choice);
    protectRamps();
    manager.addAudioCallback (&player);
}

AudioBench::QuietLibraries::QuietLibraries()
{
    silenceAudioLibraries();
}

AudioBench::~AudioBench()
{
    manager.removeAudioCallback (&player);
    manager.closeAudioDevice();
}

Eigen::Index AudioBench::sensors() const
{
    return std::ssize (channels.sensors);
}

RunRecording AudioBench::play (const Excitation& excitation, Eigen::Index ceramic, Eigen::Index, Eigen::Index points)
{
    return playRun (playedRun (excitation, ceramic, outputFullScale), points);
}

RunRecording AudioBench::playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync, double sampleRate,
                                       Eigen::Index points)
{
    if (const auto open = openedAudio (manager).sampleRate; open != sampleRate)
        throw InputError ("audio device", "runs at " + inWords (open) + " Hz; allowed: " + inWords (sampleRate)
                                              + " Hz, the rate of the voltages");

    Eigen::MatrixXd run (voltages.rows() + 1, voltages.cols());
    run << voltages / outputFullScale, sync.transpose();

    if (! run.allFinite() || run.cwiseAbs().maxCoeff() > 1)
        throw InputError ("voltages", "are beyond full scale, " + inWords (outputFullScale) + " V");

    return playRun (run, points);
}

/** @param run  (N_b + 1) x N_s, of full scale: ceramics, then the sync channel */
RunRecording AudioBench::playRun (const Eigen::MatrixXd& run, Eigen::Index points)
{
    constexpr int attempts = 3;
    Eigen::MatrixXf played = Eigen::MatrixXf::Zero (run.cols(), std::ssize (openOutputs));

    for (Eigen::Index i = 0; i + 1 < run.rows(); ++i)
        played.col (channelColumn (openOutputs, static_cast<int> (i))) = run.row (i).transpose().cast<float>();

    played.col (channelColumn (openOutputs, channels.syncOutput)) = run.bottomRows (1).transpose().cast<float>();

    for (int attempt = 0; attempt < attempts; ++attempt)
    {
        Take take;
        take.played = played;
        take.recorded = Eigen::MatrixXf::Zero (run.cols(), std::ssize (openInputs));
        const auto lostBefore = manager.getXRunCount();
        player.begin (take);
        waitFor (take);

        if (manager.getXRunCount() == lostBefore || isInterrupted())
            return toRecording (take, points);
    }

    throw InputError ("audio device", "keeps losing samples; choose a larger --block, or stop other programs");
}

/** Waits until a take is done; an interruption ends it at 0 V. */
void AudioBench::waitFor (Take& take)
{
    auto calls = player.calls();
    auto called = std::chrono::steady_clock::now();
    auto isDead = false;

    while (! take.isDone && ! isDead)
    {
        std::this_thread::sleep_for (5ms);

        if (isInterrupted())
            player.stop();

        if (player.calls() != calls)
        {
            calls = player.calls();
            called = std::chrono::steady_clock::now();
        }

        isDead = std::chrono::steady_clock::now() - called > patience;
    }

    if (isDead)
    {
        manager.closeAudioDevice(); // Before the take goes: its callback ends here.
        throw InputError ("audio device", "has stopped");
    }
}

RunRecording AudioBench::toRecording (const Take& take, Eigen::Index points) const
{
    RunRecording recording;
    recording.sensors.resize (points, take.recorded.rows());

    for (Eigen::Index sensor = 0; sensor < points; ++sensor)
        recording.sensors.row (sensor) =
            take.recorded.col (channelColumn (openInputs, channels.sensors[static_cast<std::size_t> (sensor)]))
                .cast<double>()
                .transpose()
            * velocity;

    if (channels.syncInput >= 0)
        recording.sync = take.recorded.col (channelColumn (openInputs, channels.syncInput)).cast<double>();

    return recording;
}
} // namespace antinode
