#include "AudioHost.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
constexpr int hostTickMilliseconds = 50;
constexpr juce::uint32 retryMilliseconds = 2000;
constexpr int rampPatience = 500; // ms, for the end of the ramp of a device that may have died

juce::String portInWords (int port)
{
    return port > 0 ? "on port " + juce::String (port) : juce::String ("off");
}
} // namespace

AudioHost::AudioHost (SettingsFile fileToUse, bool keepsSettings)
    : kept (fileToUse.load()), file (std::move (fileToUse)), keeps (keepsSettings)
{
    warn (file.warning(), MessageSource::settings);
}

AudioHost::~AudioHost() = default;

void AudioHost::begin (Instrument toPlay)
{
    instrument.emplace (std::move (toPlay));
    // However it was left: whoever starts the program arms it.
    arm().setValueNotifyingHost (0);
    notes = std::make_unique<MidiQueue> (instrument->stops);
    midiInputs = std::make_unique<MidiInputs> (*notes);
    audio = std::make_unique<AudioCallback> (
        instrument->processor, outputRouter, *notes,
        PlayedLevels { instrument->fullScaleVolts, [this] { return arm().get(); }, instrument->writeMarker });
    passRouting();
    instrument->processor.addListener (this);
    deviceManager.addChangeListener (this);
    deviceManager.addAudioCallback (audio.get());
    startTimer (hostTickMilliseconds);
    allowRemoteArm (false);
}

void AudioHost::end()
{
    stopTimer();
    shutDown();
    midiInputs = nullptr;
    deviceManager.removeAudioCallback (audio.get());
    deviceManager.removeChangeListener (this);
    instrument->processor.removeListener (this);
    cancelPendingUpdate();
    control = nullptr;
}

void AudioHost::allowRemoteArm (bool isAllowed)
{
    control = std::make_shared<RemoteControl> (*this, remotePlayer(), isAllowed);
    setControl ({ [now = control] (const OscMessage& message, const OscSender& sender) { now->take (message, sender); },
                  [now = control] { return now->answers(); } });
}

void AudioHost::openAudio (const AudioChoice& choice)
{
    const auto wasMuted = outputRouter.isMuted();
    muteAll();
    waitForSilence();
    deviceManager.closeAudioDevice();
    watch.end();
    failures.erase (MessageSource::audio);

    if (! wasMuted)
        outputRouter.release();

    antinode::openAudio (deviceManager, choice);

    if (auto* const device = deviceManager.getCurrentAudioDevice();
        device != nullptr && device->getCurrentSampleRate() > 0)
        latencyOfOutput = std::max (0, device->getOutputLatencyInSamples()) / device->getCurrentSampleRate();

    watch.begin (juce::Time::getMillisecondCounter());
    keepOpened();
    triggerAsyncUpdate();
}

void AudioHost::setRouting (const OutputRouting& routing)
{
    validate (routing);
    kept.routing = routing;
    passRouting();
    triggerAsyncUpdate();
}

void AudioHost::setMidi (const MidiChoice& choice)
{
    kept.midi = choice;
    midiInputs->choose (choice);
    triggerAsyncUpdate();
}

void AudioHost::setBench (const BenchSensor& sensor)
{
    kept.bench = sensor;
    triggerAsyncUpdate();
}

void AudioHost::setScale (double scale)
{
    kept.scale = scale;
    triggerAsyncUpdate();
}

void AudioHost::setDark (bool isDark)
{
    kept.isDark = isDark;
    triggerAsyncUpdate();
}

bool AudioHost::attempt (MessageSource source, const std::function<void()>& action)
{
    try
    {
        action();
        failures.erase (source);
        return true;
    }
    catch (const InputError& failure)
    {
        warn (failure.what(), source);
        return false;
    }
}

juce::String AudioHost::message (MessageSource source) const
{
    const auto found = failures.find (source);
    return found == failures.end() ? juce::String() : juce::String::fromUTF8 (found->second.c_str());
}

void AudioHost::openAll (const StandaloneSettings& wanted)
{
    setMidi (wanted.midi);
    attempt (MessageSource::ports, [&] { setTouch (wanted.touch); });

    // A device that has other rates or fewer channels than last time is better than none.
    if (! attempt (MessageSource::audio, [&] { openAudio (wanted.audio); }))
        attempt (MessageSource::audio, [&] { openAudio ({ wanted.audio.type, wanted.audio.device, 0, 0, {} }); });
}

void AudioHost::muteAll()
{
    outputRouter.muteAll();
    outputRouter.identify (OutputRouting::none);
    stopAll();
}

/** After muteAll(): until the device has played the ramp. */
void AudioHost::waitForSilence()
{
    if (audio->sampleRate() <= 0)
        return;

    const auto end = juce::Time::getMillisecondCounter() + rampPatience;

    while (! outputRouter.isSilent() && juce::Time::getMillisecondCounter() < end)
        juce::Thread::sleep (1);

    // The end of the ramp is still in the device's buffers; behind it comes silence.
    juce::Thread::sleep (hostTickMilliseconds);
}

void AudioHost::shutDown()
{
    save();
    muteAll();
    waitForSilence();
    watch.end();
    deviceManager.closeAudioDevice();
}

float AudioHost::takePeakVolts()
{
    float peak = 0;

    for (int i = 0; i < LevelMeters::ceramics; ++i)
        peak = std::max (peak, meters().takePeak (i));

    return peak;
}

std::int64_t AudioHost::faultCount (const TouchCounters& counters)
{
    return std::accumulate (counters.faults.begin(), counters.faults.end(), counters.strangers);
}

juce::String AudioHost::touchStatus()
{
    const auto ports = openPorts();
    const auto counters = touchCounters();
    return "OSC " + portInWords (ports.oscPort) + ", TUIO " + portInWords (ports.tuioPort) + "\n"
           + juce::String (counters.packets) + " packets, " + juce::String (counters.touches) + " touches forwarded\n"
           + touchLines (counters);
}

std::string AudioHost::touchOutcome()
{
    const auto counters = touchCounters();
    const auto packets = std::to_string (counters.packets) + " touch packet" + (counters.packets == 1 ? "" : "s");
    return counters.packets == 0 ? std::string() : "of " + packets + ": " + unusedTouches (counters);
}

std::vector<UserMessage> AudioHost::messages()
{
    std::vector<UserMessage> messages;

    if (hasDeviceStopped())
        addMessage (messages, Urgency::warning,
                    "The audio device has stopped, and nothing plays. Once it is there again, press Refresh in "
                    "Settings, Audio device.");

    for (const auto& [source, text] : failures)
        addMessage (messages, Urgency::warning, text);

    for (const auto& more : { instrument->processor.messages(), midiInputs->messages() })
        messages.insert (messages.end(), more.begin(), more.end());

    addMessage (messages, Urgency::warning, silentCeramics().toStdString());
    return worstFirst (std::move (messages));
}

juce::String AudioHost::silentCeramics()
{
    const auto now = model();
    auto* const device = deviceManager.getCurrentAudioDevice();

    if (now == nullptr || device == nullptr)
        return {};

    const auto open = device->getActiveOutputChannels();
    const auto ceramics = std::min (static_cast<int> (now->actuators()), OutputRouting::maximumCeramics);
    const auto first = kept.routing.outputs.begin();
    const auto silent = std::count_if (
        first, first + ceramics, [&open] (int output) { return output != OutputRouting::none && ! open[output]; });
    return silent == 0 ? juce::String()
                       : juce::String (silent) + " of " + juce::String (ceramics)
                             + " ceramics stay at 0 V: their outputs are not among the "
                             + juce::String (open.countNumberOfSetBits()) + " open outputs.";
}

void AudioHost::changeListenerCallback (juce::ChangeBroadcaster*)
{
    keepOpened();
    triggerAsyncUpdate();
}

/** A device that is gone for now is not forgotten, and one that has died says nothing that is worth keeping; another
   one makes old warnings pointless. */
void AudioHost::keepOpened()
{
    auto opened = openedAudio (deviceManager);

    if (! (opened.sampleRate > 0 && opened.blockSize > 0))
        return;

    if (auto toKeep = audioToKeep (std::move (opened)); toKeep != kept.audio)
    {
        kept.audio = std::move (toKeep);
        failures.erase (MessageSource::audio);
    }
}

void AudioHost::handleAsyncUpdate()
{
    save();

    if (onChange)
        onChange();
}

void AudioHost::timerCallback()
{
    outputRouter.collect();
    tick();
    retryPorts();

    if (const auto now = generation(); std::exchange (seenGeneration, now) != now)
    {
        passRouting();
        triggerAsyncUpdate();
    }

    if (watch.look (audio->samplesPlayed(), juce::Time::getMillisecondCounter()))
        triggerAsyncUpdate();

    if (auto failure = audio->takeError(); failure.isNotEmpty())
    {
        warn ("The audio device has failed: " + failure.toStdString());
        triggerAsyncUpdate();
    }
}

/** A port that another program had may be free by now. */
void AudioHost::retryPorts()
{
    const auto now = juce::Time::getMillisecondCounter();

    if (failures.count (MessageSource::ports) == 0 || now - portsTried < retryMilliseconds)
        return;

    portsTried = now;
    attempt (MessageSource::ports, [this] { setTouch (kept.touch); });
}

/** With the limits of the ceramics, which the identify tone needs. What an output cannot give is a limit of what plays.
 */
void AudioHost::passRouting()
{
    instrument->setAmplifiers (amplifierVoltages (kept.routing));
    const auto volts = limits();
    std::vector<double> wanted (volts.begin(), volts.end());

    // Each one ramps all outputs to 0 V and back.
    if (kept.routing == passedRouting && wanted == passedLimits)
        return;

    outputRouter.setRouting (kept.routing, wanted);
    passedRouting = kept.routing;
    passedLimits = std::move (wanted);
}

void AudioHost::save()
{
    if (! keeps)
        return;

    attempt (MessageSource::saving,
             [this]
             {
                 keepState (kept);
                 file.save (kept);
             });
}
} // namespace antinode
