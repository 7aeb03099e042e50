#pragma once

#include "Field.h"
#include "RecordedSignals.h"

#include <antinode_base/Progress.h>
#include <antinode_learning/FollowDrift.h>
#include <antinode_reports/Report.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
inline constexpr TaskText followText { "follow", "Follows the drift of a device from a recording of any playback",
                                       "Docs/Theory.md, section 7.7" };

/** What was recorded, by which sensors, and how far and how quickly the device may be off. */
struct FollowRequest
{
    DeviceDescription device;                          ///< As it was before the drift.
    std::filesystem::path recorded;                    ///< A folder; empty: the two arrays below were.
    std::optional<Eigen::MatrixXd> voltages, signals;  ///< N_b x N_s, V; sensors x N_s.
    std::optional<double> sampleRate;                  ///< Of both, Hz.
    SensorScale sensor;                                ///< Of recorded.wav.
    Eigen::MatrixX2d places = Eigen::MatrixX2d (0, 2); ///< Of the velocity sensors, m.
    int idleCeramic = 0;                               ///< Whose current is heard, counted from 1; 0: none.
    double latency = 0, signalToNoise = 40;            ///< s, dB
    double window = 1, memory = 0.3;                   ///< s
    double largestJump = 0.02;                         ///< Of all frequencies.
    double drift = 0.005, scatter = 0.001, damping = 0.1, gain = 0.05; ///< Standard deviations.
    std::optional<double> feedthrough; ///< The sensor's unit per V/s; none: as much as of modes.
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (FollowRequest&);

/** A drift, and what it is a drift of. */
struct FollowedDevice
{
    DeviceDescription device;
    ModalModel nominal;     ///< As it was before, with modes beyond its own.
    Eigen::Index known = 0; ///< How many are its own.
    DriftTrace trace;
};

/** How the modes of a device drifted while something was played on it and recorded.
    @param progress  may be empty
    @throws InputError  as followRecording, where there is no sensor, and for recordings that do not fit the device
    [worker] */
FollowedDevice follow (const FollowRequest&, const ShowProgress& progress);

/** Writes how a device drifted and what it is in the end: drift.csv, device.json, summary.json and report.html.
    @throws InputError  when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeDrift (const std::filesystem::path& folder, const FollowedDevice&);

/** summary.json of a drift. [any] Docs/FileFormats.md. */
nlohmann::ordered_json driftToJson (const DriftTrace&);

/** report.html of a drift: the frequencies over time. [worker] */
ReportPage driftReport (const FollowedDevice&);

/** The file of the device as it is in the end. [worker] Docs/FileFormats.md. */
std::string driftedDeviceText (const FollowedDevice&);

/** A moment's state in a word, for files and the terminal. [any] */
const char* driftStateWord (DriftState);
} // namespace antinode
