#include "StandaloneHost.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <chrono>

namespace antinode
{
namespace
{
constexpr int tickMilliseconds = 50;
constexpr int rampPatience = 500; // ms, for the end of the ramp of a device that may have died
} // namespace

StandaloneHost::StandaloneHost (SettingsFile fileToUse, bool keepsSettings)
    : file (std::move (fileToUse)), keeps (keepsSettings), kept (file.load())
{
    warn (file.warning());

    if (kept.state)
        player.setState (*kept.state, true);

    // However it was left: whoever starts the program arms it.
    player.parameters().arm().setValueNotifyingHost (0);
    passRouting();
    player.addListener (this);
    deviceManager.addChangeListener (this);
    deviceManager.addAudioCallback (&audio);
    startTimer (tickMilliseconds);
}

StandaloneHost::~StandaloneHost()
{
    stopTimer();
    shutDown();
    deviceManager.removeAudioCallback (&audio);
    deviceManager.removeChangeListener (this);
    player.removeListener (this);
    cancelPendingUpdate();
}

void StandaloneHost::openAudio (const AudioChoice& choice)
{
    const auto wasMuted = outputRouter.isMuted();
    muteAll();
    waitForSilence();
    deviceManager.closeAudioDevice();

    if (! wasMuted)
        outputRouter.release();

    antinode::openAudio (deviceManager, choice);
    kept.audio = openedAudio (deviceManager);
    triggerAsyncUpdate();
}

void StandaloneHost::setRouting (const OutputRouting& routing)
{
    validate (routing);
    kept.routing = routing;
    passRouting();
    triggerAsyncUpdate();
}

void StandaloneHost::setTouch (const TouchPorts& ports)
{
    kept.touch = ports;
    triggerAsyncUpdate();
    touchInput.open (ports);
}

void StandaloneHost::restTouches()
{
    const auto model = player.session().snapshot()->model;

    if (model == nullptr)
        return;

    const auto own = player.state().focus;
    const auto wanted = touchInput.resting().due (own->description.fingers, player.touches(), model->surface,
                                                  std::chrono::steady_clock::now());

    if (! wanted)
        return;

    try
    {
        player.setTouches (*wanted);
    }
    catch (const InputError& failure)
    {
        warn (failure.what());
        triggerAsyncUpdate();
    }
}

void StandaloneHost::setMidi (const MidiChoice& choice)
{
    kept.midi = choice;
    midiInputs.choose (choice);
    triggerAsyncUpdate();
}

void StandaloneHost::setDark (bool isDark)
{
    kept.isDark = isDark;
    triggerAsyncUpdate();
}

void StandaloneHost::openAll (const StandaloneSettings& wanted)
{
    setMidi (wanted.midi);
    const auto succeeds = [this] (const auto& action)
    {
        try
        {
            action();
            return true;
        }
        catch (const InputError& failure)
        {
            warn (failure.what());
            return false;
        }
    };
    succeeds ([&] { setTouch (wanted.touch); });

    // A device that has other rates or fewer channels than last time is better than none.
    if (! succeeds ([&] { openAudio (wanted.audio); }))
        succeeds ([&] { openAudio ({ wanted.audio.type, wanted.audio.device, 0, 0, {} }); });
}

void StandaloneHost::muteAll()
{
    outputRouter.muteAll();
    outputRouter.identify (OutputRouting::none);
    player.session().stopAll();
}

/** After muteAll(): until the device has played the ramp. */
void StandaloneHost::waitForSilence()
{
    if (audio.sampleRate() <= 0)
        return;

    const auto end = juce::Time::getMillisecondCounter() + rampPatience;

    while (! outputRouter.isSilent() && juce::Time::getMillisecondCounter() < end)
        juce::Thread::sleep (1);

    // The end of the ramp is still in the device's buffers; behind it comes silence.
    juce::Thread::sleep (tickMilliseconds);
}

void StandaloneHost::shutDown()
{
    touchInput.open ({ 0, 0, kept.touch.address });
    player.setTouches ({});
    save();
    muteAll();
    waitForSilence();
    deviceManager.closeAudioDevice();
}

juce::String StandaloneHost::warning()
{
    if (ownWarning.isNotEmpty())
        return ownWarning;

    const auto ofPlayer = player.warning();
    return ofPlayer.isNotEmpty() ? ofPlayer : silentCeramics();
}

juce::String StandaloneHost::silentCeramics()
{
    const auto model = player.session().snapshot()->model;
    auto* const device = deviceManager.getCurrentAudioDevice();

    if (model == nullptr || device == nullptr)
        return {};

    const auto open = device->getActiveOutputChannels();
    const auto ceramics = std::min (static_cast<int> (model->actuators()), OutputRouting::maximumCeramics);
    const auto first = kept.routing.outputs.begin();
    const auto silent = std::count_if (
        first, first + ceramics, [&open] (int output) { return output != OutputRouting::none && ! open[output]; });
    return silent == 0 ? juce::String()
                       : juce::String (silent) + " of " + juce::String (ceramics)
                             + " ceramics stay at 0 V: their outputs are not among the "
                             + juce::String (open.countNumberOfSetBits()) + " open outputs.";
}

void StandaloneHost::changeListenerCallback (juce::ChangeBroadcaster*)
{
    // A device that is gone for now is not forgotten; another one makes old warnings pointless.
    if (auto opened = openedAudio (deviceManager); ! opened.type.empty() && opened != kept.audio)
    {
        kept.audio = std::move (opened);
        ownWarning.clear();
    }

    triggerAsyncUpdate();
}

void StandaloneHost::handleAsyncUpdate()
{
    save();

    if (onChange)
        onChange();
}

void StandaloneHost::timerCallback()
{
    outputRouter.collect();
    restTouches();
    const auto generation = player.session().snapshot()->generation;

    if (generation != seenGeneration)
        passRouting();

    if (generation != seenGeneration || player.mutes() != seenMutes)
        triggerAsyncUpdate();

    seenGeneration = generation;
    seenMutes = player.mutes();

    if (auto failure = audio.takeError(); failure.isNotEmpty())
    {
        warn ("The audio device has failed: " + failure.toStdString());
        triggerAsyncUpdate();
    }
}

/** With the limits of the ceramics, which the identify tone needs. What an output cannot give is a limit of the foci.
 */
void StandaloneHost::passRouting()
{
    player.session().setAmplifiers (amplifierVoltages (kept.routing));
    std::vector<double> limits;

    if (const auto model = player.session().snapshot()->model; model != nullptr)
        for (std::size_t i = 0; i < model->ceramics.size(); ++i)
            limits.push_back (voltageLimit (*model, i));

    outputRouter.setRouting (kept.routing, limits);
}

void StandaloneHost::save()
{
    if (! keeps)
        return;

    try
    {
        kept.state = player.state();
        file.save (kept);
    }
    catch (const InputError& failure)
    {
        warn (failure.what());
    }
}
} // namespace antinode
