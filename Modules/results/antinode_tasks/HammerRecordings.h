#pragma once

#include "Field.h"

#include <antinode_responses/HammerMeasurement.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** Recordings of a hammer: what their channels are, and which hits count. */
struct HammerRequest
{
    std::vector<std::string> channels;
    std::optional<std::string> quantity;
    std::string responseUnit, forceUnit, hitPoint;
    double responseScale = 1, forceScale = 1;
    double trigger = 0.1;                     ///< Of the largest force.
    std::optional<double> block, windowDecay; ///< s, 1/s
    std::optional<double> lowest, highest;    ///< Hz
};

/** [any] */
std::vector<Field> fields (HammerRequest&);

/** Frequency responses of recordings, whose hits are found and checked.
    @param pointsFile  places of the points; empty: as the files say
    @throws InputError  where a file or an option is not usable, or no hit is left
    [worker] Docs/Theory.md, section 8.11. */
HammerMeasurement measureHammerFiles (const std::vector<std::string>& files, const std::string& pointsFile,
                                      ResponseEstimator, const HammerRequest&);
} // namespace antinode
