#pragma once

#include <antinode_bench/MeasureAmplifiers.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>
#include <string>

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
} // namespace antinode
