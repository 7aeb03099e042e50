#include "PlayedTouch.h"

#include <antinode_render/PlayedTracks.h>
#include <antinode_render/TrackScores.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <limits>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int ceramics = 12, length = 14400, rest = 4800;

double largestVoltage (TouchProcessor& processor)
{
    const auto model = processor.session().snapshot()->model;
    return voltageLimits (*model).maxCoeff() / model->fullScaleVoltage;
}

/** Inputs, and silence until their voltages have ended. */
Eigen::MatrixXd withRest (const Eigen::MatrixXd& inputs)
{
    Eigen::MatrixXd longer = Eigen::MatrixXd::Zero (inputs.rows(), inputs.cols() + rest);
    longer.leftCols (inputs.cols()) = inputs;
    return longer;
}

/** What a device with half as many modes again does at the fingers under voltages, from sample to sample: no filter, no
    transform, and more modes than the filters know. */
TrackScores judged (TouchProcessor& processor, const Eigen::MatrixXd& played, const Eigen::MatrixXd& inputs)
{
    const auto model = processor.session().snapshot()->model;
    const auto modes = 3 * (model->modes() - model->actuators()) / 2;
    const auto judge = solveDeviceWithStaticShare (processor.device()->description, static_cast<int> (modes), true);
    const auto settings = processor.parameters().settings();
    const auto description = touchedBy (model->surface, settings, processor.inputs());
    const auto latency = static_cast<double> (processor.getLatencySamples()) / rate;
    const SampledVoltages voltages { { Reconstruction::bandLimited, rate },
                                     -latency,
                                     played.topRows (model->actuators()) * model->fullScaleVoltage };
    const auto levels = processor.parameters().controls().levels;
    const auto tracks = std::ssize (description.tracks);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero (inputs.cols(), tracks + std::ssize (description.silent));

    for (Eigen::Index k = 0; k < tracks; ++k)
        wanted.col (k) = levels[static_cast<std::size_t> (k)] * inputs.row (k).transpose();

    return scoreTracks (playTracks (judge, description, voltages, 0.3), wanted, description.band);
}

juce::AudioProcessor::BusesLayout layoutOf (int fingers, int outputs)
{
    juce::AudioProcessor::BusesLayout layout;
    layout.inputBuses.add (juce::AudioChannelSet::discreteChannels (fingers));
    layout.outputBuses.add (juce::AudioChannelSet::discreteChannels (outputs));
    return layout;
}

juce::MemoryBlock stateOf (TouchProcessor& processor)
{
    juce::MemoryBlock state;
    processor.getStateInformation (state);
    return state;
}
} // namespace

TEST_CASE ("Each finger feels its own input after the latency that is reported, a silent one nothing", "[touch-plugin]")
{
    const auto choice = GENERATE (0, 2);
    auto parameters = threeFingers();
    parameters["latency"] = choice;
    const auto processor = offlineTouch (ceramics, rate, 512, parameters);
    processor->prepareToPlay (rate, 512);
    CHECK (processor->getLatencySamples() == std::llround (touchLatencies[static_cast<std::size_t> (choice)] * rate));
    auto inputs = withRest (fingerTones (8, length, rate));
    const auto scores = judged (*processor, voltagesOf (*processor, inputs, 512), inputs);
    REQUIRE (scores.fingers.size() == 3);
    // A design's own error is below -60 dB; modes that it does not know, and single precision, leave more.
    CHECK (scores.normalisedError (0) < 1e-4);
    CHECK (scores.normalisedError (1) < 1e-4);
    CHECK (scores.suppression (2) < -40);
    CHECK (processor->session().meters().limitedSamples (0) == 0);
}

TEST_CASE ("A track at one finger leaves the others at rest, whoever of them could play", "[touch-plugin]")
{
    const auto processor = offlineTouch (ceramics, rate, 512);
    Eigen::MatrixXd inputs = Eigen::MatrixXd::Zero (8, length + rest);
    inputs.row (0).head (length) = fingerTones (1, length, rate);
    const auto scores = judged (*processor, voltagesOf (*processor, inputs, 512), inputs);
    CHECK (scores.normalisedError (0) < 1e-4);
    CHECK (scores.suppression (1) < -40);
    CHECK (scores.suppression (2) < -40);
}

TEST_CASE ("Fingers that rest on the plate are in its filters", "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto bare = offlineTouch (ceramics, rate, 512, parameters);
    parameters["finger1_load"] = parameters["finger3_load"] = 2;
    const auto touched = offlineTouch (ceramics, rate, 512, parameters);
    const auto inputs = withRest (fingerTones (2, length, rate));
    const auto light = voltagesOf (*bare, inputs, 512), loaded = voltagesOf (*touched, inputs, 512);
    const auto& gains = touched->session().snapshot()->designs[0]->noiseGains;
    CHECK ((light - loaded).norm() > 0.02 * light.norm());
    CHECK (gains.col (0).norm() > 0);
    CHECK (gains.rightCols (5).isZero (0));
}

TEST_CASE ("The voltages of inputs are the same to the bit for all blocks", "[touch-plugin]")
{
    const auto inputs = fingerTones (8, 6000, rate);
    const auto once = voltagesOf (*offlineTouch (ceramics, rate, 6000), inputs, 6000);
    CHECK (once.cwiseAbs().maxCoeff() > 1e-4);

    for (const auto block : { 1, 64, 511 })
        CHECK ((voltagesOf (*offlineTouch (ceramics, rate, block), inputs, block) - once).isZero (0));
}

TEST_CASE ("Floats and doubles give the same voltages, to single precision", "[touch-plugin]")
{
    const auto inputs = fingerTones (8, 6000, rate);
    const auto one = offlineTouch (ceramics, rate, 100), other = offlineTouch (ceramics, rate, 100);
    const auto doubles = voltagesOf<double> (*one, inputs, 100), floats = voltagesOf<float> (*other, inputs, 100);
    CHECK ((doubles - floats).cwiseAbs().maxCoeff() < 1e-6 * doubles.cwiseAbs().maxCoeff());
}

TEST_CASE ("A level and the gain are factors of the voltages", "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto inputs = fingerTones (2, 6000, rate, 0.1);
    const auto usual = voltagesOf (*offlineTouch (ceramics, rate, 256, parameters), inputs, 256);
    parameters["gain"] = 6;
    parameters["finger1_level"] = 2;
    parameters["finger2_level"] = 1;
    const auto louder = voltagesOf (*offlineTouch (ceramics, rate, 256, parameters), inputs, 256);
    const auto factor = 2 * std::pow (10, 6.0 / 20);
    CHECK ((louder - factor * usual).cwiseAbs().maxCoeff() < 1e-4 * louder.cwiseAbs().maxCoeff());
}

TEST_CASE ("A finger that becomes silent does so within milliseconds, without other filters", "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto processor = offlineTouch (ceramics, rate, 256, parameters);
    Eigen::MatrixXd inputs = Eigen::MatrixXd::Zero (8, 2 * length);
    inputs.row (0) =
        Eigen::RowVectorXd::NullaryExpr (2 * length, [] (auto n) { return std::sin (0.03 * static_cast<double> (n)); });
    const auto before = voltagesOf (*processor, inputs, 256);
    const auto designs = processor->session().snapshot()->designs;
    parameters["finger1_state"] = 1;
    processor->parameters().setValues (parameters);
    processor->session().waitUntilSettled();
    const auto after = voltagesOf (*processor, inputs, 256);
    CHECK (processor->session().snapshot()->designs == designs);
    // The ramp of 5 ms, the filters of .1 s, and both changes of rate.
    CHECK (after.rightCols (2 * length - static_cast<Eigen::Index> (0.11 * rate)).isZero (0));
    CHECK (before.cwiseAbs().maxCoeff() > 1e-4);
}

TEST_CASE ("A finger that is moved while it plays feels its input at the new place", "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto processor = offlineTouch (ceramics, rate, 512, parameters);
    const auto inputs = withRest (fingerTones (2, length, rate));
    voltagesOf (*processor, inputs, 512);
    parameters["finger1_x"] = 45;
    parameters["finger1_y"] = 70;
    processor->parameters().setValues (parameters);
    // The cross-fade lies in the silence at the begin of the tones.
    const auto scores = judged (*processor, voltagesOf (*processor, inputs, 512), inputs);
    CHECK (scores.normalisedError (0) < 1e-3);
    CHECK (scores.suppression (2) < -40);
}

TEST_CASE ("No step is heard where filters follow each other", "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto processor = offlineTouch (ceramics, rate, 480, parameters);
    Eigen::MatrixXd inputs (1, length);
    inputs.row (0) =
        Eigen::RowVectorXd::NullaryExpr (length, [] (auto n) { return std::sin (0.03 * static_cast<double> (n)); });
    const auto steepest = [] (const Eigen::MatrixXd& played)
    { return (played.rightCols (played.cols() - 1) - played.leftCols (played.cols() - 1)).cwiseAbs().maxCoeff(); };
    voltagesOf (*processor, inputs, 480);
    const auto before = steepest (voltagesOf (*processor, inputs, 480).rightCols (length / 2));
    parameters["finger1_x"] = 60;
    processor->parameters().setValues (parameters);
    const auto changing = voltagesOf (*processor, inputs, 480);
    const auto after = steepest (changing.rightCols (length / 2));
    // The inputs begin again at 0: the very step of a sine.
    CHECK (steepest (changing) < 1.5 * std::max (before, after));
}

TEST_CASE ("Until filters are designed, and unprepared, all voltages are 0", "[touch-plugin]")
{
    TouchProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    const auto inputs = fingerTones (8, 2000, rate);
    CHECK (voltagesOf (processor, inputs, 64).isZero (0));
    auto none = threeFingers();
    none["finger1_state"] = none["finger2_state"] = none["finger3_state"] = 0;
    CHECK (voltagesOf (*offlineTouch (ceramics, rate, 64, none), inputs, 64).isZero (0));
    juce::AudioBuffer<float> tooFew (1, 64);
    tooFew.setSample (0, 3, 1);
    juce::MidiBuffer midi;
    processor.processBlock (tooFew, midi);
    CHECK (tooFew.getMagnitude (0, 64) == 0);
}

TEST_CASE ("Bypassed or disarmed, all voltages are 0 within 5 ms, and no input comes through", "[touch-plugin]")
{
    const auto processor = offlineTouch (ceramics, rate, 64);
    const auto inputs = fingerTones (8, length, rate);
    CHECK (voltagesOf (*processor, inputs, 64).cwiseAbs().maxCoeff() > 1e-4);
    auto& flag = GENERATE (true, false) ? processor->parameters().bypass() : processor->parameters().arm();
    flag = ! flag.get();
    const auto silent = voltagesOf (*processor, inputs, 64);
    CHECK (silent.rightCols (length - 300).isZero (0));
}

TEST_CASE ("Hostile inputs never give more than the limit, nothing that is not finite, and no crash", "[touch-plugin]")
{
    auto parameters = threeFingers();
    parameters["finger1_level"] = parameters["finger2_level"] = 100;
    parameters["gain"] = 20;
    const auto processor = offlineTouch (ceramics, rate, 333, parameters);
    const auto limit = largestVoltage (*processor);
    const auto kind = GENERATE (0, 1, 2, 3, 4);
    Eigen::MatrixXd inputs (8, length);
    juce::Random random (5);

    for (Eigen::Index n = 0; n < inputs.size(); ++n)
    {
        const double values[] = { std::numeric_limits<double>::quiet_NaN(),
                                  n % 3 == 0 ? std::numeric_limits<double>::infinity() : -1e300,
                                  2.0 * random.nextDouble() - 1, 1,
                                  std::sin (2 * std::numbers::pi * 10000 * static_cast<double> (n / 8) / rate) };
        inputs (n) = values[kind];
    }

    CAPTURE (kind);
    const auto played = voltagesOf (*processor, inputs, 333);
    CHECK (played.allFinite());
    CHECK (played.cwiseAbs().maxCoeff() <= limit);
    CHECK (processor->warning().isEmpty());
    // What came is forgotten after the filters' length, its offset after some seconds: then a usual input plays.
    processor->parameters().setValues (threeFingers());
    voltagesOf (*processor, Eigen::MatrixXd::Zero (8, static_cast<Eigen::Index> (8 * rate)), 333);
    const auto usual = withRest (fingerTones (8, length, rate));
    CHECK (judged (*processor, voltagesOf (*processor, usual, 333), usual).normalisedError (0) < 1e-4);
}

TEST_CASE ("Fingers that leap a thousand times a second leave all voltages within their limits", "[touch-plugin]")
{
    TouchProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor.parameters().setValues (threeFingers());
    processor.prepareToPlay (rate, 48);
    processor.session().waitUntilSettled();
    const auto limit = largestVoltage (processor);
    const auto inputs = fingerTones (8, 48, rate, 100);
    juce::Random random (3);
    auto isHeard = false, isWithin = true;

    for (int i = 0; i < 3000; ++i)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            processor.parameters().finger (k).x->setValueNotifyingHost (random.nextFloat());
            processor.parameters().finger (k).y->setValueNotifyingHost (random.nextFloat());
        }

        const auto played = voltagesOf (processor, inputs, 48);
        isHeard = isHeard || played.cwiseAbs().maxCoeff() > 1e-4;
        isWithin = isWithin && played.allFinite() && played.cwiseAbs().maxCoeff() <= limit;
    }

    CHECK (isHeard);
    CHECK (isWithin);
}

TEST_CASE ("Voltages of amplifiers with a slew rate never change quicker", "[touch-plugin]")
{
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["limits"]["slew_V_per_us"] = 0.01;
    auto parameters = threeFingers();
    parameters["finger1_level"] = 50;
    const auto processor = offlineTouch (ceramics, rate, 256, parameters);
    processor->load (touchDeviceFrom (json));
    processor->session().waitUntilSettled();
    processor->prepareToPlay (rate, 256);
    processor->session().waitUntilSettled();
    const auto model = processor->session().snapshot()->model;
    const auto steepest = model->ceramics[0].slewLimit / rate / model->fullScaleVoltage;
    REQUIRE (steepest > 0);
    Eigen::MatrixXd noise (2, length);
    juce::Random random (5);

    for (auto& value : noise.reshaped())
        value = 2 * random.nextDouble() - 1;

    const auto played = voltagesOf (*processor, noise, 256);
    const auto step = (played.rightCols (length - 1) - played.leftCols (length - 1)).cwiseAbs().maxCoeff();
    // The ramp of arming may add a thousandth; it has ended by then.
    CHECK (step <= steepest * (1 + 1e-9));
    CHECK (step > 0.9 * steepest);
}

TEST_CASE ("Fingers that no surface can tell apart are refused by their numbers, and those before play on",
           "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto processor = offlineTouch (ceramics, rate, 256, parameters);
    const auto inputs = withRest (fingerTones (2, length, rate));
    voltagesOf (*processor, inputs, 256); // The first filters fade in.
    const auto before = voltagesOf (*processor, inputs, 256);
    parameters["finger3_x"] = 25.2;
    parameters["finger3_y"] = 40;
    processor->parameters().setValues (parameters);
    processor->session().waitUntilSettled();
    const auto warning = processor->warning();
    CAPTURE (warning.toStdString());
    CHECK (warning.startsWith ("finger 3: is "));
    CHECK (warning.contains ("from finger 1"));
    CHECK (warning.endsWith ("; the filters before play on"));
    // But for what is left of the offset that the tones before had.
    CHECK ((voltagesOf (*processor, inputs, 256) - before).cwiseAbs().maxCoeff() < 1e-3 * before.cwiseAbs().maxCoeff());
    processor->parameters().setValues (threeFingers());
    processor->session().waitUntilSettled();
    CHECK (processor->warning().isEmpty());
}

TEST_CASE ("A finger without an input is silent", "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto processor = offlineTouch (ceramics, rate, 256, parameters);
    REQUIRE (processor->setBusesLayout (layoutOf (2, ceramics)));
    parameters["finger3_state"] = 2;
    processor->parameters().setValues (parameters);
    processor->prepareToPlay (rate, 256);
    const auto inputs = withRest (fingerTones (2, length, rate));
    const auto scores = judged (*processor, voltagesOf (*processor, inputs, 256), inputs);
    REQUIRE (scores.fingers.size() == 3);
    CHECK (scores.normalisedError (1) < 1e-4);
    CHECK (scores.suppression (2) < -40);
}

TEST_CASE ("Layouts of 1 to 8 fingers and 1 to 64 ceramics are taken, others not", "[touch-plugin]")
{
    TouchProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    CHECK (processor.isBusesLayoutSupported (layoutOf (1, 1)));
    CHECK (processor.isBusesLayoutSupported (layoutOf (8, 64)));
    CHECK (processor.isBusesLayoutSupported (layoutOf (2, 2)));
    CHECK_FALSE (processor.isBusesLayoutSupported (layoutOf (0, 8)));
    CHECK_FALSE (processor.isBusesLayoutSupported (layoutOf (9, 8)));
    CHECK_FALSE (processor.isBusesLayoutSupported (layoutOf (1, 0)));
    CHECK_FALSE (processor.isBusesLayoutSupported (layoutOf (8, 65)));
}

TEST_CASE ("Another latency is reported, and its filters give the same voltages as if they had been first",
           "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto changed = offlineTouch (ceramics, rate, 256, parameters);
    const auto inputs = withRest (fingerTones (2, length, rate));
    voltagesOf (*changed, inputs, 256);
    parameters["latency"] = 1;
    changed->parameters().setValues (parameters);
    changed->session().waitUntilSettled();
    const auto other = offlineTouch (ceramics, rate, 256, parameters);
    changed->prepareToPlay (rate, 256);
    CHECK (changed->getLatencySamples() == 480);
    CHECK (other->getLatencySamples() == 480);
    voltagesOf (*changed, Eigen::MatrixXd::Zero (2, length), 256);
    voltagesOf (*other, Eigen::MatrixXd::Zero (2, length), 256);
    CHECK ((voltagesOf (*changed, inputs, 256) - voltagesOf (*other, inputs, 256)).isZero (0));
}

TEST_CASE ("Every rate from 44.1 to 192 kHz has its latency within a sample of the filters, lower ones are refused",
           "[touch-plugin]")
{
    for (const auto hertz : { 44100.0, 88200.0, 192000.0 })
    {
        const auto processor = offlineTouch (ceramics, hertz, 256);
        CHECK (processor->getLatencySamples() / hertz == Approx (0.02).margin (1.0 / 4000));
        CHECK (voltagesOf (*processor, fingerTones (2, 20000, hertz), 256).cwiseAbs().maxCoeff() > 1e-4);
    }

    const auto slow = offlineTouch (ceramics, 2000, 256);
    CHECK (slow->warning().contains ("sample rate"));
    CHECK (voltagesOf (*slow, fingerTones (2, 2000, 2000), 256).isZero (0));
    slow->prepareToPlay (rate, 256);
    slow->session().waitUntilSettled();
    CHECK (slow->warning().isEmpty());
    CHECK (voltagesOf (*slow, fingerTones (2, length, rate), 256).cwiseAbs().maxCoeff() > 1e-4);
}

TEST_CASE ("What fingers are asked to feel is metered: displacement, sensation, input", "[touch-plugin]")
{
    const auto processor = offlineTouch (ceramics, rate, 256);
    Eigen::MatrixXd inputs = Eigen::MatrixXd::Zero (8, 48000);
    inputs.row (0) = Eigen::RowVectorXd::NullaryExpr (
        48000, [] (auto n) { return 0.5 * std::sin (2 * std::numbers::pi * 250 * static_cast<double> (n) / rate); });
    auto& meters = processor->session().fingerMeters();
    voltagesOf (*processor, inputs, 256);
    meters.displacements.take (0);
    meters.felt.take (0);
    voltagesOf (*processor, inputs, 256);
    CHECK (meters.inputs.take (0) == Approx (0.5).epsilon (1e-3));
    // 1 um per 1.0, 250 Hz, where the threshold is .1 um: the built-in table.
    CHECK (meters.displacements.take (0) == Approx (0.5e-6).epsilon (0.02));
    CHECK (meters.felt.take (0) == Approx (0.5e-6 / 1e-7).epsilon (0.05));
    CHECK (meters.felt.take (1) == 0);
}

TEST_CASE ("A device that has to be armed comes disarmed, from a file and from a state", "[touch-plugin]")
{
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["limits"]["requires_arming"] = true;
    const auto processor = offlineTouch (ceramics, rate, 256);
    CHECK (processor->parameters().arm().get());
    processor->load (touchDeviceFrom (json));
    CHECK_FALSE (processor->parameters().arm().get());
    processor->session().waitUntilSettled();
    CHECK (voltagesOf (*processor, fingerTones (2, length, rate), 256).rightCols (length - 600).isZero (0));
    processor->parameters().arm() = true;
    const auto state = stateOf (*processor);
    const auto restored = offlineTouch (ceramics, rate, 256);
    restored->setStateInformation (state.getData(), static_cast<int> (state.getSize()));
    CHECK_FALSE (restored->parameters().arm().get());
}

TEST_CASE ("A state gives the same voltages back", "[touch-plugin]")
{
    auto parameters = threeFingers();
    parameters["latency"] = 2;
    const auto first = offlineTouch (ceramics, rate, 256, parameters);
    const auto second = offlineTouch (ceramics, rate, 256, {});
    const auto state = stateOf (*first);
    second->setStateInformation (state.getData(), static_cast<int> (state.getSize()));
    CHECK (stateOf (*second) == state);
    second->session().waitUntilSettled();
    first->prepareToPlay (rate, 256);
    second->prepareToPlay (rate, 256);
    const auto silence = Eigen::MatrixXd::Zero (8, 4800);
    voltagesOf (*first, silence, 256);
    voltagesOf (*second, silence, 256);
    const auto inputs = fingerTones (8, length, rate);
    CHECK ((voltagesOf (*second, inputs, 256) - voltagesOf (*first, inputs, 256)).isZero (0));
}

TEST_CASE ("A state of Antinode Touch that cannot be read changes nothing and is one sentence", "[touch-plugin]")
{
    const auto processor = offlineTouch (ceramics, rate, 64);
    const auto before = stateOf (*processor);

    for (const auto& text :
         { std::string(), std::string ("no state"), std::string (1000, '\0'),
           std::string (R"({"schema":"antinode.plate/1"})"), std::string (R"({"schema":"antinode.touch/2"})"),
           std::string (R"({"schema":"antinode.touch/1","device":3,"parameters":{}})"),
           before.toString().toStdString().substr (0, 500) })
    {
        CAPTURE (text);
        processor->setStateInformation (text.data(), static_cast<int> (text.size()));
        CHECK (processor->warning().startsWith ("The saved state could not be read, so nothing was changed: "));
        CHECK_FALSE (processor->warning().containsChar ('\n'));
        CHECK (stateOf (*processor) == before);
    }
}

TEST_CASE ("A device that no filters can be designed for leaves the present one playing, and says why",
           "[touch-plugin]")
{
    const auto processor = offlineTouch (ceramics, rate, 64);
    auto json = loadDocument (LibraryKind::device, "beam");
    json["ceramics"] = nlohmann::json::array();
    processor->load (touchDeviceFrom (json));
    processor->session().waitUntilSettled();
    CHECK (processor->warning() == "device 'beam': has no ceramics, so nothing can move it");
    CHECK (voltagesOf (*processor, fingerTones (2, length, rate), 64).cwiseAbs().maxCoeff() > 1e-4);
}

TEST_CASE ("More fingers than ceramics are refused in a sentence", "[touch-plugin]")
{
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["ceramics"].erase (json["ceramics"].begin() + 2, json["ceramics"].end());
    const auto processor = offlineTouch (2, rate, 64);
    processor->load (touchDeviceFrom (json));
    processor->session().waitUntilSettled();
    CHECK (processor->warning().startsWith ("touch 3 points; allowed: at most 2"));
}

TEST_CASE ("Touch plug-ins end in the middle of anything", "[touch-plugin]")
{
    for (int i = 0; i < 12; ++i)
    {
        TouchProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
        processor.session().setComparing (i % 2 == 0);

        if (i % 3 != 0)
            processor.prepareToPlay (rate, 64);

        if (i % 4 == 0)
            processor.load (touchDevice ("beam"));

        voltagesOf (processor, fingerTones (8, 64 * i, rate), 64);
        processor.parameters().finger (0).x->setValueNotifyingHost (static_cast<float> (i) / 12);
        std::this_thread::sleep_for (std::chrono::milliseconds (20 * i));
    }

    SUCCEED();
}
