#include <Standalone/MainWindow.h>

#include "Support/EditorTools.h"
#include "Support/TemporaryFolder.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/Library.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace antinode;
using test::forEachShown;

namespace
{
/** The whole of what may be clicked lies in the window, or in a list that can be scrolled. */
void checkReachable (MainComponent& window)
{
    forEachShown (window,
                  [&window] (juce::Component& shown)
                  {
                      if (dynamic_cast<juce::Button*> (&shown) == nullptr
                          && dynamic_cast<juce::ComboBox*> (&shown) == nullptr)
                          return;

                      if (shown.findParentComponentOfClass<juce::Viewport>() != nullptr
                          || shown.findParentComponentOfClass<juce::ScrollBar>() != nullptr)
                          return;

                      const auto area = window.getLocalArea (&shown, shown.getLocalBounds());
                      INFO (shown.getTitle() << shown.getName() << ": " << area.toString());
                      CHECK (window.getLocalBounds().expanded (1).contains (area));
                      CHECK (area.getWidth() > 0);
                      CHECK (area.getHeight() > 0);
                  });
}

juce::Component& buttonNamed (MainComponent& window, const juce::String& text)
{
    juce::Component* found = nullptr;
    forEachShown (window,
                  [&] (juce::Component& shown)
                  {
                      if (auto* const button = dynamic_cast<juce::TextButton*> (&shown))
                          if (button->getButtonText() == text)
                              found = button;
                  });
    REQUIRE (found != nullptr);
    return *found;
}

bool says (const StatusLine& status, Urgency urgency, const std::string& words)
{
    const auto& messages = status.messages();
    return std::any_of (messages.begin(), messages.end(),
                        [&] (const auto& message)
                        { return message.urgency == urgency && message.text.find (words) != std::string::npos; });
}
} // namespace

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

TEST_CASE ("All of the window is reachable at 1000 x 700, with the settings open or not")
{
    StandaloneHost foci (SettingsFile ({}), false);
    TouchHost fingers (SettingsFile ({}), false);
    MainComponent ofFoci (foci), ofFingers (fingers);

    for (auto* const window : { &ofFoci, &ofFingers })
        for (const auto hasSettings : { true, false })
            for (const auto& [width, height] : { std::pair (1000, 700), { 1098, 700 }, { 1280, 800 }, { 3840, 2160 } })
            {
                window->setSettingsVisible (hasSettings);
                window->setSize (width, height);
                INFO (width << " x " << height << (hasSettings ? " with settings" : ""));
                checkReachable (*window);

                for (const auto* const tab : { "Audio device", "Routing", "Touch", "Bench", "Window" })
                {
                    window->showSettings (tab);
                    checkReachable (*window);
                }
            }

    ofFoci.setSize (1098, 700);
    ofFoci.setSettingsVisible (true);

    for (const auto* const tab : { "Methods", "Bank", "Voltages", "Drift" })
        CHECK (buttonNamed (ofFoci, tab).getWidth() > 0);
}

TEST_CASE ("All of the window grows with it, and by a scale that is kept")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "standalone.json";
    const auto widthOf = [] (MainComponent& window, const char* text)
    {
        auto& button = buttonNamed (window, text);
        return window.getLocalArea (&button, button.getLocalBounds()).getWidth();
    };
    {
        StandaloneHost host (SettingsFile (path), true);
        MainComponent window (host);
        window.setSize (1500, 852);
        const auto mute = widthOf (window, "MUTE ALL"), settings = widthOf (window, "Settings"),
                   fire = widthOf (window, "FIRE");
        window.setSize (3840, 2160);
        CHECK (widthOf (window, "MUTE ALL") >= 1.7 * mute);
        CHECK (widthOf (window, "Settings") >= 1.7 * settings);
        CHECK (widthOf (window, "FIRE") >= 1.7 * fire);
        host.setScale (1);
        window.setSize (3841, 2160);
        CHECK (widthOf (window, "MUTE ALL") == mute);
        host.setScale (1.5);
    }
    StandaloneHost host (SettingsFile (path), true);
    CHECK (host.settings().scale == 1.5);
    MainComponent window (host);
    window.setSize (3840, 2160);
    CHECK (widthOf (window, "MUTE ALL") == Approx (1.5 * 200).margin (1));
    host.setScale (8); // As far as all stays reachable.
    window.setSize (3839, 2160);
    checkReachable (window);
}

TEST_CASE ("What nodes it runs by is a setting with a hint, not a button beside the theme")
{
    StandaloneHost host (SettingsFile ({}), false);
    MainComponent window (host);
    window.showSettings ("Window");
    juce::ToggleButton* separate = nullptr;
    forEachShown (window,
                  [&] (juce::Component& shown)
                  {
                      if (auto* const button = dynamic_cast<juce::TextButton*> (&shown))
                          CHECK (button->getButtonText() != "Open");

                      if (auto* const button = dynamic_cast<juce::ToggleButton*> (&shown))
                          if (button->getButtonText().contains ("nodes"))
                              separate = button;
                  });
    REQUIRE (separate != nullptr);
    CHECK (separate->getTooltip().contains ("custom nodes"));
    separate->setToggleState (true, juce::sendNotificationSync);
    CHECK (host.processor().session().isGraphOpen());
}

TEST_CASE ("Messages of all sources stand in one list, and each goes when its cause is over")
{
    StandaloneHost foci (SettingsFile ({}), false);
    TouchHost fingers (SettingsFile ({}), false);
    MainComponent ofFoci (foci), ofFingers (fingers);
    const auto refresh = [&]
    {
        ofFoci.fociEditor()->content().refresh (0);
        ofFingers.touchEditor()->content().refresh (0);
    };

    for (auto* const host : std::initializer_list<AudioHost*> { &foci, &fingers })
    {
        const auto& status = host == &foci ? ofFoci.fociEditor()->content().statusLine()
                                           : ofFingers.touchEditor()->content().statusLine();
        const auto fail = [] (const char* where) { throw InputError (where, "fails"); };
        refresh();
        CHECK (says (status, Urgency::warning, "No audio device is open."));
        CHECK_FALSE (host->attempt (MessageSource::audio, [&] { fail ("audio"); }));
        CHECK_FALSE (host->attempt (MessageSource::ports, [&] { fail ("port 9000"); }));
        CHECK_FALSE (host->attempt (MessageSource::saving, [&] { fail ("saving"); }));
        host->muteAll();
        refresh();

        for (const auto* const text : { "audio: fails", "port 9000: fails", "saving: fails" })
            CHECK (says (status, Urgency::warning, text));

        CHECK (says (status, Urgency::caution, "All outputs are muted"));
        CHECK (status.urgency() == Urgency::warning);
        CHECK (host->attempt (MessageSource::ports, [] {}));
        host->router().release();
        refresh();
        CHECK_FALSE (says (status, Urgency::warning, "port 9000"));
        CHECK_FALSE (says (status, Urgency::caution, "All outputs are muted"));
        CHECK (says (status, Urgency::warning, "audio: fails"));
        CHECK (host->attempt (MessageSource::audio, [] {}));
        CHECK (host->attempt (MessageSource::saving, [] {}));
        refresh();
        CHECK_FALSE (says (status, Urgency::warning, "fails"));
    }
}

TEST_CASE ("On a beam nothing is set along y")
{
    StandaloneHost host (SettingsFile ({}), false);
    MainComponent window (host);
    host.processor().session().waitUntilSettled();
    auto& content = window.fociEditor()->content();
    content.refresh (0);
    const auto check = [&] (bool isEnabled)
    {
        for (const auto& control : content.parameterPanel().controls())
            if (const auto name = control->control().getComponentID(); name == "y" || name == "probe_y")
                CHECK (control->isEnabled() == isEnabled);
            else
                CHECK (control->isEnabled());
    };
    check (false);
    host.processor().load (std::make_shared<const DeviceDocument> (readDeviceDocument (
                               loadDocument (LibraryKind::device, "aluminium-200x120"), "aluminium")),
                           nullptr);
    host.processor().session().waitUntilSettled();
    content.refresh (0);
    check (true);
}

TEST_CASE ("Selected text is as legible as other text")
{
    for (const auto* const palette : { &Palette::dark(), &Palette::light() })
    {
        EditorLook look;
        look.setPalette (*palette);
        const auto shade = palette->raised.overlaidWith (look.findColour (juce::TextEditor::highlightColourId));
        const auto contrast =
            std::abs (look.findColour (juce::TextEditor::highlightedTextColourId).getPerceivedBrightness()
                      - shade.getPerceivedBrightness());
        CHECK (contrast > 0.35F);
    }
}

TEST_CASE ("The routing of another device begins with its own levels")
{
    StandaloneHost host (SettingsFile ({}), false);
    MainComponent window (host);
    host.processor().session().waitUntilSettled();
    juce::BigInteger outputs;
    outputs.setRange (0, 8, true);
    host.callback().prepare (48000, 256, outputs, {});
    host.processor().session().waitUntilSettled();
    host.arm().setValueNotifyingHost (1);
    window.update();
    std::array<std::array<float, 256>, 8> samples {};
    std::array<float*, 8> channels {};

    for (std::size_t i = 0; i < channels.size(); ++i)
        channels[i] = samples[i].data();

    host.processor().session().fire (1);

    for (int block = 0; block < 20; ++block)
        host.callback().audioDeviceIOCallbackWithContext (nullptr, 0, channels.data(), 8, 256, {});

    REQUIRE (host.takePeakVolts() > 0);
    host.processor().load (std::make_shared<const DeviceDocument> (
                               readDeviceDocument (loadDocument (LibraryKind::device, "beam"), "beam")),
                           nullptr);
    host.processor().session().waitUntilSettled();
    window.update();

    for (int output = 0; output < 8; ++output)
        CHECK (host.router().meters().takePeak (output) == 0);
}
