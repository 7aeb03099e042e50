#include "EditorFixture.h"

#include <antinode_session/KnownDrift.h>
#include <antinode_session/UserMessages.h>

#include <Editor/DriftPanel.h>

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

TEST_CASE ("A sensor is chosen in the panel, kept in the state, and undone", "[editor][following]")
{
    EditorFixture test;
    test.settle();
    auto& panel = test.content().driftPanel();
    auto& history = test.content().history();
    auto& session = test.processor.session();
    CHECK (panel.words() == "No sensor is chosen.");
    choose (panel.sensorChoice(), currentOfCeramic);
    choose (panel.ceramicChoice(), 8);
    CHECK (session.following().settings().sensor == FollowingSensor::ceramicCurrent);
    CHECK (session.following().settings().ceramic == 7);
    CHECK (readState (test.stateText()).following == session.following().settings());
    panel.freezeButton().setToggleState (true, juce::sendNotificationSync);
    CHECK (session.following().settings().isFrozen);
    history.undo();
    CHECK_FALSE (session.following().settings().isFrozen);
    history.undo();
    history.undo();
    CHECK_FALSE (session.following().settings().isOn());
    history.redo();
    CHECK (session.following().settings().sensor == FollowingSensor::ceramicCurrent);
    test.waitUntil ([&] { return panel.sensorChoice().getSelectedId() == currentOfCeramic; });
}

TEST_CASE ("A sensor outside the surface is said, and not taken", "[editor][following]")
{
    EditorFixture test;
    test.settle();
    auto& panel = test.content().driftPanel();
    choose (panel.sensorChoice(), velocityAtPlace);
    panel.place (0).setText ("24", juce::sendNotificationSync);
    CHECK (test.processor.session().following().settings().xMillimetres == 24);
    panel.place (0).setText ("90", juce::sendNotificationSync);
    CHECK (panel.words() == "x is outside the surface; allowed: -75 to 75 mm");
    CHECK (test.processor.session().following().settings().xMillimetres == 24);
}

TEST_CASE ("A drift that is reset comes back with undo", "[editor][following]")
{
    EditorFixture test;
    test.settle();
    auto& session = test.processor.session();
    auto& panel = test.content().driftPanel();
    choose (panel.sensorChoice(), currentOfCeramic);
    KnownDrift known;
    known.nominal = session.snapshot()->model->angularFrequencies;
    known.layout = driftLayout (*session.snapshot()->model, 1);
    known.sensed = startOfFollowing (known.layout, {});
    session.following().setDrift (std::make_shared<const KnownDrift> (known));
    test.waitUntil ([&] { return session.following().drift() != nullptr; });
    panel.resetButton().onClick();
    test.waitUntil ([&] { return session.following().drift() == nullptr; });
    test.content().history().undo();
    test.waitUntil ([&] { return session.following().drift() != nullptr; });
    test.content().history().redo();
    test.waitUntil ([&] { return session.following().drift() == nullptr; });
}

TEST_CASE ("A drift in words and as a chart", "[editor][following]")
{
    FollowingStatus status;
    status.state = FollowingState::following;
    status.delay = 0.00531;
    status.trace = { { 1, FollowingState::following, 0.0042, 1.2e-5, 0.02 },
                     { 2, FollowingState::lost, 0.0042, 1.2e-5, 0.5 },
                     { 3, FollowingState::following, 0.0044, 1e-5, 0.02 } };
    CHECK (followingSentence (status) == "Following: +0.44 % (+-10 ppm), 5.31 ms after the voltages.");
    const auto chart = driftChart (status);
    CHECK (chart.series.front().y[0] == Approx (0.42));
    CHECK (std::isnan (chart.series.front().y[1]));
    CHECK (chart.series[1].y[2] == Approx (0.442));
    status.state = FollowingState::lost;
    status.reason = "The sensor's signal is clipped.";
    CHECK (followingSentence (status) == "Lost: The sensor's signal is clipped.");
}
