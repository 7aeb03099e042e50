#pragma once

#include "StandaloneHost.h"
#include "TouchHost.h"

#include <antinode_session/Following.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The command-line options of antinode-standalone. */
struct StandaloneOptions
{
    bool isHeadless = false, listsDevices = false, isArmed = false, ignoresSettings = false, opensGraph = false;
    std::string type, device;         ///< Of the audio device; empty: as in the settings.
    double rate = 0;                  ///< Hz; 0: as in the settings.
    int block = 0, channels = 0;      ///< 0: as in the settings.
    std::string focus, instrument;    ///< Names or files; empty: as in the settings.
    std::vector<std::string> notes;   ///< NOTE or NOTE:VELOCITY
    std::vector<double> times;        ///< s, of the notes in their order.
    std::string following;            ///< As readFollowing reads it; empty: as in the settings.
    int sensorInput = 0;              ///< From 1; 0: as in the settings, the first one where a sensor is wanted.
    std::string midiFile, settings;   ///< Files; empty: none, the usual one.
    bool playsTouch = false;          ///< Antinode Touch in place of foci.
    std::string touch;                ///< Its device; empty: as in the settings.
    std::vector<std::string> fingers; ///< X:Y or X:Y:LEVEL, mm and um.
    std::string inputs;               ///< A list as readFingerInputs reads it; empty: as in the settings.
    int touchLatency = 0;             ///< ms; 0: as in the settings.
    std::optional<int> oscPort, tuioPort;
    std::optional<std::string> touchAddress, tuioCursors;
    std::vector<std::string> senders; ///< IPv4, of commands from other computers.
    bool allowsRemoteArm = false;
    std::optional<int> markerOutput; ///< From 1; 0: none.
    std::optional<double> markerLevel, markerMilliseconds;
    double duration = 0; ///< s; 0: until it is interrupted.
};

/** Adds them to the program. The struct must live as long as the app. [worker] */
void addStandaloneOptions (CLI::App&, StandaloneOptions&);

/** The settings with what the options say in place of what they keep: device, rate, inputs, ports.
    @throws InputError  as readFollowing [any] */
StandaloneSettings withOptions (StandaloneSettings, const StandaloneOptions&);

/** The file that the options mean. [any] */
SettingsFile chooseSettingsFile (const StandaloneOptions&);

/** Loads the focus and the instrument of the options, opens the graph and tracks where they ask for it.
    @throws InputError  where one cannot be read [message thread] */
void loadDocuments (StandaloneHost&, const StandaloneOptions&);

/** Loads the device of the options, and puts their fingers and inputs in place of those of the settings.
    @throws InputError  where the device cannot be read, or a finger or the inputs are none [message thread] */
void loadFingers (TouchHost&, const StandaloneOptions&);

/** What listens, as an option says it: "velocity:X:Y" or "displacement:X:Y", mm, "ceramic_current:N" or
    "ceramic_charge:N", N from 1, or "none".
    @throws InputError  where it is none of these [any] */
FollowingSettings readFollowing (const std::string&);

/** From a list "1,2,5" that counts from 1, 0 for none, and leaves out the last fingers, which then have none.
    @throws InputError  where it is no such list [any] */
FingerInputs readFingerInputs (const std::string& list);

/** A finger of an option: "X:Y" or "X:Y:LEVEL", mm and um.
    @throws InputError  where it is none [any] */
WantedFinger readFinger (const std::string&);

/** The notes of the options and of their MIDI file.
    @throws InputError  where one is none, or the file is none [worker] */
std::vector<TimedNote> readNotes (const StandaloneOptions&);
} // namespace antinode
