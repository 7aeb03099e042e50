#include "ApplyOptions.h"

#include "OptionValues.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/Library.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
/** Which inputs fingers feel and the sensor has, and what it is. */
void takeInputs (TouchHost& host, const StandaloneOptions& options)
{
    auto inputs = host.settings().inputs;

    if (! options.inputs.empty())
        inputs.inputs = readFingerInputs (options.inputs).inputs;

    if (options.sensorInput > 0)
        inputs.sensor = options.sensorInput - 1;

    if (! options.following.empty())
    {
        const auto wanted = readFollowing (options.following);

        if (wanted.isOn() && inputs.sensor == FingerInputs::none)
            throw InputError ("--follow",
                              "needs --sensor-input with --touch: the input that the sensor is plugged into");

        host.processor().session().following().setSettings (wanted);
    }

    if (inputs != host.settings().inputs)
        host.setInputs (inputs);
}
} // namespace

StandaloneSettings withOptions (StandaloneSettings settings, const StandaloneOptions& options)
{
    auto& audio = settings.audio;

    // Kept settings of another device, rate or type do not apply.
    if (! options.type.empty() || ! options.device.empty())
        audio = {};

    if (! options.type.empty())
        audio.type = options.type;

    if (! options.device.empty())
        audio.device = options.device;

    if (options.rate > 0)
        audio.sampleRate = options.rate;

    if (options.block > 0)
        audio.blockSize = options.block;

    if (options.channels > 0)
    {
        audio.outputs.resize (static_cast<std::size_t> (options.channels));
        std::iota (audio.outputs.begin(), audio.outputs.end(), 0);
    }

    if (options.sensorInput > 0)
        audio.inputs = { options.sensorInput - 1 };
    else if (audio.inputs.empty() && ! options.following.empty() && readFollowing (options.following).isOn())
        audio.inputs = { 0 };

    settings.touch.oscPort = options.oscPort.value_or (settings.touch.oscPort);
    settings.touch.tuioPort = options.tuioPort.value_or (settings.touch.tuioPort);
    settings.touch.address = options.touchAddress.value_or (settings.touch.address);

    if (options.tuioCursors)
        settings.touch.finger = *options.tuioCursors == "foci" ? "" : *options.tuioCursors;

    return settings;
}

SettingsFile chooseSettingsFile (const StandaloneOptions& options)
{
    if (options.ignoresSettings)
        return SettingsFile ({});

    return SettingsFile (options.settings.empty() ? usualSettingsFile() : std::filesystem::absolute (options.settings));
}

void loadDocuments (StandaloneHost& host, const StandaloneOptions& options)
{
    auto device = options.instrument.empty() ? nullptr : deviceDocument (options.instrument);
    auto focus = options.focus.empty() ? nullptr : focusDocument (options.focus);

    if (options.opensGraph)
        host.processor().session().setGraphOpen (true);

    if (! options.following.empty())
        host.processor().session().following().setSettings (readFollowing (options.following));

    if (device != nullptr || focus != nullptr)
        host.processor().load (std::move (device), std::move (focus));
}

void loadFingers (TouchHost& host, const StandaloneOptions& options)
{
    if (options.fingers.size() > mostFingers)
        throw InputError ("--finger", "is given " + std::to_string (options.fingers.size())
                                          + " times; allowed: " + std::to_string (mostFingers));

    std::vector<WantedFinger> fingers;
    std::transform (options.fingers.begin(), options.fingers.end(), std::back_inserter (fingers), readFinger);

    if (! options.touch.empty())
        host.processor().load (deviceDocument (options.touch));

    takeInputs (host, options);

    if (options.touchLatency > 0)
        for (std::size_t i = 0; i < touchLatencies.size(); ++i)
            if (std::lround (touchLatencies[i] * milli) == options.touchLatency)
            {
                auto& latency = host.processor().parameters().latency();
                latency.setValueNotifyingHost (latency.convertTo0to1 (static_cast<float> (i)));
            }

    host.setFingers (std::move (fingers));
}
} // namespace antinode
