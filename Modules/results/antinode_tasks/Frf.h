#pragma once

#include "Field.h"
#include "RecordedSignals.h"

#include <antinode_base/Progress.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_measurement/SurfaceMeasurement.h>
#include <antinode_reports/Report.h>
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

inline constexpr TaskText frfText { "frf", "Computes frequency responses from recordings of an excitation or a hammer",
                                    "Docs/Theory.md, sections 8.9 and 8.11" };

/** Recordings, and what their channels are. */
struct FrfRequest
{
    std::vector<std::filesystem::path> files; ///< Without a sheet of their own: the first may be the sheet.
    std::optional<ExcitationSheet> sheet;
    std::filesystem::path pointsFile; ///< Places; empty: 1 mm apart on a line, or as files of a hammer say.
    std::string estimator = "h1";
    SensorScale sensor;
    int syncChannel = -1;          ///< Counted from 1; 0: none, -1: the last one.
    int referenceChannel = 0;      ///< Counted from 1; 0: none.
    double referenceFullScale = 1; ///< V
    double latency = 0;            ///< s
    HammerRequest hammer;
};

/** Those of all recordings, of an excitation only, and of a hammer only. [any] */
struct FrfFields
{
    std::vector<Field> common, ofExcitation, ofHammer;
};

FrfFields fieldsByKind (FrfRequest&);
std::vector<Field> fields (FrfRequest&);

/** Whether the first file is the sheet of an excitation, or there is one. [any] */
bool isOfExcitation (const FrfRequest&);

/** Frequency responses of recordings: of an excitation with its sheet, or of a hammer. */
struct RecordedResponses
{
    FrequencyResponses responses;
    std::vector<Eigen::MatrixXd> coherence; ///< N_b of N_f x N_p
    std::optional<SurfaceMeasurement> surface;
    std::optional<ExcitationSheet> sheet;
    std::optional<HammerMeasurement> hammer;
    std::vector<std::string> warnings; ///< Of the quality, and what was assumed.
    std::string orderRemark;           ///< Where files are read in another order than given; else empty.
};

/** @throws InputError  for files that cannot be read or do not fit the excitation, and without a sensitivity [worker]
 */
RecordedResponses frf (const FrfRequest&, const ShowProgress&);

/** The universal file. [worker] Docs/FileFormats.md. */
std::string universalFile (const RecordedResponses&);

/** [worker] */
ReportPage frfReport (const RecordedResponses&);
} // namespace antinode
