#pragma once

#include "AudioCallback.h"
#include "MidiInputs.h"
#include "SettingsFile.h"
#include "TouchInput.h"

#include <functional>

namespace antinode
{
/** The standalone program without its windows: processor, device, routing, MIDI, touch, and their saved settings.
    Starts disarmed. */
class StandaloneHost : private juce::ChangeListener,
                       private juce::AudioProcessorListener,
                       private juce::AsyncUpdater,
                       private juce::Timer
{
public:
    /** Takes over the settings, but opens nothing.
        @param keepsSettings  whether what changes is written at once
        [message thread] */
    StandaloneHost (SettingsFile, bool keepsSettings);
    ~StandaloneHost() override;

    AntinodeProcessor& processor() { return player; }
    OutputRouter& router() { return outputRouter; }
    AudioCallback& callback() { return audio; }
    MidiInputs& midi() { return midiInputs; }
    TouchInput& touch() { return touchInput; }
    juce::AudioDeviceManager& devices() { return deviceManager; }
    const StandaloneSettings& settings() const { return kept; }

    /** Each takes effect, and is kept. @throws InputError  where it cannot be had [message thread] */
    void openAudio (const AudioChoice&);
    void setRouting (const OutputRouting&);
    void setTouch (const TouchPorts&);
    void setMidi (const MidiChoice&);

    /** Puts touches that rest on the surface as fingers, and lifts those that have left, where that is due. The host
        does so itself 20 times a second. [message thread] */
    void restTouches();

    /** Kept only: the window shows it. [message thread] */
    void setDark (bool isDark);

    /** Opens what the settings say of audio, MIDI and touch, and keeps them; what cannot be opened becomes a warning.
        [message thread] */
    void openAll (const StandaloneSettings&);

    /** Ramps everything to 0 V, ends all foci and the identify tone; stays so until release. [any but the audio thread]
     */
    void muteAll();

    /** Mutes and waits for the end of the ramp, where a device plays, then closes it. [message thread] blocks for up to
        0.5 s */
    void shutDown();

    /** A warning for the user, or empty. [message thread] */
    juce::String warning();

    /** A warning about ceramics whose outputs the device does not have, or empty. [message thread] */
    juce::String silentCeramics();

    /** Called after a routing, device or warning has changed. [message thread] */
    std::function<void()> onChange;

private:
    void changeListenerCallback (juce::ChangeBroadcaster*) override;
    void audioProcessorParameterChanged (juce::AudioProcessor*, int, float) override { triggerAsyncUpdate(); }
    void audioProcessorChanged (juce::AudioProcessor*, const ChangeDetails&) override { triggerAsyncUpdate(); }
    void handleAsyncUpdate() override;
    void timerCallback() override;
    void passRouting();
    void waitForSilence();
    void save();
    void warn (const std::string& text) { ownWarning = juce::String::fromUTF8 (text.c_str()); }

    SettingsFile file;
    bool keeps;
    StandaloneSettings kept;
    juce::String ownWarning;
    AntinodeProcessor player { AntinodeProcessor::maximumCeramics, juce::AudioProcessor::wrapperType_Undefined };
    OutputRouter outputRouter;
    MidiQueue midiQueue;
    AudioCallback audio { player, outputRouter, midiQueue };
    MidiInputs midiInputs { midiQueue };
    TouchInput touchInput { player.session() };
    juce::AudioDeviceManager deviceManager;
    std::uint64_t seenGeneration = 0, seenMutes = 0; ///< Of the session, when it was looked at last.
};
} // namespace antinode
