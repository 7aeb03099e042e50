#pragma once

#include "EditorLook.h"
#include "History.h"
#include "ParameterPanel.h"
#include "WindowContent.h"

#include <antinode_documents/Library.h>

#include <functional>

namespace antinode
{
/** The commands of Antinode in its bar: the loaded presets, undo and redo, and the three buttons that control the
   voltage on the ceramics. [message thread] */
class FocusCommands
{
public:
    FocusCommands (TopBar&, AntinodeProcessor&, History&);

    std::function<void (LibraryKind)> onBrowse;
    std::function<void()> onFire, onStop, onUndo, onRedo;

    /** @param device, focus  the names of what is loaded */
    void refresh (const juce::String& device, const juce::String& focus);

    void setPalette (const Palette&);

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
    juce::TextButton undo, redo, arm { "Disarmed" }, fire { "FIRE" }, stop { "STOP" };
    ParameterLink armLink;
};
} // namespace antinode
