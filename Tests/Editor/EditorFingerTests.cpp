#include "EditorFixture.h"

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
void drag (FocusSurface& surface, juce::Point<float> from, juce::Point<float> to)
{
    surface.mouseDown (mouseAt (surface, from, from));
    surface.mouseDrag (mouseAt (surface, (from + to) / 2, from));
    surface.mouseDrag (mouseAt (surface, to, from));
    surface.mouseUp (mouseAt (surface, to, from));
}

void choose (FocusSurface& surface, juce::Point<float> place, const juce::String& item)
{
    const auto menu = surface.fingerMenu (place);

    for (juce::PopupMenu::MenuItemIterator each (menu); each.next();)
        if (each.getItem().text == item)
            return each.getItem().action();

    FAIL ("no such item: " << item);
}

const std::vector<Finger>& fingersOf (EditorFixture& test)
{
    return test.processor.focus()->description.fingers;
}
} // namespace

TEST_CASE ("A finger is rested, dragged and lifted on the surface, each one step of undo")
{
    EditorFixture test;
    test.snapshot (1280, 800);
    auto& surface = test.content().surface();
    const auto bare = test.content().history().canUndo();
    const auto place = surface.spot() + juce::Point<float> (-60, 0);
    choose (surface, place, "Firm");
    REQUIRE (fingersOf (test).size() == 1);
    CHECK (fingersOf (test).front().name == "firm");
    CHECK_FALSE (bare);
    const auto x = fingersOf (test).front().x;
    test.settle();
    const juce::Point<float> onFinger (place.x, surface.probe().y);
    drag (surface, onFinger, onFinger + juce::Point<float> (-80, 0));
    REQUIRE (fingersOf (test).size() == 1);
    CHECK (fingersOf (test).front().x < x);
    choose (surface, onFinger + juce::Point<float> (-80, 0), "Known to the design");
    CHECK_FALSE (fingersOf (test).front().isKnown);
    drag (surface, onFinger + juce::Point<float> (-80, 0), { -500, -500 });
    CHECK (fingersOf (test).empty());

    for (int i = 0; i < 3; ++i)
        test.content().history().undo();

    REQUIRE (fingersOf (test).size() == 1);
    CHECK (fingersOf (test).front().x == x);
    CHECK (fingersOf (test).front().isKnown);
    test.content().history().undo();
    CHECK (fingersOf (test).empty());
    CHECK_FALSE (test.content().history().canUndo());
}

TEST_CASE ("A finger changes the field and what is felt, but no parameter")
{
    EditorFixture test;
    test.processor.parameters().find ("peak_velocity")->setValueNotifyingHost (0.3f);
    const auto value = test.processor.parameters().find ("peak_velocity")->getValue();
    test.snapshot (1280, 800);
    auto& surface = test.content().surface();
    const auto& focus = test.processor.focus()->description.targets.front();
    surface.fingers().rest ("firm", focus.x, focus.y);
    surface.fingers().setKnown (0, false);
    test.settle();
    CHECK (test.processor.parameters().find ("peak_velocity")->getValue() == value);
    CHECK (test.processor.focus()->description.fingers.size() == 1);
    CHECK (test.content().statusLine().text().isNotEmpty());
}

TEST_CASE ("Fingers that no surface can tell apart are refused in one sentence")
{
    EditorFixture test;
    test.snapshot (1280, 800);
    auto& surface = test.content().surface();
    CHECK (surface.keyPressed (juce::KeyPress ('n', {}, 'n')));
    CHECK (fingersOf (test).size() == 1);
    CHECK (surface.keyPressed (juce::KeyPress ('n', {}, 'n')));
    CHECK (fingersOf (test).size() == 1);
    test.content().refresh (0);
    CHECK (test.content().statusLine().text().contains ("where their contacts meet"));
    CHECK (surface.keyPressed (juce::KeyPress (juce::KeyPress::deleteKey)));
    CHECK (fingersOf (test).empty());
    CHECK_FALSE (surface.keyPressed (juce::KeyPress (juce::KeyPress::deleteKey)));
}

TEST_CASE ("What touches put down is in no step of undo and no preset, until it is edited")
{
    EditorFixture test;
    test.snapshot (1280, 800);
    auto& fingers = test.content().surface().fingers();
    auto touch = builtInFinger ("light", -0.05, 0);
    touch.isKnown = false;
    test.processor.setTouches ({ touch });
    test.content().refresh (0);
    REQUIRE (fingers.all().size() == 1);
    fingers.rest ("firm", 0.03, 0);
    CHECK (fingersOf (test).size() == 2);
    CHECK (test.processor.touches().size() == 1);
    CHECK (test.processor.state().focus->description.fingers.size() == 1);

    // It leaves while the other one is dragged.
    fingers.drag (0, 0.04, 0);
    test.processor.setTouches ({});
    fingers.drop();
    REQUIRE (fingersOf (test).size() == 1);
    CHECK (fingersOf (test).front().x == Approx (0.04));
    test.content().history().undo();
    REQUIRE (fingersOf (test).size() == 1);
    CHECK (fingersOf (test).front().x == Approx (0.03));
    test.content().history().undo();
    CHECK (fingersOf (test).empty());

    test.processor.setTouches ({ touch });
    test.content().refresh (0);
    fingers.setKnown (0, true);
    CHECK (test.processor.touches().empty());
    CHECK (test.processor.state().focus->description.fingers.size() == 1);
}
