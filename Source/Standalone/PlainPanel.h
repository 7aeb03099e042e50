#pragma once

#include "StandaloneHost.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** ARM and FIRE, where there is no editor. */
class PlainPanel : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit PlainPanel (StandaloneHost& hostToUse);

    void resized() override;

private:
    void timerCallback() override { showState(); }
    void showState();

    StandaloneHost& host;
    juce::Label status;
    juce::TextButton arm, fire { "FIRE" };
};
} // namespace antinode
