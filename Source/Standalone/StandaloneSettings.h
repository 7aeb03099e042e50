#pragma once

#include "OutputRouter.h"

#include <antinode_audio/AudioChoice.h>
#include <antinode_measurement/RunAnalysis.h>
#include <antinode_session/SessionState.h>
#include <antinode_touch/TouchReceiver.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** The input of the audio device that each finger of Antinode Touch feels, counted from 0. Several may feel one. Where
    foci are played, the first finger stands for the sensor. */
struct FingerInputs
{
    static constexpr int none = -1, firstOpen = -2, fingers = 8;

    std::array<int, fingers> inputs { 0, 1, 2, 3, 4, 5, 6, 7 }; ///< Of each finger, or one of the two above.
    int sensor = none;                                          ///< Of what tracks the device.

    bool operator== (const FingerInputs&) const = default;
};

/** The sensor hears the first input that is open, fingers feel nothing. [any] */
inline FingerInputs sensorAlone()
{
    FingerInputs sensor;
    sensor.inputs.fill (FingerInputs::none);
    sensor.inputs.front() = FingerInputs::firstOpen;
    return sensor;
}

/** What the sensor of a bench is wired to. */
struct BenchSensor
{
    int input = 0;     ///< Of the audio device, counted from 0.
    int syncInput = 1; ///< The input that hears the output of the marker; below 0: none.
    SensorScale scale;

    bool operator== (const BenchSensor& other) const
    {
        return input == other.input && syncInput == other.syncInput && scale.sensitivity == other.scale.sensitivity
               && scale.inputFullScale == other.scale.inputFullScale;
    }
};

/** The selected MIDI inputs. */
struct MidiChoice
{
    bool all = true;                 ///< Including inputs plugged in later.
    std::vector<std::string> inputs; ///< By identifier, where not all.

    bool operator== (const MidiChoice&) const = default;
};

/** All that the standalone program keeps from one time to the next. */
struct StandaloneSettings
{
    AudioChoice audio;
    OutputRouting routing = straightRouting();
    MidiChoice midi;
    TouchPorts touch;
    bool isDark = true;                ///< Else the window is light.
    double scale = 0;                  ///< Of what the window shows; 0: as large as suits it.
    std::optional<SessionState> state; ///< Device, focus and parameters; none: the demonstrator.
    FingerInputs inputs;               ///< Of Antinode Touch, as the next line.
    std::optional<SessionState> touchState;
    BenchSensor bench;
};

/** JSON of schema antinode.standalone/1; numbers come back to the bit. [worker] Docs/FileFormats.md */
std::string settingsToText (const StandaloneSettings&);

/** @throws InputError  where the text is no settings, or those of a version that this program does not know [worker] */
StandaloneSettings readSettings (std::string_view text);

/** $XDG_CONFIG_HOME/antinode/standalone.json, else that in $HOME/.config; empty if neither is set. [any] */
std::filesystem::path usualSettingsFile();

/** The settings file. A file that cannot be read is renamed, never overwritten. */
class SettingsFile
{
public:
    /** @param fileToUse  empty: nothing is read or written [any] */
    explicit SettingsFile (std::filesystem::path fileToUse) : file (std::move (fileToUse)) {}

    /** The saved settings, or the defaults; warning() says where a broken file was moved. [worker] */
    StandaloneSettings load();

    /** Replaces the file in one step, where anything is different.
        @throws InputError  when it cannot be written [worker] */
    void save (const StandaloneSettings&);

    /** The warning of loading, as a sentence, or empty. [worker] */
    const std::string& warning() const { return loadWarning; }

private:
    void putAside (const std::string& reason);

    std::filesystem::path file;
    std::string written, loadWarning;
};
} // namespace antinode
