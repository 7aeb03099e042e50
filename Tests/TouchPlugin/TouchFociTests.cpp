#include "PlayedTouch.h"

#include <Processor/AntinodeProcessor.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <limits>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int ceramics = 12, length = 9600;

std::shared_ptr<const FocusDocument> plateFocus()
{
    const std::string name = "aluminium-centre";
    return std::make_shared<const FocusDocument> (
        readFocusDocument (loadDocument (LibraryKind::focus, name), "focus '" + name + "'"));
}

std::unique_ptr<TouchProcessor> withFocus (int block, const std::map<std::string, double>& parameters = threeFingers())
{
    auto processor = offlineTouch (ceramics, rate, block, parameters);
    processor->loadFocus (plateFocus());
    return processor;
}

Eigen::MatrixXd noTracks()
{
    return Eigen::MatrixXd::Zero (8, length);
}

/** What the plug-in Antinode plays of a focus and notes. */
Eigen::MatrixXd playedByAntinode (const std::vector<PlayedNote>& notes,
                                  std::shared_ptr<const FocusDocument> focus = plateFocus())
{
    AntinodeProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor.setNonRealtime (true);
    processor.load (touchDevice ("aluminium-200x120"), std::move (focus));
    processor.prepareToPlay (rate, length);
    juce::AudioBuffer<double> buffer (processor.getTotalNumOutputChannels(), length);
    buffer.clear();
    auto midi = notesWithin (notes, 0, length);
    processor.processBlock (buffer, midi);
    Eigen::MatrixXd played (ceramics, length);

    for (int i = 0; i < ceramics; ++i)
        for (int n = 0; n < length; ++n)
            played (i, n) = buffer.getSample (i, n);

    return played;
}
} // namespace

TEST_CASE ("A note of Antinode Touch plays what Antinode plays, later by the latency", "[touch-plugin]")
{
    const auto choice = GENERATE (0, 2);
    const std::vector<PlayedNote> notes { { 100, 60, 127 }, { 1500, 47, 64 } };
    auto parameters = threeFingers();
    parameters["latency"] = choice;
    const auto processor = withFocus (512, parameters);
    const auto played = voltagesOf (*processor, noTracks(), 512, notes);
    const auto expected = playedByAntinode (notes);
    processor->prepareToPlay (rate, 512);
    const auto latency = processor->getLatencySamples();
    REQUIRE (latency == std::llround (touchLatencies[static_cast<std::size_t> (choice)] * rate));
    REQUIRE (expected.cwiseAbs().maxCoeff() > 1e-3);
    CHECK (played.leftCols (latency + 100).isZero (0));
    CHECK ((played.rightCols (length - latency) - expected.leftCols (length - latency)).cwiseAbs().maxCoeff()
           < 1e-12 * expected.cwiseAbs().maxCoeff());
}

TEST_CASE ("Foci and tracks add up below the limit", "[touch-plugin]")
{
    const std::vector<PlayedNote> notes { { 700, 60, 100 }, { 3000, 72, 127 } };
    const auto inputs = fingerTones (2, length, rate, 0.1);
    const auto both = voltagesOf (*withFocus (256), inputs, 256, notes);
    const auto track = voltagesOf (*withFocus (256), inputs, 256),
               focus = voltagesOf (*withFocus (256), noTracks(), 256, notes);
    REQUIRE (track.cwiseAbs().maxCoeff() > 1e-4);
    REQUIRE (focus.cwiseAbs().maxCoeff() > 1e-4);
    CHECK ((both - track - focus).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE ("Foci and tracks together stay within one limit", "[touch-plugin]")
{
    auto parameters = threeFingers();
    parameters["finger1_level"] = parameters["finger2_level"] = 100;
    const auto processor = withFocus (128, parameters);
    std::vector<PlayedNote> notes;

    for (int k = 0; k < 60; ++k)
        notes.push_back ({ 50 * k, 40 + k % 40, 127 });

    const auto played = voltagesOf (*processor, fingerTones (2, length, rate), 128, notes);
    const auto model = processor->session().snapshot()->model;
    const Eigen::VectorXd limits = voltageLimits (*model) / model->fullScaleVoltage;
    CHECK (played.allFinite());
    CHECK ((played.topRows (limits.size()).cwiseAbs().rowwise().maxCoeff() - limits).maxCoeff() <= 1e-12);
    CHECK (processor->session().meters().limitedSamples (0) > 0);
}

TEST_CASE ("Notes and tracks are the same to the bit for all blocks", "[touch-plugin]")
{
    const std::vector<PlayedNote> notes { { 0, 60, 127 }, { 63, 20, 90 }, { 64, 100, 1 }, { 2500, 60, 127 } };
    const auto inputs = fingerTones (8, length, rate);
    const auto once = voltagesOf (*withFocus (length), inputs, length, notes);

    for (const auto block : { 64, 511 })
        CHECK ((voltagesOf (*withFocus (block), inputs, block, notes) - once).isZero (0));
}

TEST_CASE ("Inputs that are not finite leave a focus as it is", "[touch-plugin]")
{
    const std::vector<PlayedNote> notes { { 700, 60, 100 } };
    const Eigen::MatrixXd bad = Eigen::MatrixXd::Constant (8, length, std::numeric_limits<double>::quiet_NaN());
    const auto played = voltagesOf (*withFocus (256), bad, 256, notes);
    CHECK (played == voltagesOf (*withFocus (256), noTracks(), 256, notes));
    CHECK (played.cwiseAbs().maxCoeff() > 1e-3);
}

TEST_CASE ("The gain makes foci softer, never louder, and arming silences them", "[touch-plugin]")
{
    const std::vector<PlayedNote> notes { { 0, 60, 127 } };
    const auto usual = voltagesOf (*withFocus (256), noTracks(), 256, notes);
    const auto gain = GENERATE (-6.0, 6.0);
    auto parameters = threeFingers();
    parameters["gain"] = gain;
    const auto factor = std::min (1.0, std::pow (10, gain / 20));
    const auto changed = voltagesOf (*withFocus (256, parameters), noTracks(), 256, notes);
    CHECK ((changed - factor * usual).cwiseAbs().maxCoeff() < 1e-6 * usual.cwiseAbs().maxCoeff());
    parameters["arm"] = 0;
    CHECK (voltagesOf (*withFocus (256, parameters), noTracks(), 256, notes).rightCols (length - 480).isZero (0));
}

TEST_CASE ("A state keeps the focus of Antinode Touch, and one without plays no notes", "[touch-plugin]")
{
    const std::vector<PlayedNote> notes { { 0, 60, 127 } };
    const auto bare = offlineTouch (ceramics, rate, 256);
    juce::MemoryBlock without, with;
    bare->getStateInformation (without);
    CHECK (voltagesOf (*bare, noTracks(), 256, notes).isZero (0));
    bare->loadFocus (plateFocus());
    bare->getStateInformation (with);
    const auto played = voltagesOf (*bare, noTracks(), 256, notes);

    const auto restored = offlineTouch (ceramics, rate, 256);
    restored->setStateInformation (with.getData(), static_cast<int> (with.getSize()));
    REQUIRE (restored->focus() != nullptr);
    CHECK (restored->focus()->text == plateFocus()->text);
    CHECK (voltagesOf (*restored, noTracks(), 256, notes) == played);
    restored->setStateInformation (without.getData(), static_cast<int> (without.getSize()));
    CHECK (restored->focus() == nullptr);
    voltagesOf (*restored, noTracks(), 256);
    CHECK (voltagesOf (*restored, noTracks(), 256, notes).isZero (0));

    auto broken = nlohmann::json::parse (with.toString().toStdString());
    broken["focus"]["targets"] = 3;
    const auto text = broken.dump();
    bare->setStateInformation (text.data(), static_cast<int> (text.size()));
    CHECK (bare->warning().startsWith ("The saved state could not be read; nothing was changed: state: focus"));
    CHECK (bare->focus()->text == plateFocus()->text);
}

TEST_CASE ("A focus outside the surface plays nothing, and says why", "[touch-plugin]")
{
    const auto processor = offlineTouch (ceramics, rate, 256);
    auto json = loadDocument (LibraryKind::focus, "aluminium-centre");
    json["targets"][0]["x_mm"] = 900;
    json.erase ("probes_mm");
    processor->loadFocus (std::make_shared<const FocusDocument> (readFocusDocument (json, "focus")));
    CHECK (voltagesOf (*processor, noTracks(), 256, { { 0, 60, 127 } }).isZero (0));
    CHECK (processor->warning().startsWith ("Notes play nothing: "));
}

namespace
{
/** Two fingers that load the surface, one of them at the focus. */
std::map<std::string, double> loadedFingers()
{
    auto parameters = threeFingers();
    parameters["finger1_x"] = 60;
    parameters["finger1_y"] = 50;
    parameters["finger1_load"] = 3;
    parameters["finger3_load"] = 2;
    return parameters;
}

/** The focus with the fingers of loadedFingers() in its own document. */
std::shared_ptr<const FocusDocument> focusUnderFingers()
{
    auto json = loadDocument (LibraryKind::focus, "aluminium-centre");
    json["fingers"] = { { { "kind", "firm" }, { "x_mm", 120 }, { "y_mm", 60 } },
                        { { "kind", "medium" }, { "x_mm", 110 }, { "y_mm", 24 } } };
    return std::make_shared<const FocusDocument> (readFocusDocument (json, "focus"));
}

/** Plays silence, as in real time, until foci know of the fingers what is expected. */
bool plays (TouchProcessor& processor, FociUnderFingers expected)
{
    for (int i = 0; i < 6000 && processor.session().fociUnderFingers() != expected; ++i)
    {
        voltagesOf (processor, noTracks().leftCols (512), 512);
        std::this_thread::sleep_for (std::chrono::milliseconds (10));
    }

    return processor.session().fociUnderFingers() == expected;
}

/** Waits for the focus at its own place, which is designed first: a whole bank under fingers takes minutes of a core.
 */
bool hasFirst (TouchProcessor& processor)
{
    for (int i = 0; i < 6000 && ! processor.session().focusProgress().hasFirst; ++i)
        std::this_thread::sleep_for (std::chrono::milliseconds (10));

    return processor.session().focusProgress().hasFirst;
}
} // namespace

TEST_CASE ("Foci of notes are designed for the fingers that rest, as for those of their own file", "[touch-plugin]")
{
    const std::vector<PlayedNote> notes { { 100, 60, 127 }, { 1500, 47, 64 } };
    const auto processor = withFocus (512, loadedFingers());
    const auto played = voltagesOf (*processor, noTracks(), 512, notes);
    const auto expected = playedByAntinode (notes, focusUnderFingers()), bare = playedByAntinode (notes);
    const auto latency = processor->getLatencySamples();
    const auto differs = [&] (const Eigen::MatrixXd& from)
    {
        return (played.rightCols (length - latency) - from.leftCols (length - latency)).cwiseAbs().maxCoeff()
               / from.cwiseAbs().maxCoeff();
    };
    CHECK (differs (expected) < 1e-9);
    CHECK (differs (bare) > 0.02);
}

TEST_CASE ("A finger of the session where the focus's own file has one is that finger", "[touch-plugin]")
{
    const std::vector<PlayedNote> notes { { 100, 60, 127 } };
    const auto alone = offlineTouch (ceramics, rate, 512), beside = offlineTouch (ceramics, rate, 512, loadedFingers());
    alone->loadFocus (focusUnderFingers());
    beside->loadFocus (focusUnderFingers());
    CHECK (voltagesOf (*alone, noTracks(), 512, notes) == voltagesOf (*beside, noTracks(), 512, notes));
}

TEST_CASE ("While fingers move the foci from before play on, where fingers rest they follow", "[touch-plugin]")
{
    const std::vector<PlayedNote> notes { { 0, 60, 127 } };
    TouchProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor.parameters().setValues (threeFingers());
    processor.prepareToPlay (rate, 512);
    processor.loadFocus (plateFocus());
    processor.session().waitUntilSettled();

    while (processor.session().focusProgress().wanted == 0 || ! processor.session().focusProgress().isDone())
        std::this_thread::sleep_for (std::chrono::milliseconds (5));

    const auto bare = voltagesOf (processor, noTracks(), 512, notes);
    CHECK (processor.session().fociUnderFingers() == FociUnderFingers::unaffected);
    processor.parameters().setValues (loadedFingers());
    REQUIRE (plays (processor, FociUnderFingers::designing));

    // One that moves on ends the work, and there is a whole bank to play.
    for (int i = 0; i < 6000 && processor.session().fociUnderFingers() != FociUnderFingers::outdated; ++i)
    {
        processor.parameters().setValues ({ { "finger3_x", 55 + i % 40 } });
        voltagesOf (processor, noTracks().leftCols (512), 512);
        std::this_thread::sleep_for (std::chrono::milliseconds (10));
    }

    CHECK (processor.session().fociUnderFingers() == FociUnderFingers::outdated);
    CHECK (processor.session().focusProgress().isDone());
    CHECK (voltagesOf (processor, noTracks(), 512, notes).cwiseAbs().maxCoeff() > 0.5 * bare.cwiseAbs().maxCoeff());
    processor.parameters().setValues (loadedFingers());
    REQUIRE (plays (processor, FociUnderFingers::designing));
    REQUIRE (hasFirst (processor));
    const auto known = voltagesOf (processor, noTracks(), 512, notes);
    CHECK ((known - bare).cwiseAbs().maxCoeff() > 0.02 * bare.cwiseAbs().maxCoeff());
    processor.parameters().setValues (threeFingers());
    processor.parameters().setValues ({ { "finger1_load", 0 }, { "finger3_load", 0 } });
    REQUIRE (plays (processor, FociUnderFingers::unaffected));
    REQUIRE (hasFirst (processor));
    CHECK (voltagesOf (processor, noTracks(), 512, notes).isApprox (bare, 1e-9));
}
