#include "EditorFixture.h"
#include "Support/TemporaryFolder.h"

#include <Editor/ContentEditor.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

using namespace antinode;

namespace
{
/** The user's settings in a folder of the test's own. */
struct OwnSettings
{
    OwnSettings() { setenv ("XDG_CONFIG_HOME", folder.path().c_str(), 1); }
    ~OwnSettings() { unsetenv ("XDG_CONFIG_HOME"); }

    TemporaryFolder folder;
};

bool opensDark (AntinodeProcessor& processor)
{
    const std::unique_ptr<juce::AudioProcessorEditor> editor (processor.createEditorIfNeeded());
    const auto isDark = dynamic_cast<Editor&> (*editor).content().isDark();
    processor.editorBeingDeleted (editor.get());
    return isDark;
}
} // namespace

TEST_CASE ("A plug-in's editor opens as dark or light as the last one was left")
{
    const OwnSettings settings;
    installEditor();
    AntinodeProcessor one (8, juce::AudioProcessor::wrapperType_Undefined),
        other (8, juce::AudioProcessor::wrapperType_Undefined);
    CHECK (opensDark (one));
    CHECK (std::filesystem::is_empty (settings.folder.path())); // Nothing was chosen.

    for (const auto isDark : { false, true })
    {
        const auto before = stateToText (one.state());
        {
            const std::unique_ptr<juce::AudioProcessorEditor> editor (one.createEditorIfNeeded());
            dynamic_cast<Editor&> (*editor).content().setDark (isDark);
            one.editorBeingDeleted (editor.get());
        }
        CHECK (opensDark (other) == isDark);
        CHECK (stateToText (one.state()) == before);
    }
}

TEST_CASE ("Preferences that cannot be read or written are the usual ones")
{
    const OwnSettings settings;
    const auto file = settings.folder.path() / "antinode" / "editor.json";
    keepPreferences ({ false });
    CHECK_FALSE (readPreferences().isDark);
    std::ofstream (file) << "{";
    CHECK (readPreferences().isDark);
    std::filesystem::remove_all (file.parent_path());
    std::ofstream (file.parent_path()) << "no folder";
    CHECK_NOTHROW (keepPreferences ({ false }));
    CHECK (readPreferences().isDark);
}
