#include "PlayedTouch.h"

#include <Touch/TouchContent.h>

#include <Support/EditorTools.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("The touch editor loads the focus that notes play, and says what is wrong with one",
           "[touch-plugin][editor]")
{
    const auto processor = offlineTouch (16, 48000, 480);
    TouchEditor editor (*processor);
    auto& content = editor.content();
    content.focusButton().loadDocument ("aluminium-centre");
    REQUIRE (processor->focus() != nullptr);
    CHECK (processor->focus()->description.name == "aluminium-centre");
    content.focusButton().loadDocument ("no-such-focus");
    content.refresh (0.1);
    CHECK (content.statusLine().text().contains ("no-such-focus"));
    CHECK (processor->focus()->description.name == "aluminium-centre");
}

TEST_CASE ("The controls of a finger that is pressed are shown", "[touch-plugin][editor]")
{
    const auto processor = offlineTouch (16, 48000, 480);
    TouchEditor editor (*processor);
    auto& content = editor.content();
    auto& surface = content.surface();
    refreshUntil (content, [&] { return content.hasPicture(); });
    editor.createComponentSnapshot (editor.getLocalBounds(), true, 1); // It is laid out where it is painted.
    surface.mouseDown (mouseAt (surface, surface.finger (1)));
    surface.mouseUp (mouseAt (surface, surface.finger (1)));
    CHECK (content.fingers().selected() == 1);
}

TEST_CASE ("A double click puts the next finger down where it is, up to eight", "[touch-plugin][editor]")
{
    const auto processor = offlineTouch (16, 48000, 480);
    TouchEditor editor (*processor);
    auto& surface = editor.content().surface();
    refreshUntil (editor.content(), [&] { return editor.content().hasPicture(); });
    editor.createComponentSnapshot (editor.getLocalBounds(), true, 1);
    const auto place = surface.finger (0) + juce::Point<float> (50, 0);
    surface.mouseDoubleClick (mouseAt (surface, surface.finger (0)));
    CHECK (processor->parameters().settings().fingers[3].presence == FingerPresence::absent);
    surface.mouseDoubleClick (mouseAt (surface, place));
    CHECK (processor->parameters().settings().fingers[3].presence == FingerPresence::plays);
    CHECK (surface.finger (3).getDistanceFrom (place) < 0.5F);
    CHECK (editor.content().fingers().selected() == 3);

    for (int k = 4; k < mostFingers; ++k)
        CHECK (surface.putDown ({ 30.0F * static_cast<float> (k), 60 }));

    CHECK_FALSE (surface.putDown (place));
}

TEST_CASE ("The volts of all latencies are shown once they are designed: 5 ms costs most", "[touch-plugin][editor]")
{
    const auto processor = offlineTouch (16, 48000, 480);
    TouchEditor editor (*processor);
    auto& content = editor.content();
    refreshUntil (content, [&] { return content.volts().contains ("5 ms: "); });
    CHECK (content.volts().startsWith ("20 ms: "));
    const auto voltsAt = [&] (std::size_t latency)
    { return *noiseVolts (*processor->session().snapshot(), processor->parameters().controls(), latency); };
    CHECK (voltsAt (0) < 0.95 * voltsAt (2));
    CHECK (voltsAt (1) < 0.98 * voltsAt (2));
}

TEST_CASE ("The volts that are shown are those of noise that is played", "[touch-plugin]")
{
    constexpr int length = 96000;
    const auto processor = offlineTouch (16, 48000, 480);
    Eigen::MatrixXd noise (2, length);
    juce::Random random (9);

    // Many tones of one power at random phases fill the band; a third of full scale is their RMS.
    for (Eigen::Index k = 0; k < 2; ++k)
    {
        noise.row (k).setZero();

        for (double frequency = 41; frequency < 1000; frequency += 7)
        {
            const auto phase = 2 * std::numbers::pi * random.nextDouble();

            for (int n = 0; n < length; ++n)
                noise (k, n) += std::sin (2 * std::numbers::pi * frequency * n / 48000 + phase);
        }

        noise.row (k) *= std::sqrt (static_cast<double> (length)) / noise.row (k).norm() / 3;
    }

    const Eigen::MatrixXd played = voltagesOf (*processor, noise, 480).rightCols (length / 2);
    const auto model = processor->session().snapshot()->model;
    const auto rms = (played.rowwise().norm() / std::sqrt (length / 2.0)).maxCoeff() * model->fullScaleVoltage;
    CHECK (*noiseVolts (*processor->session().snapshot(), processor->parameters().controls(), 0)
           == Approx (3 * rms).epsilon (0.1));
}

TEST_CASE ("The touch editor says what goes on in its status line", "[touch-plugin][editor]")
{
    const auto processor = offlineTouch (4, 48000, 480);
    TouchEditor editor (*processor);
    auto& content = editor.content();
    content.deviceButton().loadDocument ("aluminium-200x120");
    refreshUntil (content, [&] { return content.statusLine().text().contains ("8 ceramics"); });
    processor->parameters().setValues ({ { "finger1_level", 100 } });
    REQUIRE (processor->setBusesLayout (touchLayout (2, 8)));
    refreshUntil (content,
                  [&] { return content.statusLine().text().startsWith ("Loud: noise at these levels needs "); });
    processor->parameters().arm() = false;
    content.refresh (0);
    CHECK (content.statusLine().text() == "Disarmed: all voltages are 0 V.");
}

TEST_CASE ("The touch editor shows what tracks the device, and undoes a reset", "[touch-plugin][editor][following]")
{
    const auto processor = offlineTouch (8, 48000, 480);
    auto& following = processor->session().following();
    TouchEditor editor (*processor);
    auto& content = editor.content();
    auto& panel = content.driftPanel();
    CHECK_FALSE (panel.isVisible());
    content.driftButton().setToggleState (true, juce::sendNotificationSync);
    content.driftButton().onClick();
    CHECK (panel.isVisible());
    refreshUntil (content, [&] { return panel.ceramicChoice().getNumItems() == 8; });
    panel.sensorChoice().setSelectedId (static_cast<int> (FollowingSensor::ceramicCurrent) + 1,
                                        juce::sendNotificationSync);
    panel.ceramicChoice().setSelectedId (3, juce::sendNotificationSync);
    CHECK (following.settings().sensor == FollowingSensor::ceramicCurrent);
    CHECK (following.settings().ceramic == 2);
    refreshUntil (content, [&] { return panel.words().startsWith ("Waiting: "); });
    KnownDrift drift;
    const auto model = processor->session().snapshot()->model;
    const auto followed = followedModes (*model, 48000);
    drift.nominal = followed.angularFrequencies;
    drift.layout = driftLayout (followed, 1);
    drift.sensed = startOfFollowing (drift.layout, {});
    const auto known = std::make_shared<const KnownDrift> (drift);
    following.setDrift (known);
    refreshUntil (content, [&] { return following.drift() == known; });
    panel.resetButton().onClick();
    CHECK (panel.undoButton().isVisible());
    refreshUntil (content, [&] { return following.drift() == nullptr; });
    panel.undoButton().onClick();
    CHECK_FALSE (panel.undoButton().isVisible());
    refreshUntil (content, [&] { return following.drift() == known; });
}
