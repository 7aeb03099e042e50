#include "StandaloneOptions.h"

#include "OutputRouter.h"

#include <antinode_audio/AudioChoice.h>
#include <antinode_audio/AudioTypes.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/Library.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

namespace antinode
{
namespace
{
constexpr double lowestRate = 8000, highestRate = 2e6; // Hz
constexpr int longestBlock = 1 << 16, highestPort = 65535;
constexpr double longestDuration = 1e6; // s

void addAudioOptions (CLI::App& app, StandaloneOptions& options)
{
    app.add_flag ("--list-devices", options.listsDevices, "Lists the audio devices and exits");
    app.add_option ("--type", options.type, deviceTypeHelp());
    app.add_option ("--device", options.device, "Audio device, a name from --list-devices");
    app.add_option ("--rate", options.rate, "Sample rate, Hz")->check (CLI::Range (lowestRate, highestRate));
    app.add_option ("--block", options.block, "Block size, samples")->check (CLI::Range (1, longestBlock));
    app.add_option ("--channels", options.channels, "Number of outputs to open, from the first one on")
        ->check (CLI::Range (1, OutputRouting::maximumOutputs));
}

void addMarkerOptions (CLI::App& app, StandaloneOptions& options)
{
    app.add_option ("--marker-output", options.markerOutput,
                    "Output with a pulse from each focus on, for recorders, EEG or photodiodes; 0: none")
        ->check (CLI::Range (0, OutputRouting::maximumOutputs));
    app.add_option ("--marker-level", options.markerLevel, "Level of the marker, share of full scale (default: 0.5)")
        ->check (CLI::Range (0.0, 1.0));
    app.add_option ("--marker-ms", options.markerMilliseconds, "Width of the marker, ms (default: 5)")
        ->check (CLI::Range (0.01, 1000.0));
}

void addTouchOptions (CLI::App& app, StandaloneOptions& options)
{
    app.add_option ("--osc-port", options.oscPort, "UDP port for OSC, 0: off")->check (CLI::Range (0, highestPort));
    app.add_option ("--tuio-port", options.tuioPort, "UDP port for TUIO, 0: off")->check (CLI::Range (0, highestPort));
    app.add_option ("--touch-address", options.touchAddress,
                    "Accepts touches at this IPv4 address; 127.0.0.1: this computer only, 0.0.0.0: the whole network")
        ->check (CLI::ValidIPV4);
    app.add_option ("--allow-sender", options.senders,
                    "Takes OSC commands from this computer of the network, an IPv4 address (repeatable)")
        ->check (CLI::ValidIPV4)
        ->allow_extra_args (false);
    app.add_flag ("--allow-remote-arm", options.allowsRemoteArm, "Lets OSC commands arm the outputs")
        ->excludes ("--touch");
    app.add_option (
           "--tuio-cursors", options.tuioCursors,
           "What TUIO cursors do: play foci, or rest as a light, medium or firm finger; with --touch they always "
           "rest, as they are or as such a finger")
        ->check (CLI::IsMember ({ "foci", "light", "medium", "firm" }));
}

/** Antinode Touch in place of foci. */
void addFingerOptions (CLI::App& app, StandaloneOptions& options)
{
    auto* const touch =
        app.add_option ("--touch", options.touch,
                        "Antinode Touch: audio inputs feed fingers on this device (an embedded name or a .json file; "
                        "default: that of the settings)")
            ->type_name ("[DEVICE]")
            ->expected (0, 1)
            ->excludes ("--instrument")
            ->excludes ("--focus")
            ->excludes ("--open-graph");
    app.add_option ("--finger", options.fingers,
                    "Places a finger, mm from the device's origin, and um that 1.0 of its input moves it, 0: silent "
                    "(default: 5; repeatable, finger 1 first)")
        ->type_name ("X:Y[:UM]")
        ->allow_extra_args (false)
        ->needs (touch);
    app.add_option ("--inputs", options.inputs,
                    "Input of the audio device for each finger, finger 1 first; 0: none (default: 1,2,3,4,5,6,7,8)")
        ->type_name ("LIST")
        ->needs (touch);
    app.add_option ("--latency-ms", options.touchLatency, "From an input to its finger, ms: 20, 10 or 5")
        ->check (CLI::IsMember ({ 20, 10, 5 }))
        ->needs (touch);
    app.parse_complete_callback ([touch, &options] { options.playsTouch = touch->count() > 0; });
}

/** A sensor that listens while foci or tracks play. */
void addFollowingOptions (CLI::App& app, StandaloneOptions& options)
{
    app.add_option ("--follow,--track", options.following,
                    "Follows the drift of the device while it plays, by velocity:X:Y or displacement:X:Y (mm), by "
                    "ceramic_current:N or ceramic_charge:N of an idle ceramic (from 1), or by none")
        ->type_name ("SENSOR");
    app.add_option ("--sensor-input", options.sensorInput,
                    "Input of the audio device for the sensor, from 1 (default: that of the settings; without --touch "
                    "else 1 with --follow)")
        ->check (CLI::Range (1, maximumDeviceOutputs));
}

/** What only a program without windows is asked to do. */
void addHeadlessOptions (CLI::App& app, StandaloneOptions& options)
{
    auto* const headless = app.add_flag ("--headless", options.isHeadless, "Plays without windows or display");
    app.add_flag ("--arm", options.isArmed, "Arms the outputs; otherwise they stay at 0 V")->needs (headless);
    auto* const notes =
        app.add_option ("--note", options.notes, "Plays a note; note 60 is the focus at its own position (repeatable)")
            ->type_name ("NOTE[:VELOCITY]")
            ->allow_extra_args (false)
            ->needs (headless)
            ->excludes ("--touch");
    app.add_option ("--at", options.times, "Time of a note after the start, s (repeatable, in the order of the notes)")
        ->allow_extra_args (false)
        ->check (CLI::Range (0.0, longestDuration))
        ->needs (notes);
    app.add_option ("--midi-file", options.midiFile, "Plays the notes of a standard MIDI file")
        ->needs (headless)
        ->excludes ("--touch");
    app.add_option ("--duration", options.duration, "Duration, s; default: until Ctrl+C")
        ->check (CLI::Range (0.0, longestDuration))
        ->needs (headless);
}
} // namespace

void addStandaloneOptions (CLI::App& app, StandaloneOptions& options)
{
    addAudioOptions (app, options);
    app.add_option ("--instrument,--plate", options.instrument,
                    "Device that vibrates: an embedded name or a .json file");
    app.add_option ("--focus", options.focus, "Focus: an embedded name or a .json file");
    app.add_flag ("--open-graph", options.opensGraph,
                  "Plays by separate nodes: the same samples at a higher cost, kept with the settings");
    addFingerOptions (app, options);
    addFollowingOptions (app, options);
    addTouchOptions (app, options);
    addMarkerOptions (app, options);
    auto* const file = app.add_option ("--settings", options.settings, "Settings file; default: the user's settings");
    app.add_flag ("--no-settings", options.ignoresSettings, "Neither reads nor saves settings")->excludes (file);
    addHeadlessOptions (app, options);
}

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
    settings.touch.senders = options.senders;

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

namespace
{
/** A ceramic that had the marker's output loses it. */
void takeMarker (AudioHost& host, const StandaloneOptions& options)
{
    auto marker = host.settings().routing.marker;
    marker.output = options.markerOutput ? *options.markerOutput - 1 : marker.output;
    marker.level = options.markerLevel.value_or (marker.level);
    marker.seconds = options.markerMilliseconds ? *options.markerMilliseconds / milli : marker.seconds;

    if (marker != host.settings().routing.marker)
        host.setRouting (withMarker (host.settings().routing, marker));
}
} // namespace

void loadDocuments (StandaloneHost& host, const StandaloneOptions& options)
{
    auto device = options.instrument.empty() ? nullptr : deviceDocument (options.instrument);
    auto focus = options.focus.empty() ? nullptr : focusDocument (options.focus);

    if (options.opensGraph)
        host.processor().session().setGraphOpen (true);

    host.allowRemoteArm (options.allowsRemoteArm);
    takeMarker (host, options);

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

    host.allowRemoteArm (options.allowsRemoteArm);
    takeMarker (host, options);
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

namespace
{
/** The numbers of "24:-3.5:2", one or more with colons between them; none where something is no finite number. */
std::optional<std::vector<double>> colonNumbers (std::string_view text)
{
    std::vector<double> numbers;
    const auto* at = text.data();
    const auto* const end = at + text.size();

    for (;;)
    {
        auto& number = numbers.emplace_back();
        const auto [behind, error] = std::from_chars (at, end, number);

        if (error != std::errc() || ! std::isfinite (number) || (behind != end && *behind != ':'))
            return std::nullopt;

        if (behind == end)
            return numbers;

        at = behind + 1;
    }
}

[[noreturn]] void refuseFollowing (const std::string& text, const std::string& wrong)
{
    throw InputError ("--follow " + text, wrong
                                              + "; allowed: velocity:X:Y or displacement:X:Y, in mm, ceramic_current:N "
                                                "or ceramic_charge:N, from 1 to "
                                              + std::to_string (OutputRouting::maximumCeramics) + ", or none");
}

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

FollowingSettings readFollowing (const std::string& text)
{
    FollowingSettings settings;

    if (text == "none")
        return settings;

    const auto colon = static_cast<std::size_t> (std::find (text.begin(), text.end(), ':') - text.begin());
    const auto* const sensor = std::find_if (followingSensorWords.begin(), followingSensorWords.end(),
                                             [word = std::string_view (text).substr (0, colon)] (const auto& entry)
                                             { return entry.first == word; });

    if (sensor == followingSensorWords.end())
        refuseFollowing (text, "is no sensor");

    settings.sensor = sensor->second;
    const std::optional<std::vector<double>> behind =
        colon < text.size() ? colonNumbers (std::string_view (text).substr (colon + 1)) : std::vector<double>();

    if (! behind)
        refuseFollowing (text, "has something that is no number");

    const auto& numbers = *behind;

    if (numbers.size() != (settings.isCeramic() ? 1 : 2))
        refuseFollowing (text, settings.isCeramic() ? "does not say one ceramic" : "does not say one place");

    if (! settings.isCeramic())
    {
        settings.xMillimetres = numbers[0];
        settings.yMillimetres = numbers[1];
        return settings;
    }

    if (! (numbers[0] >= 1 && numbers[0] <= OutputRouting::maximumCeramics) || numbers[0] != std::floor (numbers[0]))
        refuseFollowing (text, "is no number of a ceramic");

    settings.ceramic = static_cast<int> (numbers[0]) - 1;
    return settings;
}

FingerInputs readFingerInputs (const std::string& list)
{
    FingerInputs read;
    read.inputs.fill (FingerInputs::none);
    const auto* at = list.data();
    const auto* const end = at + list.size();

    for (std::size_t k = 0;; ++k, ++at)
    {
        int number = 0;
        const auto [behind, error] = std::from_chars (at, end, number);
        const auto isLast = behind == end;

        if (error != std::errc() || number < 0 || number > OutputRouting::maximumOutputs || k >= read.inputs.size()
            || (! isLast && *behind != ','))
            throw InputError ("--inputs " + list,
                              "is no list of inputs; allowed: up to " + std::to_string (FingerInputs::fingers)
                                  + " numbers from 0 (none) to " + std::to_string (OutputRouting::maximumOutputs)
                                  + " with commas, the input of finger 1 first");

        read.inputs[k] = number - 1;
        at = behind;

        if (isLast)
            return read;
    }
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
