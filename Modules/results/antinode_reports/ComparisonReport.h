#pragma once

#include "Report.h"

#include <limits>
#include <string>
#include <vector>

namespace antinode
{
/** What one device makes of a focus or of waveforms, for those who choose among devices. NaN: unknown. */
struct ComparedCase
{
    static constexpr auto unknown = std::numeric_limits<double>::quiet_NaN();

    std::string device, played; ///< Names.
    Eigen::Index ceramics = 0;
    double peakVoltage = unknown, voltageLimit = unknown; ///< V
    double peakCurrent = unknown;                         ///< A, of all ceramics.
    double energy = unknown;                              ///< J, of one play.
    std::vector<double> levels;                           ///< dB over threshold, of each target or finger with a track.
    double missing = 0;                                   ///< dB by which the limits lower the levels.
    double contrast = unknown;                            ///< dB from the weakest of them to the strongest other place.
    std::string tolerance;                                ///< What remains on devices that deviate.
    std::string error;                                    ///< Why there are no numbers, or empty.
};

/** A row per device and what is played. [any] */
ReportTable comparisonTable (const std::vector<ComparedCase>&);

/** A page of this table and figures. [any] */
ReportPage comparisonReport (const std::vector<ComparedCase>&);
} // namespace antinode
