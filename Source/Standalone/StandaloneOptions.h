#pragma once

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
    double duration = 0; ///< s; 0: until it is interrupted.
};

/** Adds them to the program. The struct must live as long as the app. [worker] */
void addStandaloneOptions (CLI::App&, StandaloneOptions&);
} // namespace antinode
