#pragma once

#include <antinode_identification/Identification.h>
#include <antinode_identification/RecordEffects.h>
#include <antinode_responses/MeasurementReader.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** The options of `antinode identify`. */
struct IdentifyOptions
{
    std::vector<std::string> files;
    std::string name = "identified";
    std::string deviceFile, reportFile, universalFile, transferFile; ///< Not written where empty.
    std::string against;                                             ///< A computed device; none if empty.
    std::string outline;            ///< Where the surface ends; empty: as that of the computed device.
    std::vector<std::string> bands; ///< "300:4000"
    std::string orders;             ///< "3:18"
    bool isComplex = false, isReal = false, isGramSchmidt = false, usesPeaks = false, usesCache = true, isQuiet = false;
    std::vector<double> selected, rejected; ///< Hz
    std::optional<double> delay;            ///< us
    std::string form, quantity, responseUnit, drive, driveUnit, pointsFile;
    std::vector<std::string> references, variables;
    std::optional<double> mass;        ///< kg
    std::optional<double> windowDecay; ///< 1/s; none: as the files say
    double voltageLimit = 150;
    std::optional<double> fullScaleVoltage; ///< None: that of the computed device, else the voltage limit.
};

/** Adds them to the sub-command. The struct must live as long as the app. */
void addIdentifyOptions (CLI::App&, IdentifyOptions&);

/** The form of tables without headings. @throws InputError  for an unknown word [any] */
CsvForm toCsvForm (const IdentifyOptions&);

/** Statements about responses: units, references, positions from a file. @throws InputError  for unreadable options
    [worker] */
MeasurementOptions toMeasurementOptions (const IdentifyOptions&);

/** How modes are searched in responses of so many points. @throws InputError  for invalid ranges [any] */
IdentificationOptions toIdentificationOptions (const IdentifyOptions&, Eigen::Index points);
} // namespace antinode
