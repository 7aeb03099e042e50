#include "EditorFixture.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/DesignFile.h>
#include <antinode_focus/DesignFocus.h>
#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <tuple>

using namespace antinode;

namespace
{
/** The user's library in a folder of the test's own. */
struct OwnLibrary
{
    OwnLibrary() { setenv ("XDG_DATA_HOME", folder.path().c_str(), 1); }
    ~OwnLibrary() { unsetenv ("XDG_DATA_HOME"); }

    TemporaryFolder folder;
};

bool isOwn (LibraryKind kind, const std::string& name)
{
    const auto entries = libraryEntries (kind);
    return std::any_of (entries.begin(), entries.end(),
                        [&] (const auto& entry) { return ! entry.isFactory && entry.name == name; });
}
} // namespace

TEST_CASE ("A focus as the parameters changed it is kept, loaded and deleted")
{
    const OwnLibrary library;
    EditorFixture test;
    test.settle();
    auto& content = test.content();
    auto& browser = content.presetPanel();
    auto& width = *test.processor.parameters().find ("width");
    width.setValueNotifyingHost (width.convertTo0to1 (33));
    content.browse (LibraryKind::focus);
    CHECK (browser.isVisible());
    browser.saveAs ("my bump");
    CHECK (browser.message() == "Saved my bump.");
    CHECK (isOwn (LibraryKind::focus, "my bump"));
    browser.select ("demonstrator");
    browser.loadSelected();
    CHECK (width.convertFrom0to1 (width.getValue()) == Approx (25));
    browser.select ("my bump");
    browser.loadSelected();
    CHECK (width.convertFrom0to1 (width.getValue()) == Approx (33).epsilon (1e-5));
    CHECK (test.processor.focus()->description.name == "my bump");
    browser.removeSelected();
    CHECK_FALSE (isOwn (LibraryKind::focus, "my bump"));
    CHECK (content.keyPressed (juce::KeyPress (juce::KeyPress::escapeKey)));
    CHECK_FALSE (browser.isVisible());
}

TEST_CASE ("What was saved under another name is what is loaded from then on, with all as it was")
{
    const OwnLibrary library;
    EditorFixture test;
    test.settle();
    test.processor.setMutes (5);
    test.processor.parameters().arm().setValueNotifyingHost (1);
    auto& width = *test.processor.parameters().find ("width");
    width.setValueNotifyingHost (width.convertTo0to1 (33));
    const auto parameters = test.processor.state().parameters;
    auto& browser = test.content().presetPanel();

    for (const auto& [kind, name, title] : { std::tuple { LibraryKind::focus, "my bump", "Focus: my bump" },
                                             std::tuple { LibraryKind::device, "my staple", "Device: my staple" } })
    {
        test.content().browse (kind);
        browser.saveAs (name);
        test.settle();
        auto isShown = false;
        test::forEachShown (test.content(),
                            [&isShown, title = title] (juce::Component& shown) // clang 14 captures no binding
                            { isShown = isShown || shown.getTitle() == title; });
        CHECK (isShown);
    }

    CHECK (test.processor.state().parameters == parameters);
    CHECK (test.processor.mutes() == 5);
    test.content().history().undo();
    test.content().history().undo();
    CHECK (test.processor.focus()->description.name == "demonstrator");
    CHECK (test.processor.device()->description.name == "staple");
    CHECK (test.processor.state().parameters == parameters);
}

TEST_CASE ("Loading a device is undone with all that it changed")
{
    const OwnLibrary library;
    EditorFixture test;
    test.settle();
    test.processor.setMutes (5);
    auto& browser = test.content().presetPanel();
    const auto before = test.stateText();
    test.content().browse (LibraryKind::device);
    browser.select ("beam");
    browser.loadSelected();
    CHECK (test.processor.device()->description.name == "beam");
    CHECK (test.processor.mutes() == 0);
    test.settle();
    test.content().history().undo();
    CHECK (test.stateText() == before);
    test.settle();
}

TEST_CASE ("A device that is loaded gets a focus of its own, which undo takes back and redo brings again")
{
    const OwnLibrary library;
    EditorFixture test;
    test.processor.parameters().find ("notes")->setValueNotifyingHost (1); // no designs for unused notes
    test.settle();
    const auto before = test.stateText();
    test.content().browse (LibraryKind::device);
    test.content().presetPanel().select ("glass-148x210");
    test.content().presetPanel().loadSelected();
    CHECK_FALSE (test.content().presetPanel().isVisible()); // It would cover the surface.
    test.waitUntil ([&] { return test.processor.focus()->description.name == "suited"; });
    test.settle();
    const auto suited = test.stateText();
    const auto target = test.processor.session().snapshot()->focus.targets.front();
    CHECK (1000 * target.x == Approx (105).margin (1));
    CHECK (1000 * target.y == Approx (74).margin (1));
    CHECK_FALSE (test.processor.focus()->description.modes.count);
    test.content().refresh (0);

    // The fixture has too few channels; of the focus there is nothing to say.
    for (const auto& message : test.content().statusLine().messages())
        CHECK (message.urgency != Urgency::caution);

    test.content().history().undo();
    CHECK (test.stateText() == before);
    test.settle();
    test.content().history().redo();
    CHECK (test.stateText() == suited);
    test.settle();

    // The same device again keeps its focus.
    auto& width = *test.processor.parameters().find ("width");
    width.setValueNotifyingHost (width.convertTo0to1 (33));
    const auto changed = test.processor.focus();
    test.processor.load (test.processor.device(), nullptr);
    test.settle();
    CHECK (test.processor.focus()->text == changed->text);
}

TEST_CASE ("What is the factory's is neither replaced nor deleted")
{
    const OwnLibrary library;
    EditorFixture test;
    auto& browser = test.content().presetPanel();
    browser.open (LibraryKind::device);
    browser.saveAs ("staple");
    CHECK (browser.message().contains ("factory"));
    browser.saveAs ("../outside");
    CHECK (browser.message().contains ("is not valid"));
    browser.select ("staple");
    browser.removeSelected();
    CHECK (browser.message().contains ("is not a user preset"));
}

TEST_CASE ("A design.json that is dropped on the window plays as it was written, others change nothing")
{
    const OwnLibrary library;
    EditorFixture test;
    test.settle();
    auto& content = test.content();
    const auto model = test.processor.session().snapshot()->model;
    auto focus = test.processor.focus()->description;
    focus.name = "written before";
    focus.targets.front().x = -0.02;
    auto json = designToJson (designFocus (*model, focus, { Reconstruction::bandLimited, 48000 }), *model);
    const juce::File folder (juce::String (library.folder.path().string()));
    const auto drop = [&] (const juce::String& name, const juce::String& text)
    {
        const auto file = folder.getChildFile (name);
        REQUIRE (file.replaceWithText (text));
        const juce::StringArray files { file.getFullPathName() };
        const auto isTaken = content.isInterestedInFileDrag (files);

        if (isTaken)
            content.filesDropped (files, 0, 0);

        test.settle();
        return isTaken;
    };
    const auto before = test.stateText();
    CHECK_FALSE (drop ("sound.wav", "RIFF"));
    CHECK (drop ("broken.json", "{"));
    CHECK (content.statusLine().getDescription().contains ("broken.json"));
    json["device"] = "beam";
    CHECK (drop ("other.json", json.dump()));
    CHECK (content.statusLine().getDescription().contains ("is for the device 'beam'"));
    CHECK (test.stateText() == before);
    json["device"] = "staple";
    CHECK (drop ("design.json", json.dump()));
    CHECK (test.processor.focus()->description.name == "written before");
    CHECK (content.statusLine().getDescription().startsWith ("Ready; every note plays the design"));
    auto& browser = content.presetPanel();
    browser.open (LibraryKind::focus);
    browser.saveAs ("copy");
    CHECK (browser.message().contains ("is a written design"));
    const auto written = test.stateText();
    content.history().undo();
    CHECK (test.stateText() == before);
    content.history().redo();
    CHECK (test.stateText() == written);
    test.settle();
}

TEST_CASE ("A broken file gives one sentence and changes nothing")
{
    const OwnLibrary library;
    EditorFixture test;
    test.settle();
    const auto before = test.stateText();
    auto& browser = test.content().presetPanel();
    const juce::File folder (juce::String (library.folder.path().string()));

    for (const auto* const text : { "", "{", "[]", "{\"schema\": \"antinode.focus/1\", \"targets\": 7}" })
    {
        const auto file = folder.getChildFile ("broken.json");
        REQUIRE (file.replaceWithText (text));
        browser.open (LibraryKind::focus);
        browser.loadFile (file);
        INFO (browser.message());
        CHECK (browser.message().contains ("broken.json"));
        CHECK_FALSE (browser.message().containsChar ('\n'));
        CHECK (test.stateText() == before);
        CHECK_FALSE (test.content().history().canUndo());
    }
}
