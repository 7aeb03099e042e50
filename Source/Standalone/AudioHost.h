#pragma once

#include "AudioCallback.h"
#include "MidiNotes.h"
#include "RemoteControl.h"
#include "StandaloneSettings.h"

#include <Processor/DeviceProcessor.h>
#include <Processor/ParameterTypes.h>
#include <antinode_session/InstrumentMeters.h>
#include <antinode_session/UserMessages.h>
#include <antinode_touch/Touch.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** Whether an audio device still calls: one that has gone says nothing, and what else it says is not to be trusted. */
class DeviceWatch
{
public:
    using Milliseconds = std::uint32_t; ///< Of a clock that may wrap.

    static constexpr Milliseconds patience = 3000; ///< Without a call.

    /** A device has been opened. [message thread] as all that follows */
    void begin (Milliseconds now)
    {
        seenAt = now;
        watches = true;
        stopped = false;
    }

    /** It has been closed. */
    void end() { watches = stopped = false; }

    /** Looks. @param samples  that were played since the start @return  whether hasStopped() has changed */
    bool look (std::int64_t samples, Milliseconds now)
    {
        const auto before = stopped;

        if (samples != seenSamples)
        {
            seenSamples = samples;
            seenAt = now;
        }

        stopped = watches && now - seenAt > patience;
        return stopped != before;
    }

    bool hasStopped() const { return stopped; }

private:
    std::int64_t seenSamples = 0;
    Milliseconds seenAt = 0;
    bool watches = false, stopped = false;
};

/** What a message of the program itself is about: each has one, until what was attempted succeeds. */
enum class MessageSource
{
    audio,
    ports,
    fingers,
    settings, ///< That could not be read.
    saving
};

/** The standalone program without its windows and without what it plays: device, routing, MIDI inputs, and saved
    settings. Who derives from it adds the processor, calls begin() when all is made and end() before anything of it
   goes. Starts disarmed. */
class AudioHost : private juce::ChangeListener,
                  private juce::AudioProcessorListener,
                  private juce::AsyncUpdater,
                  private juce::Timer
{
public:
    ~AudioHost() override;

    OutputRouter& router() { return outputRouter; }
    AudioCallback& callback() { return *audio; }
    juce::AudioDeviceManager& devices() { return deviceManager; }
    MidiInputs& midi() { return *midiInputs; }
    const StandaloneSettings& settings() const { return kept; }

    /** Each takes effect, and is kept. @throws InputError  where it cannot be had [message thread] */
    virtual void openAudio (const AudioChoice&);
    void setRouting (const OutputRouting&);
    void setMidi (const MidiChoice&);
    virtual void setTouch (const TouchPorts&) = 0;

    /** Whether commands from outside may arm, from when ports are opened next; not at first. [message thread] */
    void allowRemoteArm (bool isAllowed);

    /** What commands reach. [message thread] */
    virtual RemotePlayer remotePlayer() = 0;

    /** Whether the device that was opened has stopped to call. [message thread] */
    bool hasDeviceStopped() const { return watch.hasStopped(); }

    /** Kept only: the window uses it. [message thread] */
    void setBench (const BenchSensor&);
    void setDark (bool isDark);
    void setScale (double);

    /** Opens what the settings say of audio, MIDI and touch, and keeps them; what cannot be opened becomes a warning.
        [message thread] */
    void openAll (const StandaloneSettings&);

    /** Ramps everything to 0 V, ends all that plays and the identify tone; stays so until release. [any but the audio
        thread] */
    void muteAll();

    /** Mutes and waits for the end of the ramp, where a device plays, then closes it. [message thread] blocks for up to
        0.5 s */
    virtual void shutDown();

    /** Does what may fail. Its message stands until it has succeeded. @return  whether it did [message thread] */
    bool attempt (MessageSource, const std::function<void()>& action);

    /** What failed last, or empty. [message thread] */
    juce::String message (MessageSource) const;

    /** All that there is to say, the worst first. [message thread] */
    std::vector<UserMessage> messages();

    /** The first warning among them, or empty. [message thread] */
    juce::String warning() { return juce::String::fromUTF8 (firstWarning (messages()).c_str()); }

    /** A warning about ceramics whose outputs the device does not have, or empty. [message thread] */
    juce::String silentCeramics();

    /** The device that vibrates, solved; none before. [any but the audio thread] */
    std::shared_ptr<const ModalModel> model() const { return instrument->processor.playing().model; }

    SwitchParameter& arm() const { return instrument->arm; }

    /** Ends what plays, as far as it ends by itself, and voids what waits to play. [any but the audio thread] */
    virtual void stopAll() = 0;

    /** How often all was ended, by whatever command. [any] */
    std::uint64_t stopCommands() const { return instrument->stops.commands(); }

    /** Of the ceramics while this plays, V; none: no device is solved. [message thread] */
    virtual Eigen::VectorXd limits() = 0;

    /** Of what plays. [any but the audio thread] */
    LevelMeters& meters() const { return *instrument->processor.playing().meters; }

    /** What the device's driver says that a sample takes to its output, s; 0 without a device. [any] */
    double outputLatency() const { return latencyOfOutput; }

    /** The largest voltage of all ceramics since the last call, V. [any but the audio thread] */
    float takePeakVolts();

    /** What touches came in and what became of them, in lines. [message thread] */
    juce::String touchStatus();

    /** How many packets came in, and what of them did nothing, for the end of a run; empty where none came. [message
        thread] */
    std::string touchOutcome();

    /** Whether cursors can play foci; else they are always fingers. */
    virtual bool playsFoci() const = 0;

    /** From what is played until it is felt, in words, and how to lower the largest part; empty without a device.
        [message thread] */
    virtual juce::String latencyText() = 0;
    virtual juce::String latencyAdviceText() = 0;

    /** Called after a routing, device or warning has changed. [message thread] */
    std::function<void()> onChange;

protected:
    /** Takes over the settings, but opens nothing.
        @param keepsSettings  whether what changes is written at once
        [message thread] */
    AudioHost (SettingsFile, bool keepsSettings);

    /** From now on it lives. @param player  a RoleProcessor that plays an instrument, as it was left last time; must
       live until end() [message thread] */
    template <typename Player>
    void begin (Player& player)
    {
        auto& session = player.session();
        begin ({ player, player.parameters().arm(), session.stops(), [&session] { return session.fullScaleVolts(); },
                 [&session] (const std::vector<double>& volts) { session.setAmplifiers (volts); },
                 [&session] (float* to, int count, std::int64_t width) { session.writeMarker (to, count, width); } });
    }

    /** What all sessions give to commands. */
    template <typename Player>
    static RemotePlayer remotePlayerOf (Player& player)
    {
        auto& session = player.session();
        return { session.clock(),
                 session.reports(),
                 [&session] (int slot, PrepareDesign design, RemotePlayer::Ready ready)
                 { session.prepareFocus (slot, std::move (design), std::move (ready)); },
                 [&session] (int slot, double amplitude, std::uint32_t request, std::int64_t due)
                 { return session.playPrepared (slot, amplitude, request, due); },
                 {},
                 [&player] { return player.messages(); },
                 {} };
    }

    /** Shuts down, and does nothing any more. [message thread] */
    void end();

    /** Something has changed: settings are kept, the window is told. [message thread] */
    void tellChange() { triggerAsyncUpdate(); }

    /** Says so until what it is about succeeds. */
    void warn (const std::string& text, MessageSource source = MessageSource::audio) { failures[source] = text; }

    /** Of all kinds together. */
    static std::int64_t faultCount (const TouchCounters&);

    StandaloneSettings kept;

private:
    /** What plays. */
    struct Instrument
    {
        DeviceProcessor& processor;
        SwitchParameter& arm;
        StopCount& stops;
        std::function<double()> fullScaleVolts;                         ///< As AudioEntry.
        std::function<void (const std::vector<double>&)> setAmplifiers; ///< As DeviceRounds.
        std::function<void (float*, int, std::int64_t)> writeMarker;    ///< As AudioEntry.
    };

    void begin (Instrument);
    virtual void keepState (StandaloneSettings&) = 0; ///< What plays, into the settings.
    virtual std::uint64_t generation() = 0;           ///< Another one where limits may have changed.
    virtual void setControl (OscControl) = 0;         ///< Of the ports that are opened from now on.
    virtual void tick() {}                            ///< 20 times a second.
    virtual TouchPorts openPorts() = 0;
    virtual TouchCounters touchCounters() = 0;
    virtual juce::String touchLines (const TouchCounters&) = 0;   ///< Of touchStatus().
    virtual std::string unusedTouches (const TouchCounters&) = 0; ///< Of touchOutcome().
    virtual AudioChoice audioToKeep (AudioChoice opened) const { return opened; }

    void changeListenerCallback (juce::ChangeBroadcaster*) override;
    void audioProcessorParameterChanged (juce::AudioProcessor*, int, float) override { triggerAsyncUpdate(); }
    void audioProcessorChanged (juce::AudioProcessor*, const ChangeDetails&) override { triggerAsyncUpdate(); }
    void handleAsyncUpdate() override;
    void timerCallback() override;
    void retryPorts();
    void passRouting();
    void keepOpened();
    void waitForSilence();
    void save();

    SettingsFile file;
    bool keeps;
    std::map<MessageSource, std::string> failures;
    juce::uint32 portsTried = 0; ///< ms, when those that could not be opened were tried again.
    OutputRouter outputRouter;
    std::atomic<double> latencyOfOutput { 0 }; ///< s
    std::optional<Instrument> instrument;      ///< From begin() on.
    std::unique_ptr<MidiQueue> notes;
    std::unique_ptr<AudioCallback> audio;
    std::unique_ptr<MidiInputs> midiInputs;
    juce::AudioDeviceManager deviceManager;
    DeviceWatch watch;
    std::shared_ptr<RemoteControl> control;
    std::uint64_t seenGeneration = 0; ///< When it was looked at last.
    OutputRouting passedRouting;      ///< To the router, with the next line.
    std::vector<double> passedLimits;
};
} // namespace antinode
