#include <Standalone/MainComponent.h>

#include "Support/TemporaryFolder.h"

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("F12 mutes all outputs until they are released, Escape mutes nothing")
{
    StandaloneHost host (SettingsFile ({}), false);
    MainComponent window (host);
    CHECK (window.keyPressed (juce::KeyPress (juce::KeyPress::escapeKey)));
    CHECK_FALSE (host.router().isMuted());
    CHECK (window.keyPressed (juce::KeyPress (juce::KeyPress::F12Key)));
    CHECK (host.router().isMuted());
    CHECK_FALSE (window.fociEditor()->content().keyPressed (juce::KeyPress (juce::KeyPress::F12Key)));
}

TEST_CASE ("the settings have the same theme as the editor")
{
    StandaloneHost host (SettingsFile ({}), false);
    MainComponent window (host);
    window.fociEditor()->content().setDark (false);
    CHECK_FALSE (EditorLook::findPalette (window).isDark);
    window.fociEditor()->content().setDark (true);
    CHECK (EditorLook::findPalette (window).isDark);
}

TEST_CASE ("the window is as dark or light as it was left")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "standalone.json";

    for (const auto isDark : { false, true })
    {
        {
            StandaloneHost host (SettingsFile (path), true);
            MainComponent window (host);
            window.fociEditor()->content().setDark (isDark);
        }
        StandaloneHost host (SettingsFile (path), true);
        const MainComponent window (host);
        CHECK (EditorLook::findPalette (window).isDark == isDark);
    }
}
