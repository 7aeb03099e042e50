#include "PlayedTouch.h"

#include <antinode_render/PlayedTracks.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
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

std::string measuredDevice()
{
    const auto* const named = std::getenv ("ANTINODE_TOUCH_DEVICE");
    return named != nullptr ? named : "glass-148x210";
}

/** So many fingers with 1 um for 1.0 on the measured device, their filters designed. */
std::unique_ptr<TouchProcessor> measuredTouch (int count, int latency = 0)
{
    const double places[][2] = { { 20, 35 }, { 75, 70 }, { 60, 20 }, { 35, 78 }, { 85, 35 } };
    auto processor = std::make_unique<TouchProcessor> (32, juce::AudioProcessor::wrapperType_Undefined);
    processor->load (touchDevice (measuredDevice()));
    std::map<std::string, double> parameters { { "latency", latency } };

    for (int k = 0; k < count; ++k)
    {
        const auto finger = "finger" + std::to_string (k + 1);
        parameters[finger + "_x"] = places[k][0];
        parameters[finger + "_y"] = places[k][1];
        parameters[finger + "_state"] = 2;
        parameters[finger + "_level"] = 1;
    }

    processor->parameters().setValues (parameters);
    REQUIRE (processor->setBusesLayout (touchLayout (count, 32)));
    processor->prepareToPlay (rate, block);
    processor->session().waitUntilSettled();
    return processor;
}

/** What the fingers feel, by half as many modes again, and prints it. @return  the worst bystander, dB */
double printScores (TouchProcessor& processor, WaveformsDescription description, const Eigen::MatrixXd& inputs,
                    const Eigen::MatrixXd& played)
{
    const auto model = processor.session().snapshot()->model;
    const auto modes = static_cast<int> (3 * (model->modes() - model->actuators()) / 2);
    const auto judge = solveDeviceWithStaticShare (processor.device()->description, std::min (500, modes), true);
    const SampledVoltages voltages { { Reconstruction::bandLimited, rate },
                                     -static_cast<double> (processor.getLatencySamples()) / rate,
                                     played.topRows (model->actuators()) * model->fullScaleVoltage };
    const auto scores =
        scoreTracks (playTracks (judge, description, voltages, 0.3), 1e-6 * inputs.transpose(), description.band);
    auto worst = -200.0;

    for (std::size_t k = 1; k < scores.fingers.size(); ++k)
        worst = std::max (worst, scores.suppression (k));

    std::printf ("%s, %td fingers, %d samples of latency: target %.1f dB, worst bystander %.1f dB, %.1f V for 5 um\n",
                 measuredDevice().c_str(), inputs.rows(), processor.getLatencySamples(),
                 10 * std::log10 (scores.normalisedError (0)), worst,
                 5 * voltages.values.cwiseAbs().maxCoeff() / inputs.cwiseAbs().maxCoeff());
    return worst;
}
} // namespace

// By hand: [.touch-resting], [.touch-moving] and [.touch-cost], on the device that ANTINODE_TOUCH_DEVICE says.
// Docs/Design/plugins.md.
TEST_CASE ("What fingers that rest feel of noise at the first of them", "[.touch-resting]")
{
    const auto count = GENERATE (2, 3, 5), latency = GENERATE (0, 1, 2);
    const auto processor = measuredTouch (count, latency);
    processor->prepareToPlay (rate, block);
    const auto inputs = oneNoise (count);
    const auto description =
        waveformsFor (processor->session().snapshot()->model->surface, processor->parameters().settings(), count);
    CHECK (printScores (*processor, description, inputs, voltagesOf (*processor, inputs, block)) < -30);
}

// In time with the clock, so that it depends on what else the machine does.
TEST_CASE ("What fingers feel of noise at one that moves at 100 mm/s", "[.touch-moving]")
{
    const auto count = GENERATE (2, 3, 5);
    const auto processor = measuredTouch (count);
    const auto& surface = processor->session().snapshot()->model->surface;
    auto description = waveformsFor (surface, processor->parameters().settings(), count);
    const auto latency = static_cast<double> (processor->getLatencySamples()) / rate;
    auto& point = description.tracks[0].point;
    point.path = { { movesFrom - latency, point.x, point.y },
                   { movesUntil - latency, point.x + speed * (movesUntil - movesFrom), point.y } };
    const auto inputs = oneNoise (count);
    const auto played = playedInTime (*processor, inputs, 100 / (surface.xMaximum - surface.xMinimum));
    CHECK (printScores (*processor, description, inputs, played) < -15);
}

TEST_CASE ("How much of a core the audio thread needs", "[.touch-cost]")
{
    const auto count = GENERATE (1, 3, 5);
    const auto processor = measuredTouch (count);
    const auto inputs = oneNoise (count);
    const auto* const focus = std::getenv ("ANTINODE_TOUCH_FOCUS"); // A focus of the library, 24 notes in all.
    std::vector<PlayedNote> notes;
    double least = 1e9;

    if (focus != nullptr)
    {
        processor->loadFocus (std::make_shared<const FocusDocument> (
            readFocusDocument (loadDocument (LibraryKind::focus, focus), "focus")));

        for (int k = 0; k < 24; ++k)
            notes.push_back ({ static_cast<int> (k * seconds * rate / 24), 40 + k, 127 });
    }

    for (int i = 0; i < 20; ++i)
    {
        const auto begin = std::clock();
        voltagesOf<float> (*processor, inputs, block, notes);
        least = std::min (least, static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC);
    }

    std::printf ("%s, %d fingers: %.1f %% of a core at 48 kHz, with the copies of the test\n", measuredDevice().c_str(),
                 count, 100 * least / seconds);
    CHECK (least < 1);
}
