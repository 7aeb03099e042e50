#pragma once

#include <antinode_sweep/SweepTable.h>

#include <filesystem>

namespace antinode
{
/** Writes the results of a sweep into a folder, which is made where it is missing: results.csv, results.mat,
   report.html, summary.json.
    @throws InputError  when it cannot be written
    [worker] Docs/FileFormats.md. */
void writeSwept (const std::filesystem::path&, const SweepTable&, const SweepSummary&);
} // namespace antinode
