#include "EditorFixture.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_drafts/DeviceEdits.h>
#include <antinode_drafts/DeviceTemplates.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

#include <random>

using namespace antinode;

namespace
{
/** An editor whose device is drawn: that of a template, solved, with its focus. */
struct DrawnFixture : EditorFixture
{
    explicit DrawnFixture (const std::string& name)
    {
        processor.parameters().find ("notes")->setValueNotifyingHost (1); // no designs for unused notes
        editor->setSize (1280, 800);
        content().showPanel ("Device");
        content().devicePanel().begin (name);
        waitUntil ([this] { return processor.focus()->description.name == "suited"; });
        settle();
        paint(); // Lays the surface out.
    }

    void paint() { editor->createComponentSnapshot (editor->getLocalBounds(), true, 1); }
    DeviceDraft& draft() { return content().deviceDraft(); }
    DeviceSurface& surface() { return content().deviceSurface(); }

    template <typename Row, typename Value>
    void enter (const juce::String& name, Value value)
    {
        content().refresh (0);
        auto* const row = content().devicePanel().find<Row> (name);
        INFO (name);
        REQUIRE (row != nullptr);
        row->enter (value);
    }

    nlohmann::json device() const { return nlohmann::json::parse (processor.device()->text); }
};

/** One of the edits that the window has, at random. */
nlohmann::json editedAtRandom (const nlohmann::json& device, std::mt19937& random)
{
    const auto number = [&random] (double from, double to)
    { return tidy (std::uniform_real_distribution (from, to) (random)); };
    const auto index = [&random] (std::size_t count)
    { return std::uniform_int_distribution<std::size_t> (0, count - 1) (random); };
    const auto ceramics = ceramicsOf (device);
    const auto points = pointsOf (device);
    const CeramicChoice one = ceramics.empty() ? CeramicChoice() : CeramicChoice { index (ceramics.size()) };
    const auto which = index (14);

    if (which == 0)
        return withSize (device, { number (100, 300), number (80, 200) });

    if (which == 1)
        return withLayers (device, { { "glass", number (0.5, 3) } });

    if (which == 2)
        return withLayers (device, { { "glass", 0.7 }, { "OCA", number (0.1, 0.3) }, { "aluminium", 1 } });

    if (which == 3)
        return withSupport (device, index (2) == 0 ? "" : "left", supportJson (usualSupports()[index (3)]));

    if (which == 4)
        return withQualityFactor (device, number (10, 100));

    if (which == 5)
        return withPoint (device, index (points.size() + 1),
                          { { number (10, 90), number (10, 70) }, 0, number (1, 9) });

    if (which == 6 && ! points.empty())
        return withoutPoint (device, index (points.size()));

    if (which == 7)
        return withMoreCeramic (device, { CeramicShape::disc, { number (0, 300), number (0, 200) }, { 12, 12 } }, 0);

    if (which == 8)
        return withRow (device, { CeramicShape::rectangle, { 0, 0 }, { 8, 8 } }, 0, DeviceSide::left, 2,
                        number (0, 50));

    if (one.empty())
        return device;

    auto ceramic = ceramics[*one.begin()];

    if (which == 9)
        return withMirrored (device, one, index (2) == 0);

    if (which == 10)
        return withCeramicKey (device, one, "thickness_mm", number (0.1, 1));

    if (which == 11)
    {
        ceramic.shape = static_cast<CeramicShape> (index (3));
        ceramic.size = Eigen::Vector2d::Constant (number (5, 20));
        ceramic.angle = ceramic.shape == CeramicShape::rectangle ? number (-90, 90) : 0;
        return withCeramic (device, *one.begin(), ceramic);
    }

    return withShifted (device, one, { number (-20, 20), number (-20, 20) });
}
} // namespace

TEST_CASE ("Two thousand random edits, undone and redone, give the same states to the byte", "[draft]")
{
    DrawnFixture test ("rectangle");
    auto& history = test.content().history();
    std::mt19937 random (7);
    std::vector<std::string> states { test.stateText() };
    std::size_t position = 0;
    std::vector<bool> isEntry;
    constexpr int steps = 2000;
    constexpr std::size_t most = 200; // entries of the history
    std::size_t reached = 0, taken = 0;

    for (int i = 0; i < steps; ++i)
    {
        const auto choice = random() % 5;
        INFO ("step " << i);

        if (choice == 0 && reached > 0)
        {
            history.undo();
            --reached;
            CHECK (test.stateText() == states[--position]);
        }
        else if (choice == 1 && position + 1 < states.size())
        {
            history.redo();
            ++reached;
            CHECK (test.stateText() == states[++position]);
        }
        else
        {
            test.draft().refresh();
            const auto count = test.device()["ceramics"].size();

            if (count > 12 || (count > 0 && random() % 20 == 0))
                test.draft().removeCeramics ({ random() % count });
            else
                test.draft().apply (editedAtRandom (test.draft().document(), random));

            auto now = test.stateText();

            // What is wrong is not taken, and makes no entry.
            if (now != states[position])
            {
                states.resize (position + 1);
                states.push_back (std::move (now));
                ++position;
                reached = std::min (reached + 1, most);
                ++taken;
            }
        }

        test.draft().refresh();
        REQUIRE (test.draft().document().dump() == test.processor.device()->text);
    }

    CHECK (taken > steps / 4);
    const auto last = position;

    for (; reached > 0; --reached)
    {
        history.undo();
        CHECK (test.stateText() == states[--position]);
    }

    while (position < last)
    {
        history.redo();
        CHECK (test.stateText() == states[++position]);
    }
}

TEST_CASE ("A ceramic follows the mouse, and what is wrong where it lies is said there and not taken", "[draft]")
{
    DrawnFixture test ("rectangle");
    auto& surface = test.surface();
    const auto before = test.stateText();
    const auto from = surface.middleOf (0), other = surface.middleOf (1);
    const auto free = from + juce::Point<float> (0, -40);

    // Onto another one.
    surface.mouseDown (test::mouseAt (surface, from));
    surface.mouseDrag (test::mouseAt (surface, other, from));
    REQUIRE (test.draft().faults().size() == 1);
    CHECK (test.draft().faults().front().sentence == "C2 overlaps C1");
    CHECK (test.draft().isEdited());
    CHECK (test.stateText() == before); // A host never keeps what is wrong.
    surface.mouseUp (test::mouseAt (surface, other, from));
    CHECK (test.stateText() == before);
    test.content().refresh (0);
    CHECK (test.content().statusLine().getDescription().contains ("C2 overlaps C1"));
    CHECK (test.draft().faults().empty());

    // Where there is room: one entry of the history for all of the drag.
    surface.mouseDown (test::mouseAt (surface, from));

    for (int i = 1; i <= 5; ++i)
    {
        surface.mouseDrag (test::mouseAt (surface, from + (free - from) * (0.2f * static_cast<float> (i)), from));
        test.content().refresh (0.02);
    }

    surface.mouseUp (test::mouseAt (surface, free, from));
    const auto place = ceramicsOf (test.device()).front().centre;
    CHECK (place.x() == Approx (16));
    CHECK (place.y() > 20);
    CHECK (place.y() == Approx (std::round (place.y()))); // on the grid
    const auto after = test.stateText();
    test.content().history().undo();
    CHECK (test.stateText() == before);
    test.content().history().redo();
    CHECK (test.stateText() == after);
    test.settle();
    CHECK (test.processor.session().snapshot()->model->ceramics.front().yMinimum == Approx ((place.y() - 6) / 1000));
}

TEST_CASE ("A slider shows coarse modes while it is dragged, and exact ones after", "[draft]")
{
    DrawnFixture test ("rectangle");
    auto& draft = test.draft();
    const auto exact = test.processor.session().snapshot()->model;
    draft.drag (withLayers (draft.document(), { { "glass", 2 } }));
    test.waitUntil (
        [&]
        {
            const auto shown = test.content().draftShown();
            return shown != nullptr && ! shown->isExact && shown->question.device == draft.device()
                   && shown->volts.has_value();
        });
    const auto coarse = test.content().draftShown();
    CHECK (coarse->model->modes() == DraftView::coarseModes);
    CHECK (coarse->captured.has_value());
    CHECK (test.processor.session().snapshot()->model == exact);
    draft.drop();
    test.waitUntil ([&] { return test.content().draftShown()->isExact && test.content().isSettled(); });
    const auto after = test.content().draftShown();
    CHECK (after->model->frequencyHz (0) == Approx (coarse->model->frequencyHz (0)).epsilon (0.05));
    CHECK (*after->captured == Approx (*coarse->captured).margin (0.03)); // of as many modes
    CHECK (after->model->frequencyHz (0) > 1.2 * exact->frequencyHz (0));
}

TEST_CASE ("From an empty window to a plate in six steps, and a file that the command line reads", "[draft]")
{
    DrawnFixture test ("rectangle"); // 1: New, rectangle
    test.enter<DraftNumber> ("Length", 180);
    test.enter<DraftNumber> ("Width", 110);
    test.enter<DraftNumber> ("Thickness", 1.1);
    test.enter<DraftChoice> ("Edge", 0);
    test.enter<DraftChoice> ("Held by", 5); // silicone
    test.enter<DraftNumber> ("Size", 15);
    const TemporaryFolder folder;
    const juce::File file (juce::String ((folder.path() / "mine.json").string()));
    test.content().devicePanel().saveTo (file);
    const auto device = readDevice (readJsonFile (file.getFullPathName().toStdString()), "mine.json");
    const auto& plate = std::get<OutlinedPlate> (device.body);
    CHECK (deviceExtent (device).xMaximum == Approx (0.18));
    CHECK (deviceExtent (device).yMaximum == Approx (0.11));
    CHECK (plate.common.thickness == Approx (1.1e-3));
    REQUIRE (plate.common.ceramics.size() == 10);
    CHECK (plate.common.ceramics.front().sizeX == Approx (0.015));

    for (const auto& edge : plate.edges)
        CHECK (edge.translation == Approx (3e6));

    test.settle();
    const auto shown = test.content().draftShown();
    REQUIRE (shown->captured);
    CHECK (*shown->captured > 0.9);
    CHECK (shown->isExact);

    // The focus lies where it did, in the middle of the free area.
    const auto target = test.processor.session().snapshot()->focus.targets.front();
    CHECK (target.x == Approx (0.09).margin (0.02));
    CHECK (target.y == Approx (0.055).margin (0.002));
}

TEST_CASE ("A drawing that is dropped is the outline, and takes off what lies outside of it", "[draft]")
{
    DrawnFixture test ("rectangle");
    const TemporaryFolder folder;
    const juce::File file (juce::String ((folder.path() / "plate.svg").string()));
    REQUIRE (file.replaceWithText (
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="100mm" viewBox="0 0 120 100"><rect width="120" height="100"/></svg>)"));
    const juce::StringArray files { file.getFullPathName() };
    REQUIRE (test.content().isInterestedInFileDrag (files));
    test.processor.setMutes (0b100010); // C2 and C6
    const auto before = test.stateText();
    test.content().filesDropped (files, 0, 0);
    CHECK (sizeOf (test.device()).isApprox (Eigen::Vector2d (120, 100), 1e-6));
    CHECK (ceramicsOf (test.device()).size() == 8); // C1 to C4, C6 to C9
    CHECK (test.processor.mutes() == 0b10010);
    CHECK (usualSupport (supportOf (test.device(), "1"))->name == "silicone");
    test.content().history().undo();
    CHECK (test.stateText() == before);
    CHECK (test.processor.mutes() == 0b100010);
}

TEST_CASE ("A device whose modes are given is not drawn, and says so by what its panel offers", "[draft]")
{
    EditorFixture test;
    test.settle();
    auto modal = nlohmann::json::parse (modalDeviceToJson (*test.processor.session().snapshot()->model, "").dump());
    test.processor.load (std::make_shared<const DeviceDocument> (readDeviceDocument (modal, "modal")), nullptr);
    test.content().showPanel ("Device");
    test.settle();
    CHECK_FALSE (test.content().deviceDraft().isDrawn());
    CHECK (test.content().devicePanel().find<DraftNumber> ("Length") == nullptr);
    test.content().devicePanel().begin ("disc");
    test.content().refresh (0);
    CHECK (test.content().devicePanel().find<DraftNumber> ("Length") != nullptr);
}

TEST_CASE ("The search of places says what the focus needs now and there, and its places are taken as one edit",
           "[draft]")
{
    DrawnFixture test ("rectangle");
    auto& draft = test.draft();
    auto& panel = test.content().devicePanel();
    draft.removeCeramics ({ 2, 3, 4, 5, 6, 7, 8, 9 });
    auto corner = draft.document();

    // Both in a corner: anything is better.
    for (std::size_t i = 0; i < 2; ++i)
    {
        auto ceramic = ceramicsOf (corner)[i];
        ceramic.centre = { 8 + 14 * static_cast<double> (i), 8 };
        corner = withCeramic (corner, i, ceramic);
    }

    draft.apply (corner);
    test.settle();
    const auto before = test.stateText();
    panel.onPlace (true);
    test.waitUntil ([&] { return ! test.content().placesFound().isRunning; });
    const auto found = test.content().placesFound();
    INFO (found.error);
    REQUIRE (found.ceramics.size() == 2);
    CHECK (found.voltsThere < 0.8 * found.voltsNow);
    CHECK (test.stateText() == before); // Nothing is taken before the user takes it.
    panel.takePlaces();
    CHECK (ceramicsOf (test.device()).front().centre.isApprox (1000 * found.ceramics.front().centre(), 1e-5));
    test.content().history().undo();
    CHECK (test.stateText() == before);

    // One that is stopped finds nothing.
    test.content().refresh (0);
    panel.onPlace (true);
    panel.onPlace (false);
    test.content().refresh (0);
    CHECK (test.content().placesFound().ceramics.empty());
}

TEST_CASE ("Edges, several ceramics and masses are chosen on the surface, and keys move and remove them", "[draft]")
{
    DrawnFixture test ("rounded rectangle");
    auto& surface = test.surface();
    auto& draft = test.draft();
    const auto first = surface.middleOf (0);
    surface.mouseDown (test::mouseAt (surface, first));
    surface.mouseUp (test::mouseAt (surface, first));
    CHECK (draft.ceramics == CeramicChoice { 0 });
    draft.ceramics = { 0, 1 };
    const auto before = ceramicsOf (test.device());
    CHECK (surface.keyPressed (juce::KeyPress (juce::KeyPress::upKey)));

    for (const auto i : { 0, 1 })
        CHECK (ceramicsOf (test.device())[i].centre.isApprox (before[i].centre + Eigen::Vector2d (0, 1)));

    // Dragged together, they keep their distance.
    test.content().refresh (0);
    surface.mouseDown (test::mouseAt (surface, surface.middleOf (0)));
    const auto from = surface.middleOf (0), to = from + juce::Point<float> (0, -30);
    surface.mouseDrag (test::mouseAt (surface, to, from));
    surface.mouseUp (test::mouseAt (surface, to, from));
    const auto after = ceramicsOf (test.device());
    CHECK ((after[1].centre - after[0].centre).isApprox (before[1].centre - before[0].centre));
    CHECK (after[0].centre.y() > before[0].centre.y() + 2);

    test.processor.setMutes (0b1001);
    CHECK (surface.keyPressed (juce::KeyPress (juce::KeyPress::deleteKey)));
    CHECK (ceramicsOf (test.device()).size() == before.size() - 2);
    CHECK (test.processor.mutes() == 0b10); // C4 is the second now

    draft.apply (withPoint (draft.document(), 0, { { 110, 60 }, 20, 0 }));
    draft.point = 0;
    test.enter<DraftNumber> ("Foot", 33);
    CHECK (pointsOf (test.device()).front().stiffness == 33);
    CHECK (surface.keyPressed (juce::KeyPress (juce::KeyPress::deleteKey)));
    CHECK (pointsOf (test.device()).empty());

    draft.edge = "left";
    test.enter<DraftChoice> ("Held by", 2);
    CHECK (usualSupport (supportOf (test.device(), "left"))->name == "clamped");
    CHECK (usualSupport (supportOf (test.device(), "right"))->name == "silicone");
    test.enter<DraftNumber> ("Thickness", 1.5);
    CHECK (layersOf (test.device()).front().thickness == Approx (1.5));
    CHECK_FALSE (surface.keyPressed (juce::KeyPress ('x')));
}
