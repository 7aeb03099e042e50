#pragma once

#include <antinode_learning/DriftTrace.h>
#include <antinode_reports/Report.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace antinode
{
/** Writes how a device drifted and what it is in the end: drift.csv, device.json, summary.json and report.html.
    @param nominal  as it was before, with modes beyond its own
    @param known    how many are its own: the files have these
    @throws InputError  when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeDrift (const std::filesystem::path& folder, const ModalModel& nominal, Eigen::Index known, const DriftTrace&);

/** summary.json of a drift. [any] Docs/FileFormats.md. */
nlohmann::ordered_json driftToJson (const DriftTrace&);

/** report.html of a drift: the frequencies over time. Arguments as writeDrift. [worker] */
ReportPage driftReport (const ModalModel& nominal, Eigen::Index known, const DriftTrace&);

/** The file of the device as it is in the end. Arguments as writeDrift. [worker] Docs/FileFormats.md. */
std::string driftedDeviceText (const ModalModel& nominal, Eigen::Index known, const DriftTrace&);

/** A moment's state in a word, for files and the terminal. [any] */
const char* driftStateWord (DriftState);
} // namespace antinode
