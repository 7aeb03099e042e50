#pragma once

#include "History.h"
#include "ParameterLink.h"

#include <antinode_library/Library.h>

#include <functional>
#include <memory>

namespace antinode
{
/** The loaded presets, undo and redo, the theme, and the three buttons that control the voltage on the ceramics.
    [message thread] */
class TopBar final : public juce::Component
{
public:
    TopBar (AntinodeProcessor&, History&);

    std::function<void (LibraryKind)> onBrowse;
    std::function<void()> onFire, onStop, onTheme, onUndo, onRedo;

    /** @param device, focus  the names of what is loaded */
    void refresh (const juce::String& device, const juce::String& focus);

    void paint (juce::Graphics&) override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    /** A caption over the name of what is loaded. */
    class NameButton : public juce::Button
    {
    public:
        explicit NameButton (const juce::String& caption);
        void setLoaded (const juce::String& name);
        void paintButton (juce::Graphics&, bool isOver, bool isDown) override;

    private:
        juce::String caption, loaded;
    };

    void showArm (bool isArmed);

    History& history;
    NameButton device { "Device" }, focus { "Focus" };
    juce::TextButton undo, redo, theme, arm { "Disarmed" }, fire { "FIRE" }, stop { "STOP" };
    ParameterLink armLink;
};
} // namespace antinode
