#pragma once

#include "AudioHost.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** The ports that touches come in by, and what came in. */
class TouchPanel final : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit TouchPanel (AudioHost& hostToUse);

    void lookAndFeelChanged() override;
    void resized() override;

private:
    void timerCallback() override { showState(); }
    void showState();
    void apply();

    AudioHost& host;
    juce::Label oscName { {}, "OSC port" }, tuioName { {}, "TUIO port" }, cursorsName { {}, "TUIO cursors" }, status;
    juce::TextEditor oscPort, tuioPort;
    juce::ComboBox cursors;
    juce::ToggleButton network { "Accept touches from the network, not only from this computer" };
    juce::TextButton applyButton { "Apply" };
};
} // namespace antinode
