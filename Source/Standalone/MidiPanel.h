#pragma once

#include "AudioHost.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>
#include <vector>

namespace antinode
{
/** Selects the MIDI inputs; inputs that are plugged in later appear. */
class MidiPanel final : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit MidiPanel (AudioHost& hostToUse);

    void resized() override;

private:
    void timerCallback() override { update(); }
    void update();
    void choose();

    AudioHost& host;
    juce::ToggleButton all { "All inputs, including those plugged in later" };
    juce::Label none { {}, "No MIDI input is plugged in." };
    juce::Array<juce::MidiDeviceInfo> devices;
    std::vector<std::unique_ptr<juce::ToggleButton>> buttons; ///< Of the devices.
};
} // namespace antinode
