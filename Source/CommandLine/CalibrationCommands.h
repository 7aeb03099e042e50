#pragma once

#include <antinode_bench/MeasureAmplifiers.h>
#include <antinode_measurement/Hysteresis.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>
#include <string>
#include <vector>

namespace antinode
{
/** Writes what was measured of the amplifiers of a device: device.json with them in front of its ceramics,
   calibration.json and report.html.
    @throws InputError  when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeCalibration (const std::filesystem::path& folder, const DeviceDescription&, const ModalModel&,
                       const AmplifierMeasurement&);

/** The same as a table on the terminal. */
void printCalibration (const std::string& folder, const ModalModel&, const AmplifierMeasurement&);

/** Responses at two levels, and the level that foci will play; V, peak. */
struct HysteresisFiles
{
    std::vector<std::string> low, high;
    double lowLevel = 0, highLevel = 0, playedLevel = 0;
};

/** What they say: N_b each. */
struct HysteresisMeasurement
{
    DeviceDescription device;
    ModalModel before; ///< As it was said to be.
    ModalModel model;  ///< As it answers at the played level.
    std::vector<MeasuredHysteresis> ceramics;
    Eigen::VectorXd playedLevels; ///< Of each ceramic's limit.
};

/** Hysteresis of the ceramics of a device; full level is the voltage limit of each.
    @throws InputError  as readMeasurement and fitHysteresis, where the files have other lines, points or ceramics, and
                        for a played level above a limit
    [worker] Docs/Theory.md, section 7.9. */
HysteresisMeasurement hysteresisByFiles (const DeviceDescription&, const HysteresisFiles&, bool usesCache);

/** Writes device.json and hysteresis.json. [worker] Docs/FileFormats.md. */
void writeHysteresis (const std::filesystem::path& folder, const HysteresisMeasurement&);

/** The same as a table on the terminal. */
void printHysteresis (const std::string& folder, const HysteresisMeasurement&);
} // namespace antinode
