#pragma once

#include "PlateContent.h"

namespace antinode
{
/** The window of Antinode Plate: the content, and the clock that refreshes it. As with Editor the clock runs only
    in a window. [message thread] */
class PlateEditor final : public juce::AudioProcessorEditor, private juce::Timer
{
public:
    explicit PlateEditor (PlateProcessor&);
    ~PlateEditor() override;

    PlateContent& content() { return shown; }

    void resized() override;
    void parentHierarchyChanged() override;

private:
    void timerCallback() override;

    PlateContent shown;
    double lastTime = 0; ///< ms
};
} // namespace antinode
