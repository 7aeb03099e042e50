#include "EditorFixture.h"

#include <antinode_session/KnownDrift.h>
#include <antinode_session/TrackingWords.h>

#include <Editor/DriftChart.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
void choose (juce::ComboBox& box, int identifier)
{
    box.setSelectedId (identifier, juce::sendNotificationSync);
}

/** The identifiers of the panel's sensors. */
constexpr int velocityAtPlace = 2, currentOfCeramic = 4;
} // namespace

TEST_CASE ("A sensor is chosen in the panel, kept in the state, and undone", "[editor][tracking]")
{
    EditorFixture test;
    test.settle();
    auto& panel = test.content().driftPanel();
    auto& history = test.content().history();
    auto& session = test.processor.session();
    CHECK (panel.words() == "No sensor is chosen.");
    choose (panel.sensorChoice(), currentOfCeramic);
    choose (panel.ceramicChoice(), 8);
    CHECK (session.tracking().settings().sensor == TrackingSensor::ceramicCurrent);
    CHECK (session.tracking().settings().ceramic == 7);
    CHECK (readState (test.stateText()).tracking == session.tracking().settings());
    panel.freezeButton().setToggleState (true, juce::sendNotificationSync);
    CHECK (session.tracking().settings().isFrozen);
    history.undo();
    CHECK_FALSE (session.tracking().settings().isFrozen);
    history.undo();
    history.undo();
    CHECK_FALSE (session.tracking().settings().isOn());
    history.redo();
    CHECK (session.tracking().settings().sensor == TrackingSensor::ceramicCurrent);
    test.waitUntil ([&] { return panel.sensorChoice().getSelectedId() == currentOfCeramic; });
}

TEST_CASE ("A sensor outside the surface is said, and not taken", "[editor][tracking]")
{
    EditorFixture test;
    test.settle();
    auto& panel = test.content().driftPanel();
    choose (panel.sensorChoice(), velocityAtPlace);
    panel.place (0).setText ("24", juce::sendNotificationSync);
    CHECK (test.processor.session().tracking().settings().xMillimetres == 24);
    panel.place (0).setText ("90", juce::sendNotificationSync);
    CHECK (panel.words() == "x is outside the surface; allowed: -75 to 75 mm");
    CHECK (test.processor.session().tracking().settings().xMillimetres == 24);
}

TEST_CASE ("A drift that is reset comes back with undo", "[editor][tracking]")
{
    EditorFixture test;
    test.settle();
    auto& session = test.processor.session();
    auto& panel = test.content().driftPanel();
    choose (panel.sensorChoice(), currentOfCeramic);
    KnownDrift known;
    known.nominal = session.snapshot()->model->angularFrequencies;
    known.layout = driftLayout (*session.snapshot()->model, 1);
    known.tracked = startOfTracking (known.layout, {});
    session.tracking().setDrift (std::make_shared<const KnownDrift> (known));
    test.waitUntil ([&] { return session.tracking().drift() != nullptr; });
    panel.resetButton().onClick();
    test.waitUntil ([&] { return session.tracking().drift() == nullptr; });
    test.content().history().undo();
    test.waitUntil ([&] { return session.tracking().drift() != nullptr; });
    test.content().history().redo();
    test.waitUntil ([&] { return session.tracking().drift() == nullptr; });
}

TEST_CASE ("A drift in words and as a chart", "[editor][tracking]")
{
    TrackingStatus status;
    status.state = TrackingState::following;
    status.delay = 0.00531;
    status.trace = { { 1, TrackingState::following, 0.0042, 1.2e-5, 0.02 },
                     { 2, TrackingState::lost, 0.0042, 1.2e-5, 0.5 },
                     { 3, TrackingState::following, 0.0044, 1e-5, 0.02 } };
    CHECK (trackingSentence (status) == "Following: +0.44 % (+-10 ppm), 5.31 ms after the voltages.");
    const auto chart = driftChart (status);
    CHECK (chart.series.front().y[0] == Approx (0.42));
    CHECK (std::isnan (chart.series.front().y[1]));
    CHECK (chart.series[1].y[2] == Approx (0.442));
    status.state = TrackingState::lost;
    status.reason = "The sensor's signal is clipped.";
    CHECK (trackingSentence (status) == "Lost: The sensor's signal is clipped.");
}
