#pragma once

#include "DrawnDevices.h"
#include "TracksAt.h"

#include <antinode_base/Progress.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_reports/ComparisonReport.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
inline constexpr TaskText compareText { "compare",
                                        "Compares devices by what focuses or waveforms need and give on them",
                                        "Docs/Theory.md, sections 4.13, 5.1, 6.8 and 7.4" };

/** Devices, and what is played on each. */
struct CompareRequest
{
    std::vector<DeviceDescription> devices;
    std::vector<FocusDescription> focuses;
    std::optional<WaveformsDescription> waveforms; ///< At these places:
    TracksAt at;
    DrawnDevices drawn;
    std::vector<std::string> figures; ///< "svg", "pdf": those of the report for print.
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (CompareRequest&);

/** Devices side by side. */
struct ComparedDevices
{
    std::vector<ComparedCase> cases;  ///< Device by device.
    std::string scores;               ///< All numbers of each case: scores.csv.
    std::vector<std::string> figures; ///< As of the request.
};

/** Plays focuses as antinode render and waveforms as antinode perform, both also on drawn devices. What one case cannot
    do does not stop the others.
    @throws InputError  without a device, or without anything to play
    @throws Cancelled   when a watch of this thread says no
    [worker, on all cores] */
ComparedDevices compare (const CompareRequest&, const ShowProgress&);

/** Writes report.html, the same for print as compare.pdf, its figures where they are wanted, and scores.csv. @throws
   InputError  when they cannot be written [worker] Docs/FileFormats.md. */
void writeCompared (const std::filesystem::path&, const ComparedDevices&);
} // namespace antinode
