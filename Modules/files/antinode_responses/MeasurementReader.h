#pragma once

#include "CsvHeading.h"
#include "CsvResponses.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace antinode
{
/** Frequency responses of a file of any kind that is read: universal file, MATLAB, WAV (an impulse response a channel),
   else a table of text. What it is its bytes say, not its name; names as in point3_driver2.csv tell point and reference
   where the file does not.
    @param source     how errors and remarks name the file, without folders
    @param variables  of a MATLAB file those to read; empty: as measurementFromMatlab chooses
    @throws InputError  source, place, what is wrong
    [worker] Docs/FileFormats.md. */
MeasurementFile decodeMeasurement (std::string_view bytes, const std::string& source, CsvForm,
                                   const std::vector<std::string>& variables = {});

/** The same of a file of at most 4 GiB. @throws InputError  also when it cannot be read [worker] */
MeasurementFile readMeasurement (const std::filesystem::path&, CsvForm, const std::vector<std::string>& variables = {});

/** The kind of a file of measured data. */
enum class MeasurementForm
{
    wave,
    matlab,
    universal,
    text
};

/** What its bytes say, not its name. [any] */
MeasurementForm measurementForm (std::string_view bytes);

/** Point and reference from a file's name, where it has words for them: "point3_driver2.csv", "P3-C1.wav". [any] */
CsvHeading rolesInFileName (const std::string& source);
} // namespace antinode
