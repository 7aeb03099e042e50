#include "StandaloneOptions.h"

#include "OutputRouting.h"

#include <antinode_audio/AudioChoice.h>
#include <antinode_audio/AudioTypes.h>

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

void addTouchOptions (CLI::App& app, StandaloneOptions& options)
{
    app.add_option ("--osc-port", options.oscPort, "UDP port for OSC, 0: off")->check (CLI::Range (0, highestPort));
    app.add_option ("--tuio-port", options.tuioPort, "UDP port for TUIO, 0: off")->check (CLI::Range (0, highestPort));
    app.add_option ("--touch-address", options.touchAddress,
                    "Accepts touches at this IPv4 address; 127.0.0.1: this computer only, 0.0.0.0: the whole network")
        ->check (CLI::ValidIPV4);
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
    auto* const file = app.add_option ("--settings", options.settings, "Settings file; default: the user's settings");
    app.add_flag ("--no-settings", options.ignoresSettings, "Neither reads nor saves settings")->excludes (file);
    addHeadlessOptions (app, options);
}
} // namespace antinode
