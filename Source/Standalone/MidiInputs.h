#pragma once

#include "MidiQueue.h"
#include "StandaloneSettings.h"

#include <antinode_session/UserMessages.h>

#include <juce_audio_devices/juce_audio_devices.h>

#include <memory>
#include <vector>

namespace antinode
{
/** The MIDI inputs that are listened to; those that come and go are looked for every two seconds. */
class MidiInputs : private juce::MidiInputCallback, private juce::Timer
{
public:
    /** @param queueToFill  outlives this [message thread] */
    explicit MidiInputs (MidiQueue& queueToFill);
    ~MidiInputs() override;

    /** Opens the chosen ones, also those that appear later. [message thread] */
    void choose (const MidiChoice&);
    const MidiChoice& choice() const { return chosen; }

    /** Those that are plugged in. [message thread] */
    juce::Array<juce::MidiDeviceInfo> available() const { return juce::MidiInput::getAvailableDevices(); }

    /** Which of the chosen ones are missing or cannot be opened. [message thread] */
    std::vector<UserMessage> messages() const;

    /** How many are open. [message thread] */
    std::size_t opened() const { return inputs.size(); }

private:
    void handleIncomingMidiMessage (juce::MidiInput*, const juce::MidiMessage&) override;
    void timerCallback() override { update(); }
    void update();

    MidiQueue& queue;
    MidiChoice chosen;
    std::vector<std::unique_ptr<juce::MidiInput>> inputs;
    std::vector<std::string> refused; ///< Names of those that could not be opened.
    int missing = 0;                  ///< Chosen ones that are not plugged in.
};
} // namespace antinode
