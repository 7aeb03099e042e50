#pragma once

#include "Follow.h"

#include <antinode_reports/Report.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace antinode
{
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
