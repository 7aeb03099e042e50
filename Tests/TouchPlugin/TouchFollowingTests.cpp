#include "JudgedTouch.h"
#include "Support/FollowedWindows.h"

#include <antinode_engine/PlateModel.h>
#include <antinode_focus/Detuning.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

using namespace antinode;

namespace
{
/** Antinode Touch on an aluminium plate that was identified and has drifted, with half as many modes again. A sensor
    hears it 3 ms late, with noise 40 dB below. */
struct FollowedTouch
{
    static constexpr int block = 256, late = 144, windowSamples = 24576; // samples

    explicit FollowedTouch (const FollowingSettings& settings, double drift)
        : processor (8, juce::AudioProcessor::wrapperType_Undefined)
    {
        processor.parameters().setValues (test::threeFingers());
        processor.setRateAndBufferSizeDetails (test::judgedRate, block);
        processor.prepareToPlay (test::judgedRate, block);
        session().following().setSettings (settings);
        session().waitUntilSettled();
        truth = detuned (test::judgeOf (processor), { 5e-4, 0.02, 1e-3, 0 }, 3);
        truth.angularFrequencies *= 1 + drift;
        const Playback playback { Reconstruction::bandLimited, test::judgedRate };
        Eigen::MatrixXd heard (1, truth.modes());
        heard.row (0) = settings.isCeramic()
                            ? Eigen::RowVectorXd (truth.participation.col (settings.ceramic).transpose())
                            : shapesAt (truth, settings.xMillimetres / 1e3, settings.yMillimetres / 1e3);
        plate = std::make_unique<PlateModel> (truth, playback, heard);
    }

    TouchSession& session() { return processor.session(); }
    FollowingStatus status() { return *session().following().status(); }

    /** Plays inputs, and gives back what the ceramics got. @param inputs  fingers x samples, whole blocks */
    Eigen::MatrixXd play (const Eigen::MatrixXd& inputs)
    {
        Eigen::MatrixXd played (8, inputs.cols());

        for (Eigen::Index done = 0; done < inputs.cols(); done += block)
        {
            played.middleCols (done, block) = playBlock (inputs.middleCols (done, block));
            clock += block;

            if (clock % windowSamples < block)
                windows.await (static_cast<double> (clock) / test::judgedRate, [this] { return status(); });
        }

        return played;
    }

    /** Noise within the band at both fingers. */
    void playNoise (double seconds)
    {
        const auto blocks = static_cast<int> (seconds * test::judgedRate) / block;
        Eigen::MatrixXd inputs (8, blocks * block);
        inputs.setZero();

        for (Eigen::Index n = 0; n < inputs.cols(); ++n)
            for (int k = 0; k < 2; ++k)
            {
                auto& filtered = noiseOf[static_cast<std::size_t> (k)];
                constexpr double keep = 0.9; // a low-pass of first order, 800 Hz
                filtered = keep * filtered + (1 - keep) * random.normal (1)[0];
                inputs (k, n) = std::clamp (filtered, -1.0, 1.0);
            }

        play (inputs);
    }

    Eigen::MatrixXd playBlock (const Eigen::MatrixXd& inputs)
    {
        juce::AudioBuffer<double> buffer (std::max (processor.getTotalNumInputChannels(), 8), block);
        buffer.clear();

        for (int i = 0; i < 2; ++i)
            for (int n = 0; n < block; ++n)
                buffer.setSample (i, n, inputs (i, n));

        for (int n = 0; n < block; ++n)
            buffer.setSample (sensorChannel, n, cable[n]);

        juce::MidiBuffer midi;
        processor.processBlock (buffer, midi);
        Eigen::MatrixXd played (8, block);

        for (int i = 0; i < 8; ++i)
            for (int n = 0; n < block; ++n)
                played (i, n) = buffer.getSample (i, n);

        Eigen::MatrixXd signal (1, block);
        plate->process (session().snapshot()->model->fullScaleVoltage * played, signal);
        energy = 0.999 * energy + 0.001 * signal.squaredNorm() / block;
        Eigen::RowVectorXd next (cable.size());
        next << cable.tail (cable.size() - block),
            scale * (signal.row (0) + 0.01 * std::sqrt (energy) * random.normal (block).transpose());
        cable = next;
        return played;
    }

    /** Error and what the silent finger feels, dB, of the filters as they are. */
    std::pair<double, double> judged()
    {
        session().waitUntilSettled();
        play (Eigen::MatrixXd::Zero (8, 120 * block)); // what was played before has ended
        const auto inputs = test::withRest (test::fingerTones (8, 9600 - 9600 % block, test::judgedRate));
        Eigen::MatrixXd whole = Eigen::MatrixXd::Zero (8, (inputs.cols() + block - 1) / block * block);
        whole.topLeftCorner (2, inputs.cols()) = inputs.topRows (2);
        const auto scores = test::judgedBy (truth, processor, play (whole), whole);
        return { 10 * std::log10 (std::max (scores.normalisedError (0), scores.normalisedError (1))),
                 scores.suppression (2) };
    }

    TouchProcessor processor;
    ModalModel truth;
    std::unique_ptr<PlateModel> plate;
    RandomNumbers random { 5 };
    std::array<double, 2> noiseOf {};
    Eigen::RowVectorXd cable = Eigen::RowVectorXd::Zero (late + block);
    static constexpr int sensorChannel = TouchProcessor::maximumFingers;
    double scale = -2, energy = 0; // the wires are swapped
    std::int64_t clock = 0;
    test::FollowedWindows windows;
};

FollowingSettings velocityAt (double xMillimetres, double yMillimetres)
{
    FollowingSettings settings;
    settings.sensor = FollowingSensor::velocity;
    settings.xMillimetres = xMillimetres;
    settings.yMillimetres = yMillimetres;
    return settings;
}
} // namespace

TEST_CASE ("While fingers feel tracks, filters follow a device that is off its model", "[touch-plugin][following]")
{
    FollowedTouch touch (velocityAt (180, 20), 0.004);
    const auto before = touch.judged();
    touch.playNoise (5);
    const auto status = touch.status();
    INFO (status.reason);
    CHECK (status.state == FollowingState::following);
    const auto after = touch.judged();
    CAPTURE (before.first, before.second, after.first, after.second, touch.status().redesigns);
    CHECK (after.first < before.first - 10);
    CHECK (after.second < before.second - 10);
    CHECK (touch.status().redesigns > 0);
}

TEST_CASE ("A ceramic that listens in Antinode Touch is not driven", "[touch-plugin][following]")
{
    FollowingSettings settings;
    settings.sensor = FollowingSensor::ceramicCharge;
    settings.ceramic = 3;
    FollowedTouch touch (settings, 0.002);
    Eigen::MatrixXd inputs = Eigen::MatrixXd::Zero (8, 60 * FollowedTouch::block);
    inputs.topRows (2) = test::fingerTones (2, static_cast<int> (inputs.cols()), test::judgedRate);
    const auto played = touch.play (inputs);
    CHECK (played.row (3).cwiseAbs().maxCoeff() == 0);
    CHECK (played.cwiseAbs().rowwise().maxCoeff().minCoeff() == 0);
    CHECK ((played.cwiseAbs().rowwise().maxCoeff().array() > 0).count() == 7);
}

TEST_CASE ("Fingers that load the surface pause what is learnt of it", "[touch-plugin][following]")
{
    FollowedTouch touch (velocityAt (180, 20), 0.002);
    touch.playNoise (3);
    REQUIRE (touch.session().following().drift() != nullptr);
    touch.processor.parameters().setValues ({ { "finger1_load", 2 } });
    touch.session().waitUntilSettled();
    touch.playNoise (0.2);
    const auto moments = touch.status().trace.size();
    const auto known = touch.session().following().drift();
    touch.playNoise (1.5);
    CHECK (touch.status().state == FollowingState::paused);
    CHECK (touch.status().reason == "Fingers load the surface and change its modes.");
    CHECK (touch.status().trace.size() == moments);
    CHECK (touch.session().following().drift() == known);
}

TEST_CASE ("A sensor that is broken never reaches the ceramics of Antinode Touch", "[touch-plugin][following]")
{
    FollowedTouch touch (velocityAt (180, 20), 0);
    Eigen::MatrixXd inputs = Eigen::MatrixXd::Zero (8, 60 * FollowedTouch::block);
    inputs.topRows (2) = test::fingerTones (2, static_cast<int> (inputs.cols()), test::judgedRate);

    for (const auto broken : { std::numeric_limits<double>::quiet_NaN(), 1.0, 0.0 })
    {
        touch.scale = broken;
        const auto played = touch.play (inputs);
        CHECK (played.allFinite());
        CHECK (played.cwiseAbs().maxCoeff() <= 1);
    }
}

TEST_CASE ("A state of Antinode Touch keeps its sensor", "[touch-plugin][following]")
{
    const auto processor = test::offlineTouch (8, test::judgedRate, 256);
    auto settings = velocityAt (12.5, 7.25);
    settings.isFrozen = true;
    processor->session().following().setSettings (settings);
    juce::MemoryBlock state;
    processor->getStateInformation (state);
    const auto other = test::offlineTouch (8, test::judgedRate, 256);
    CHECK_FALSE (other->session().following().settings().isOn());
    other->setStateInformation (state.getData(), static_cast<int> (state.getSize()));
    CHECK (other->session().following().settings() == settings);
}
