#include "ApplyOptions.h"

#include "ColonNumbers.h"
#include "FollowingOption.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
constexpr int highestNote = 127, fullVelocity = 127;

/** A whole number up to 127 from the front of some text; what is left of it stays. */
int takeNumber (std::string_view& text, int minimum, const std::string& option)
{
    int value = -1;
    const auto [end, error] = std::from_chars (text.data(), text.data() + text.size(), value);

    if (error != std::errc() || value < minimum || value > highestNote)
        throw InputError (option,
                          "is not a note; allowed: NOTE or NOTE:VELOCITY, with notes 0 to 127 and velocities 1 to 127");

    text.remove_prefix (static_cast<std::size_t> (end - text.data()));
    return value;
}

juce::MidiMessage noteFrom (const std::string& text)
{
    std::string_view left = text;
    const auto option = "--note " + text;
    const auto note = takeNumber (left, 0, option);
    auto velocity = fullVelocity;

    if (left.starts_with (':'))
    {
        left.remove_prefix (1);
        velocity = takeNumber (left, 1, option);
    }

    if (! left.empty())
        throw InputError (option, "has trailing text; allowed: NOTE or NOTE:VELOCITY");

    return juce::MidiMessage::noteOn (1, note, static_cast<juce::uint8> (velocity));
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

WantedFinger readFinger (const std::string& text)
{
    constexpr double highest = 100; // um, as the parameter has it
    const auto read = colonNumbers (text);

    if (! read || read->size() > 3)
        throw InputError ("--finger " + text, "is no finger; allowed: X:Y or X:Y:UM, numbers in mm, mm and um");

    const auto& numbers = *read;

    if (numbers.size() < 2)
        throw InputError ("--finger " + text, "has no y; allowed: X:Y or X:Y:UM, numbers in mm, mm and um");

    WantedFinger finger { numbers[0] / milli, numbers[1] / milli };

    if (numbers.size() > 2)
        finger.level = numbers[2] / micro;

    if (! (finger.level >= 0 && finger.level * micro <= highest))
        throw InputError ("--finger " + text, "has a level of " + inWords (finger.level * micro)
                                                  + " um; allowed: 0 (silent) to " + inWords (highest) + " um");

    return finger;
}

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

std::vector<TimedNote> readNotes (const StandaloneOptions& options)
{
    std::vector<TimedNote> notes;

    for (std::size_t i = 0; i < options.notes.size(); ++i)
        notes.push_back ({ i < options.times.size() ? options.times[i] : 0.0, noteFrom (options.notes[i]) });

    if (! options.midiFile.empty())
        for (auto& note : readMidiFile (options.midiFile))
            notes.push_back (std::move (note));

    return notes;
}
} // namespace antinode
