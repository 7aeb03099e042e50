#pragma once

#include "EditorContent.h"

namespace antinode
{
/** The plug-in's window: the content, larger or smaller, and the clock that refreshes it. [message thread] */
class Editor : public juce::AudioProcessorEditor, private juce::Timer
{
public:
    explicit Editor (AntinodeProcessor&);
    ~Editor() override;

    EditorContent& content() { return shown; }

    void resized() override;

private:
    void timerCallback() override;

    EditorContent shown;
    double lastTime = 0; ///< ms
};
} // namespace antinode
