#include "EditorFixture.h"

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
const juce::KeyPress undoKeys ('z', juce::ModifierKeys::commandModifier, 0);
const juce::KeyPress redoKeys ('z', juce::ModifierKeys::commandModifier | juce::ModifierKeys::shiftModifier, 0);

void dragBy (FocusSurface& surface, juce::Point<float> from, juce::Point<float> by)
{
    constexpr int steps = 20;
    surface.mouseDown (mouseAt (surface, from, from));

    for (int i = 1; i <= steps; ++i)
        surface.mouseDrag (mouseAt (surface, from + by * (static_cast<float> (i) / steps), from));

    surface.mouseUp (mouseAt (surface, from + by, from));
}
} // namespace

TEST_CASE ("Dragging the spot is one step of undo, and states come back to the letter")
{
    EditorFixture test;
    test.snapshot (1280, 800);
    auto& content = test.content();
    auto& surface = content.surface();
    const auto& x = *test.processor.parameters().find ("x");
    const auto before = test.stateText();
    const auto value = x.getValue();
    dragBy (surface, surface.spot(), { 40, 25 });
    const auto after = test.stateText();
    CHECK (x.getValue() > value);
    CHECK (before != after);
    CHECK (content.keyPressed (undoKeys));
    CHECK (test.stateText() == before);
    CHECK_FALSE (content.history().canUndo());
    CHECK (content.keyPressed (redoKeys));
    CHECK (test.stateText() == after);
    CHECK_FALSE (content.history().canRedo());
}

TEST_CASE ("On a plate the spot is dragged both ways, and the probe too")
{
    EditorFixture test;
    Presets presets (test.processor, test.content().history());
    REQUIRE (presets.load (LibraryKind::device, "phone-bare").isEmpty());
    REQUIRE (presets.load (LibraryKind::focus, "phone-bare-thumb").isEmpty());
    test.processor.parameters().find ("notes")->setValueNotifyingHost (1);
    test.snapshot (1280, 800);
    auto& surface = test.content().surface();
    const auto spot = surface.spot();
    // Away from the probe, which begins at the same place.
    dragBy (surface, spot + juce::Point<float> (30, 0), { 60, -20 });
    CHECK (surface.spot().getDistanceFrom (spot + juce::Point<float> (90, -20)) < 1);
    const auto probe = surface.probe();
    dragBy (surface, probe, { -35, 10 });
    CHECK (surface.probe().getDistanceFrom (probe + juce::Point<float> (-35, 10)) < 1);
    test.content().history().undo();
    CHECK (surface.probe().getDistanceFrom (probe) < 0.01);
}

TEST_CASE ("Arrow keys move the spot, and quick ones make one step of undo")
{
    EditorFixture test;
    test.settle();
    auto& content = test.content();
    const auto& x = *test.processor.parameters().find ("x");
    const auto before = test.stateText();
    const auto value = x.getValue();

    for (int i = 0; i < 5; ++i)
        CHECK (content.surface().keyPressed (juce::KeyPress (juce::KeyPress::rightKey)));

    CHECK (x.getValue() == Approx (value + 0.05f).margin (1e-6));
    content.history().undo();
    CHECK (test.stateText() == before);
    CHECK_FALSE (content.history().canUndo());
}

TEST_CASE ("Each parameter's gesture is undone to the letter")
{
    EditorFixture test;
    test.settle();
    auto& history = test.content().history();

    for (auto* const parameter : test.processor.parameters().all())
    {
        if (parameter->getParameterID() == "arm")
            continue;

        INFO (parameter->getParameterID());
        const auto before = test.stateText();
        history.closeEntry();
        parameter->beginChangeGesture();
        parameter->setValueNotifyingHost (parameter->getValue() < 0.5f ? 0.8137f : 0.1931f);
        parameter->endChangeGesture();
        const auto after = test.stateText();
        REQUIRE (before != after);
        history.undo();
        CHECK (test.stateText() == before);
        history.redo();
        CHECK (test.stateText() == after);
    }
}

TEST_CASE ("What a host automates makes no step of undo and is not undone")
{
    EditorFixture test;
    test.settle();
    auto& parameters = test.processor.parameters();
    auto& history = test.content().history();
    auto& width = *parameters.find ("width");
    auto& x = *parameters.find ("x");
    width.setValueNotifyingHost (0.3f);
    CHECK_FALSE (history.canUndo());
    x.beginChangeGesture();
    x.setValueNotifyingHost (0.25f);
    width.setValueNotifyingHost (0.7f);
    x.endChangeGesture();
    history.undo();
    CHECK (width.getValue() == Approx (0.7f).margin (1e-6));
    CHECK (x.getValue() != Approx (0.25f).margin (1e-6));
}

TEST_CASE ("Undo never arms a device")
{
    EditorFixture test;
    test.settle();
    auto& arm = test.processor.parameters().arm();
    arm.beginChangeGesture();
    arm.setValueNotifyingHost (0);
    arm.endChangeGesture();
    CHECK_FALSE (test.content().history().canUndo());
    test.content().history().undo();
    CHECK_FALSE (arm.get());
}

TEST_CASE ("A click on a meter mutes its ceramic, which can be undone")
{
    EditorFixture test;
    test.settle();
    auto& strip = test.content().metersStrip();
    REQUIRE (strip.getNumChildComponents() == 8);
    auto* const third = dynamic_cast<CeramicMeter*> (strip.getChildComponent (2));
    REQUIRE (third != nullptr);
    third->setToggleState (true, juce::dontSendNotification);
    third->onClick();
    CHECK (test.processor.mutes() == 4);
    test.content().history().undo();
    CHECK (test.processor.mutes() == 0);
    test.content().refresh (0.01);
    CHECK_FALSE (third->getToggleState());
    test.content().history().redo();
    test.content().refresh (0.01);
    CHECK (third->getToggleState());
}
