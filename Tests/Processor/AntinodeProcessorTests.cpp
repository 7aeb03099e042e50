#include "PlayedProcessor.h"

#include <Processor/ParameterSet.h>
#include <Support/JuceMessages.h>
#include <antinode_documents/Library.h>
#include <antinode_focus/Prediction.h>
#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

using namespace antinode;

namespace
{
constexpr double rate = 48000;
constexpr int length = 3000;

Eigen::MatrixXd ceramicRows (const Eigen::MatrixXd& played, Eigen::Index ceramics)
{
    return played.topRows (ceramics);
}
} // namespace

TEST_CASE ("Middle C plays the voltages that the command line renders, to the sample, for any blocks", "[plugin]")
{
    const auto block = GENERATE (1, 64, 511, 8193);
    const auto processor = test::offlineProcessor (8, rate, block);
    const auto played = test::play (*processor, length, block, 100);
    const auto model = processor->session().snapshot()->model;
    const auto rendered = test::renderedDemonstrator (*model, rate, length - 100);
    CHECK (played.leftCols (100).isZero (0));
    CHECK ((ceramicRows (played, 8).rightCols (length - 100) - rendered).cwiseAbs().maxCoeff() < 1e-7);
    CHECK (rendered.cwiseAbs().maxCoeff() > 0.05);
    // The plate's velocity at the probe, 1.0 = 1 m/s: what the continuous voltages give, by a real-time model of the
    // plate.
    const auto design = designFocus (*model, demonstrator().focus->description, { Reconstruction::bandLimited, rate });
    const auto reached = modalVelocities (*model, predictStates (*model, design.program, design.program.focusTime));
    CHECK (played (8, 100 + 1200) == Approx (shapesAt (*model, 0.024, 0) * reached).epsilon (0.01));
}

TEST_CASE ("A velocity is an amplitude, other notes are other places", "[plugin]")
{
    const auto processor = test::offlineProcessor (8, rate, 512);
    const Eigen::MatrixXd loud = test::play (*processor, 9600, 512, 0);
    const Eigen::MatrixXd soft = test::play (*processor, 9600, 512, 0, 60, 64);
    CHECK ((soft.topRows (8) - loud.topRows (8) * (64 / 127.0)).cwiseAbs().maxCoeff() < 1e-9);
    const Eigen::MatrixXd other = test::play (*processor, 9600, 512, 0, 40);
    CHECK ((other - loud).cwiseAbs().maxCoeff() > 0.01);
}

TEST_CASE ("Channels beyond the device's ceramics are silent, and the first play the same without them", "[plugin]")
{
    const auto wide = test::offlineProcessor (64, rate, 512);
    const auto played = test::play (*wide, length, 512, 0);
    CHECK (played.rows() == 66);
    CHECK (played.middleRows (8, 56).isZero (0));
    CHECK (played.topRows (8).cwiseAbs().maxCoeff() > 0.05);

    const auto narrow = test::offlineProcessor (2, rate, 512);
    CHECK ((test::play (*narrow, length, 512, 0).topRows (2) - played.topRows (2)).cwiseAbs().maxCoeff() == 0);
}

TEST_CASE ("Disarmed, bypassed or muted, ceramics get 0 V", "[plugin]")
{
    const auto processor = test::offlineProcessor (8, rate, 512);
    processor->parameters().arm() = false;
    CHECK (test::play (*processor, length, 512, 1000).rightCols (length - 1000).topRows (8).isZero (0));
    processor->parameters().arm() = true;
    processor->parameters().bypass() = true;
    CHECK (test::play (*processor, length, 512, 1000).rightCols (length - 1000).topRows (8).isZero (0));
    processor->parameters().bypass() = false;
    processor->setMutes (0b100);
    const auto played = test::play (*processor, length, 512, 1000);
    CHECK (played.row (2).rightCols (length - 1000).isZero (0));
    CHECK (played.row (3).cwiseAbs().maxCoeff() > 0.01);
}

TEST_CASE ("Blocks longer than those that were prepared play the same", "[plugin]")
{
    const auto promised = test::offlineProcessor (8, 48000, 512), exceeded = test::offlineProcessor (8, 48000, 512);
    const auto expected = test::play (*promised, 8192, 512, 100);
    REQUIRE (expected.cwiseAbs().maxCoeff() > 0.01);
    CHECK (test::play (*exceeded, 8192, 4096, 100) == expected);
}

TEST_CASE ("A bypass ramps and never jumps", "[plugin]")
{
    const auto processor = test::offlineProcessor (8, 192000, 64);
    const auto played = test::play (*processor, 9600, 64, 0, 60, 127,
                                    [&] (int block)
                                    {
                                        if (block == 60)
                                            processor->parameters().bypass() = true;
                                    });
    const auto rendered = test::renderedDemonstrator (*processor->session().snapshot()->model, 192000, 9600);
    const auto from = 60 * 64, to = from + 960; // 5 ms
    CHECK ((played.topRows (8).leftCols (from) - rendered.leftCols (from)).cwiseAbs().maxCoeff() < 1e-7);
    CHECK (played.topRows (8).rightCols (9600 - to).isZero (0));

    for (int n = from; n < to; ++n)
        CHECK ((played.col (n).head (8) - rendered.col (n) * (1 - (n - from + 1) / 960.0)).cwiseAbs().maxCoeff()
               < 1e-7);
}

TEST_CASE ("After a restored state has been prepared the first note plays", "[plugin]")
{
    const auto processor = test::offlineProcessor (8, rate, 512);
    juce::MemoryBlock kept;
    processor->getStateInformation (kept);
    processor->parameters().find ("retrigger")->setValueNotifyingHost (1);
    processor->parameters().find ("note_off")->setValueNotifyingHost (1);
    test::play (*processor, 2000, 512, 0);
    processor->setStateInformation (kept.getData(), static_cast<int> (kept.getSize()));
    processor->prepareToPlay (rate, 512);
    const auto rendered = test::renderedDemonstrator (*processor->session().snapshot()->model, rate, length);
    CHECK ((test::play (*processor, length, 512, 0).topRows (8) - rendered).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE ("What notes do may change in the block of a note, and while one plays: none is lost or cut", "[plugin]")
{
    const auto* const identifier = GENERATE ("retrigger", "note_off", "focus_on_note");
    const auto changedIn = GENERATE (0, 1);
    CAPTURE (identifier, changedIn);
    const auto processor = test::offlineProcessor (8, rate, 512);
    const auto change = [&] (int block)
    {
        if (block == changedIn)
            processor->parameters().find (identifier)->setValueNotifyingHost (1);
    };
    const auto played = test::play (*processor, length, 512, 100, 60, 127, change);
    const auto rendered = test::renderedDemonstrator (*processor->session().snapshot()->model, rate, length - 100);
    CHECK ((ceramicRows (played, 8).rightCols (length - 100) - rendered).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE ("The tail is that of the parameters: behind it all voltages are 0 and the surface has decayed by 60 dB",
           "[plugin]")
{
    struct Settings
    {
        double focusTime, brake;
        bool isOnNote;
    };
    const auto [focusTime, brake, isOnNote] = GENERATE (Settings { 25, 0, false }, Settings { 400, 0, false },
                                                        Settings { 400, 0, true }, Settings { 60, 5, false });
    CAPTURE (focusTime, brake, isOnNote);
    const auto processor = test::offlineProcessor (8, rate, 512);
    auto& parameters = processor->parameters();
    setValue (*parameters.find ("focus_time"), focusTime);
    setValue (*parameters.find ("brake"), brake);
    setValue (*parameters.find ("focus_on_note"), isOnNote ? 1 : 0);
    const auto ringing = std::log (1000) / decayRates (*processor->session().snapshot()->model).minCoeff();
    CHECK (processor->getTailLengthSeconds() >= focusTime / 1000 + ringing); // At once.
    test::play (*processor, 512, 512, -1);
    const auto tail = processor->getTailLengthSeconds();
    CHECK (tail < focusTime / 1000 * (1 + brake) + 0.1 + ringing);
    const auto samples = static_cast<int> (std::ceil (tail * rate));
    const auto played = test::play (*processor, samples + 4800, 512, 0);
    CHECK (played.topRows (8).rightCols (4800).isZero (0));
    CHECK (played.row (8).leftCols (samples).cwiseAbs().maxCoeff() > 1e-3);
    CHECK (played.row (8).rightCols (4800).cwiseAbs().maxCoeff()
           < 1e-3 * played.row (8).leftCols (samples).cwiseAbs().maxCoeff());
}

TEST_CASE ("A host is told of another tail", "[plugin]")
{
    struct Listener : juce::AudioProcessorListener
    {
        void audioProcessorParameterChanged (juce::AudioProcessor*, int, float) override {}
        void audioProcessorChanged (juce::AudioProcessor* processor, const ChangeDetails& details) override
        {
            if (details.latencyChanged)
                tail = processor->getTailLengthSeconds();
        }

        double tail = 0;
    };
    Listener listener;
    const auto processor = test::offlineProcessor (8, rate, 512);
    processor->addListener (&listener);
    setValue (*processor->parameters().find ("focus_time"), 300);
    processor->session().waitUntilSettled();

    for (int i = 0; i < 5000 && listener.tail < 0.3; ++i)
        if (! test::answerNextMessage())
            std::this_thread::sleep_for (std::chrono::milliseconds (1));

    CHECK (listener.tail > 0.3);
    processor->removeListener (&listener);
}

TEST_CASE ("What is typed is read with a decimal comma, and changes nothing where it says nothing", "[plugin]")
{
    const auto processor = test::offlineProcessor (8, rate, 512);
    const auto typed = [&] (const char* identifier, const char* text)
    {
        auto& parameter = *processor->parameters().find (identifier);
        return static_cast<double> (
            parameter.convertFrom0to1 (parameter.getValueForText (juce::String::fromUTF8 (text))));
    };
    CHECK (processor->parameters().find ("x")->getCurrentValueAsText() == "24 mm");
    CHECK (typed ("output_trim", "-0,5") == Approx (-0.5).margin (1e-5));
    CHECK (typed ("output_trim", "\xE2\x88\x92"
                                 "0.5 dB")
           == Approx (-0.5).margin (1e-5));
    CHECK (typed ("width", "12,5 MM") == Approx (12.5).epsilon (1e-5));
    CHECK (typed ("width", "+12.5") == Approx (12.5).epsilon (1e-5));
    CHECK (typed ("voltage_limit", "as the focus says") == 0);
    CHECK (typed ("x", "50 %") == Approx (50).epsilon (1e-5));
    CHECK (typed ("x", "0,0 mm") == Approx (50).epsilon (1e-5));
    CHECK (typed ("modes", "12") == 12);
    CHECK (typed ("modes", "Chosen") == 0);
    CHECK (typed ("retrigger", "Restarts") == 1);
    CHECK (typed ("focus_on_note", "yes") == 1);
    setValue (*processor->parameters().find ("width"), 33);
    setValue (*processor->parameters().find ("modes"), 7);
    setValue (*processor->parameters().find ("note_off"), 2);
    setValue (*processor->parameters().find ("focus_on_note"), 1);

    for (const auto* const text :
         { "12 kg", "12 mm x", "1.000,5", "1,2,3", "twelve", "", "nan", "inf", "1e999", "--1", "12m m" })
    {
        CAPTURE (text);
        CHECK (typed ("width", text) == Approx (33).epsilon (1e-5));
        CHECK (typed ("focus_on_note", text) == 1);

        for (const auto& [identifier, value] : { std::pair ("modes", 7), std::pair ("note_off", 2) })
            CHECK (typed (identifier, text) == value);
    }

    CHECK (typed ("modes", "7.5") == 7);
}

TEST_CASE ("With the focus on the note the latency is the focus time, and the focus falls that much after the note",
           "[plugin]")
{
    const auto processor = test::offlineProcessor (8, rate, 512);
    processor->parameters().find ("focus_on_note")->setValueNotifyingHost (1);
    processor->prepareToPlay (rate, 512);
    CHECK (processor->getLatencySamples() == 1200);
    const auto played = test::play (*processor, 6000, 512, 2000);
    const auto rendered = test::renderedDemonstrator (*processor->session().snapshot()->model, rate, 4000);
    CHECK ((played.topRows (8).rightCols (4000) - rendered).cwiseAbs().maxCoeff() < 1e-7);
    CHECK (processor->getTailLengthSeconds() > 0.05);
}

TEST_CASE ("The rate may change on the fly, up to 768 kHz", "[plugin]")
{
    const auto processor = test::offlineProcessor (8, rate, 512);

    for (const auto other : { 24000.0, 44100.0, 192000.0, 768000.0, 96000.0 })
    {
        processor->prepareToPlay (other, 256);
        const auto samples = static_cast<int> (other * 0.03);
        const auto rendered = test::renderedDemonstrator (*processor->session().snapshot()->model, other, samples);
        const auto played = test::play (*processor, samples, 256, 0);
        CHECK ((played.topRows (8) - rendered).cwiseAbs().maxCoeff() < 1e-7);
    }
}

TEST_CASE ("What cannot be played at 8 kHz is silent and said", "[plugin]")
{
    const auto processor = test::offlineProcessor (8, 8000, 512);
    CHECK (test::play (*processor, 1000, 512, 0).isZero (0));
    CHECK (processor->warning().contains ("sample rate: is 8000 Hz, too low for mode 6"));
}

TEST_CASE ("Twenty instances play beside each other", "[plugin]")
{
    std::vector<std::unique_ptr<AntinodeProcessor>> all;

    for (int i = 0; i < 20; ++i)
        all.push_back (test::offlineProcessor (8, rate, 512));

    const auto first = test::play (*all.front(), length, 512, 0);

    for (const auto& processor : all)
        CHECK ((test::play (*processor, length, 512, 4000) - first).allFinite());
}
