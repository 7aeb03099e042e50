#pragma once

#include "WindowContent.h"

#include <antinode_base/Reflection.h>
#include <antinode_text/JsonReader.h>
#include <juce_audio_processors/juce_audio_processors.h>

#include <memory>

namespace antinode
{
/** The names of the editor's two looks in files. */
inline constexpr WordList<bool, 2> themeWords { { { "dark", true }, { "light", false } } };

/** What a scale in files may be; 0: as large as suits the window. */
inline constexpr NumberRange scaleRange { 0, 8 };

/** Preferences of the plug-in's window, the same in all hosts; not part of a host's state. */
struct EditorPreferences
{
    bool isDark = true;
    double scale = 0; ///< Of what a window shows; 0: as large as suits it.
};

/** The preferences in $XDG_CONFIG_HOME/antinode/editor.json; the defaults if there is no valid file.
   Docs/FileFormats.md [message thread] */
EditorPreferences readPreferences();

/** Keeps them; where the file cannot be written they last as long as the window. [message thread] */
void keepPreferences (const EditorPreferences&);

/** The window of a plug-in: its content, larger or smaller, and the clock that refreshes it. The clock runs only in a
   window: before, a VST3 is made, measured and perhaps freed again on the host's thread, while messages run on one of
   JUCE's own. [message thread] */
class ContentEditor : public juce::AudioProcessorEditor, private juce::Timer
{
public:
    ContentEditor (juce::AudioProcessor&, std::unique_ptr<WindowContent>);
    ~ContentEditor() override { stopTimer(); }

    WindowContent& content() const { return *shown; }

    /** @param wanted  0: as large as suits the window */
    void setContentScale (double wanted);

    void resized() override;
    void parentHierarchyChanged() override;

private:
    void timerCallback() override;

    std::unique_ptr<WindowContent> shown;
    double wantedScale = 0;
    double lastTime = 0; ///< ms
};

/** The window of a role. @tparam Content  of the role */
template <typename Content>
class RoleEditor final : public ContentEditor
{
public:
    template <typename Processor>
    explicit RoleEditor (Processor& processorToShow)
        : ContentEditor (processorToShow, std::make_unique<Content> (processorToShow))
    {
    }

    Content& content() const { return static_cast<Content&> (ContentEditor::content()); }
};

/** Makes a window as dark or light, and as large, as the last one was left; how it is left is kept. [message thread] */
void showAsLeft (ContentEditor&);

/** Such a window. [message thread] */
template <typename Content, typename Processor>
std::unique_ptr<RoleEditor<Content>> editorAsLeft (Processor& processor)
{
    auto editor = std::make_unique<RoleEditor<Content>> (processor);
    showAsLeft (*editor);
    return editor;
}
} // namespace antinode
