#pragma once

#include "AudioHost.h"
#include "PanelParts.h"
#include "TouchHost.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace antinode
{
/** The input of the audio device that each finger feels, and its level; and that of the sensor. */
class InputsPanel final : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit InputsPanel (TouchHost& hostToUse);

    /** Shows what the host says, and what inputs there are. [message thread] */
    void update();

    void resized() override;

private:
    void timerCallback() override;

    TouchHost& host;
    static constexpr std::size_t sensor = FingerInputs::fingers; ///< Its row is behind those of fingers.

    std::array<juce::Label, sensor + 1> names;
    std::array<juce::ComboBox, sensor + 1> choices;
    std::array<LevelBar, FingerInputs::fingers> levels;
    juce::TextButton straight { "One to one" };
    std::pair<int, int> shownInputs { -1, -1 }; ///< That are listed, and the open ones of them.
};

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
