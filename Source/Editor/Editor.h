#pragma once

#include "EditorContent.h"

namespace antinode
{
/** The plug-in's window: the content, larger or smaller, and the clock that refreshes it. The clock runs only in a
   window: before, a VST3 is made, measured and perhaps freed again on the host's thread, while messages run on one of
   JUCE's own. [message thread] */
class Editor final : public juce::AudioProcessorEditor, private juce::Timer
{
public:
    explicit Editor (AntinodeProcessor&);
    ~Editor() override;

    EditorContent& content() { return shown; }

    void resized() override;
    void parentHierarchyChanged() override;

private:
    void timerCallback() override;

    EditorContent shown;
    double lastTime = 0; ///< ms
};
} // namespace antinode
