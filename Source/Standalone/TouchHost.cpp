#include "TouchHost.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_focus/DriveAllocation.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
/** Ports are the program's, not the state's. */
std::map<std::string, double> withoutPorts (std::map<std::string, double> values)
{
    for (const auto* const key : TouchProcessor::portKeys)
        values.erase (key);

    return values;
}

double percentOf (double value, double least, double most, const char* axis, std::size_t finger)
{
    if (! (value >= least && value <= most))
        throw InputError ("--finger", "finger " + std::to_string (finger + 1) + " has " + axis + " = "
                                          + inWords (value * milli) + " mm, which is outside the surface; allowed: "
                                          + inWords (least * milli) + " to " + inWords (most * milli) + " mm");

    return most > least ? 100 * (value - least) / (most - least) : 50;
}
} // namespace

TouchHost::TouchHost (SettingsFile fileToUse, bool keepsSettings) : AudioHost (std::move (fileToUse), keepsSettings)
{
    if (kept.touchState)
    {
        auto state = *kept.touchState;
        state.parameters = withoutPorts (std::move (state.parameters));
        player.setState (state, true);
    }

    begin (player);
    callback().setInputs (kept.inputs);
}

TouchHost::~TouchHost()
{
    end();
}

RemotePlayer TouchHost::remotePlayer()
{
    auto remote = remotePlayerOf (player);
    remote.load = [this] (const auto& device, const auto& focus)
    {
        if (device != nullptr)
            player.load (device);

        if (focus != nullptr)
            player.loadFocus (focus);
    };
    remote.present = [this]
    {
        const auto now = player.session().snapshot();
        const auto focus = player.focus();
        return RemotePlayer::Present { now->device,    focus,
                                       now->model,     focus != nullptr ? focus->description : FocusDescription {},
                                       now->isSolving, now->error };
    };
    return remote;
}

void TouchHost::setInputs (const FingerInputs& inputs)
{
    kept.inputs = inputs;
    callback().setInputs (inputs);
    tellChange();
}

void TouchHost::setFingers (std::vector<WantedFinger> fingers)
{
    wantedFingers = std::move (fingers);
    fingerFailure.clear();
}

void TouchHost::openAudio (const AudioChoice& choice)
{
    auto all = choice;
    all.inputs.clear();
    all.opensAllInputs = true;
    AudioHost::openAudio (all);
}

/** The sensor's input of the program that plays foci stays what it was. */
AudioChoice TouchHost::audioToKeep (AudioChoice opened) const
{
    opened.inputs = kept.audio.inputs;
    return opened;
}

void TouchHost::setTouch (const TouchPorts& ports)
{
    kept.touch = ports;
    tellChange();
    player.network().open (ports);
}

/** What is kept has no touches: they are lifted first. */
void TouchHost::shutDown()
{
    player.network().open ({ 0, 0, kept.touch.address });
    player.network().apply();
    AudioHost::shutDown();
}

void TouchHost::keepState (StandaloneSettings& settings)
{
    auto state = player.state();
    state.parameters = withoutPorts (std::move (state.parameters));
    settings.touchState = std::move (state);
}

Eigen::VectorXd TouchHost::limits()
{
    const auto now = model();
    const auto focus = player.focus();
    const auto choice = focus != nullptr ? focus->description.allocation : AllocationChoice {};
    return now != nullptr ? voltageLimits (*now, choice) : Eigen::VectorXd();
}

/** Of models and focuses: filters come and go too often to ramp to 0 V for each. */
std::uint64_t TouchHost::generation()
{
    auto now = model();
    auto focus = player.focus();

    if (now != seenModel || focus != seenFocus)
    {
        seenModel = std::move (now);
        seenFocus = std::move (focus);
        ++seen;
    }

    return seen;
}

juce::String TouchHost::touchLines (const TouchCounters& counters)
{
    const auto& touches = player.network().touches();
    return juce::String (touches.resting()) + " fingers touched, " + juce::String (touches.waiting())
           + " touches wait for one\nDropped: " + juce::String (faultCount (counters)) + " faulty, "
           + juce::String (touches.dropped()) + " too many";
}

std::string TouchHost::unusedTouches (const TouchCounters& counters)
{
    return std::to_string (faultCount (counters)) + " faulty, " + std::to_string (player.network().touches().dropped())
           + " touches too many";
}

juce::String TouchHost::latencyText()
{
    auto* const device = devices().getCurrentAudioDevice();

    if (device == nullptr || ! (device->getCurrentSampleRate() > 0))
        return {};

    const auto milliseconds = [rate = device->getCurrentSampleRate()] (int samples)
    { return fixedText (1000 * std::max (0, samples) / rate, 1); };
    const auto filters = player.getLatencySamples(), block = device->getCurrentBufferSizeSamples(),
               ways = device->getInputLatencyInSamples() + device->getOutputLatencyInSamples();
    return juce::String ("felt " + milliseconds (filters + block + ways)
                         + " ms after an input: " + milliseconds (filters) + " filters, " + milliseconds (block)
                         + " block, " + milliseconds (ways) + " device");
}

juce::String TouchHost::latencyAdviceText()
{
    return "Latency of the filters: 20, 10 or 5 ms, at the cost that stands below the fingers' controls. A smaller "
           "block in Settings, Audio device, takes more of the processor.";
}

std::map<std::string, double> TouchHost::fingerValues (const Surface& surface)
{
    auto values = withoutPorts (player.parameters().values());

    for (std::size_t k = 0; k < mostFingers; ++k)
    {
        const auto finger = "finger" + std::to_string (k + 1) + "_";
        auto& presence = values[finger + "state"];
        presence = static_cast<double> (FingerPresence::absent);

        if (k >= wantedFingers.size())
            continue;

        const auto& wanted = wantedFingers[k];
        values[finger + "x"] = percentOf (wanted.x, surface.xMinimum, surface.xMaximum, "x", k);
        values[finger + "y"] = percentOf (wanted.y, surface.yMinimum, surface.yMaximum, "y", k);
        presence = static_cast<double> (wanted.level > 0 ? FingerPresence::plays : FingerPresence::silent);

        if (wanted.level > 0)
            values[finger + "level"] = wanted.level * micro;
    }

    return values;
}

void TouchHost::tick()
{
    const auto now = player.session().snapshot();

    if (wantedFingers.empty() || now->model == nullptr || now->isSolving || now->device == nullptr
        || now->device->text != player.device()->text)
        return;

    if (! attempt (MessageSource::fingers,
                   [&]
                   {
                       fingerFailure.clear();
                       player.parameters().setValues (fingerValues (now->model->surface));
                   }))
    {
        fingerFailure = message (MessageSource::fingers).toStdString();
        tellChange();
    }

    wantedFingers.clear();
}
} // namespace antinode
