#pragma once

#include <antinode_reports/MeasurementReport.h>
#include <antinode_responses/HammerMeasurement.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The options of frf for recordings of a hammer. */
struct HammerRecordingOptions
{
    std::vector<std::string> channels;
    std::string quantity, responseUnit, forceUnit, hitPoint;
    double responseScale = 1, forceScale = 1;
    double trigger = 10;                      // % of the largest force
    std::optional<double> block, windowDecay; // s, 1/s
    std::optional<double> lowest, highest;    // Hz
    std::vector<const CLI::Option*> options;  // All of these, in order to refuse them elsewhere.
};

/** Adds them to a sub-command. The struct must live as long as the app. */
void addHammerRecordingOptions (CLI::App&, HammerRecordingOptions&);

/** Frequency responses of recordings, whose hits are found and checked.
    @param pointsFile  places of the points; empty: as the files say
    @throws InputError  where a file or an option is not usable, or no hit is left
    [worker] Docs/Theory.md, section 8.11. */
HammerMeasurement measureHammerFiles (const std::vector<std::string>& files, const std::string& pointsFile,
                                      ResponseEstimator, const HammerRecordingOptions&);

/** MeasurementReport.h [worker] */
ReportPage hammerReport (const HammerMeasurement&);

/** Tells the terminal what was measured, and which hits were left out and why. */
void printHammer (const HammerMeasurement&);
} // namespace antinode
