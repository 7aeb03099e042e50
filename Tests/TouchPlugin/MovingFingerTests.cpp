#include "PlayedTouch.h"

#include <antinode_render/PlayedTracks.h>
#include <antinode_render/TrackScores.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdio>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000, speed = 0.1, movesFrom = 0.2, movesUntil = 0.7; // Hz, m/s, s, s
constexpr int block = 128, seconds = 1;

/** Noise of the band at finger 1 that fades in and out, nothing at the others. */
Eigen::MatrixXd oneNoise (int fingers)
{
    constexpr int length = seconds * 48000;
    Eigen::MatrixXd inputs = Eigen::MatrixXd::Zero (fingers, length);
    juce::Random random (11);

    for (double frequency = 60; frequency < 900; frequency += 13)
    {
        const auto phase = 2 * std::numbers::pi * random.nextDouble();

        for (int n = 0; n < length; ++n)
            inputs (0, n) += 0.02 * std::sin (2 * std::numbers::pi * frequency * n / rate + phase)
                             * std::pow (std::sin (std::numbers::pi * n / length), 2);
    }

    return inputs;
}

/** Plays as an audio interface would, in time with the clock, while finger 1 moves to the right. */
Eigen::MatrixXd playedInTime (TouchProcessor& processor, const Eigen::MatrixXd& inputs, double percentPerMetre)
{
    Eigen::MatrixXd played (processor.getTotalNumOutputChannels(), inputs.cols());
    const auto begin = std::chrono::steady_clock::now();
    auto& x = *processor.parameters().finger (0).x;
    const auto from = x.get();

    for (Eigen::Index n = 0; n < inputs.cols(); n += block)
    {
        const auto time = static_cast<double> (n) / rate;
        x = from + percentPerMetre * speed * (std::clamp (time, movesFrom, movesUntil) - movesFrom);
        std::this_thread::sleep_until (begin + std::chrono::duration<double> (time));
        const auto count = std::min<Eigen::Index> (block, inputs.cols() - n);
        played.middleCols (n, count) = voltagesOf (processor, inputs.middleCols (n, count), block);
    }

    return played;
}
} // namespace

// By hand: in time with the clock, so that it depends on what else the machine does. ANTINODE_TOUCH_DEVICE says which.
TEST_CASE ("A finger that moves at 100 mm/s: what it and the others feel", "[.moving]")
{
    const auto* const named = std::getenv ("ANTINODE_TOUCH_DEVICE");
    const std::string name = named != nullptr ? named : "glass-148x210";
    const auto count = GENERATE (2, 3, 5);
    const double places[][2] = { { 20, 35 }, { 75, 70 }, { 60, 20 }, { 35, 78 }, { 85, 35 } };
    TouchProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    processor.load (touchDevice (name));
    std::map<std::string, double> parameters;

    for (int k = 0; k < count; ++k)
    {
        const auto finger = "finger" + std::to_string (k + 1);
        parameters[finger + "_x"] = places[k][0];
        parameters[finger + "_y"] = places[k][1];
        parameters[finger + "_state"] = 2;
        parameters[finger + "_level"] = 1;
    }

    processor.parameters().setValues (parameters);
    REQUIRE (processor.setBusesLayout (
        { { juce::AudioChannelSet::discreteChannels (count) }, { juce::AudioChannelSet::discreteChannels (32) } }));
    processor.prepareToPlay (rate, block);
    processor.session().waitUntilSettled();
    const auto model = processor.session().snapshot()->model;
    const auto modes = static_cast<int> (3 * (model->modes() - model->actuators()) / 2);
    const auto judge = solveDeviceWithStaticShare (processor.device()->description, std::min (500, modes), true);
    auto description = touchedBy (model->surface, processor.parameters().settings(), count);
    const auto latency = static_cast<double> (processor.getLatencySamples()) / rate;
    auto& point = description.tracks[0].point;
    point.path = { { movesFrom - latency, point.x, point.y },
                   { movesUntil - latency, point.x + speed * (movesUntil - movesFrom), point.y } };
    const auto inputs = oneNoise (count);
    const auto width = model->surface.xMaximum - model->surface.xMinimum;
    const auto played = playedInTime (processor, inputs, 100 / width);
    const SampledVoltages voltages { { Reconstruction::bandLimited, rate },
                                     -latency,
                                     played.topRows (model->actuators()) * model->fullScaleVoltage };
    const auto scores =
        scoreTracks (playTracks (judge, description, voltages, 0.3), 1e-6 * inputs.transpose(), description.band);
    auto worst = -200.0;

    for (std::size_t k = 1; k < scores.fingers.size(); ++k)
        worst = std::max (worst, scores.suppression (k));

    std::printf ("%s, %d fingers: target %.1f dB, worst bystander %.1f dB\n", name.c_str(), count,
                 10 * std::log10 (scores.normalisedError (0)), worst);
    CHECK (worst < -15);
}
