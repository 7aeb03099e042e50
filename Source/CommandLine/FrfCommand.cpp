#include "Commands.h"
#include "EstimatedFiles.h"
#include "HammerRecordings.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/ExcitationFolder.h>
#include <antinode_reports/MeasurementReport.h>
#include <antinode_text/NaturalOrder.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_universal/UniversalFile.h>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct FrfOptions
{
    std::vector<std::string> files;
    std::string outputFile, reportFolder, estimator = "h1";
    RecordingOptions recordings; // The files after the sheet.
    HammerRecordingOptions hammer;
};

void refuse (const std::vector<const CLI::Option*>& options, const std::string& wrong)
{
    for (const auto* const option : options)
        if (option->count() > 0)
            throw InputError (option->get_name(), wrong);
}

void writeReport (const std::string& folderName, const ReportPage& page)
{
    if (folderName.empty())
        return;

    OutputFolder folder (folderName);
    folder.write ("report.html", renderReport (page));
    folder.commit();
}

void estimateFromHammer (const FrfOptions& options)
{
    const auto measurement = measureHammerFiles (options.files, options.recordings.pointsFile,
                                                 estimatorNamed (options.estimator), options.hammer);
    writeReport (options.reportFolder, hammerReport (measurement));
    writeWholeFile (options.outputFile, encodeUniversalFile (hammerSets (measurement)));
    printHammer (measurement);
    std::printf ("Responses: %s\n", options.outputFile.c_str());
}

void estimateFromExcitation (const FrfOptions& options)
{
    auto recordings = options.recordings;
    const std::vector<std::string> given (options.files.begin() + 1, options.files.end());
    recordings.files = inNaturalOrder (given);
    recordings.estimator = estimatorNamed (options.estimator);
    const auto sheet = readSheet (options.files.front());
    const auto measurement = estimateResponses (sheet, recordings);

    writeReport (options.reportFolder, measurementReport (measurement, sheet));
    writeWholeFile (options.outputFile, measurementText (measurement));
    printMeasurement (measurement, sheet);

    if (const auto remark = orderRemark (given, recordings.files); ! remark.empty())
        std::printf ("%s\n", remark.c_str());
}

/** With a sheet first: of an excitation; else of a hammer. */
void estimate (const FrfOptions& options, const std::vector<const CLI::Option*>& ofExcitation)
{
    const auto isOfExcitation = options.files.front().ends_with (".json");
    refuse (isOfExcitation ? options.hammer.options : ofExcitation,
            isOfExcitation ? "belongs to recordings of a hammer, which are given without a sheet"
                           : "belongs to an excitation, whose sheet excitation.json is then the first file");
    isOfExcitation ? estimateFromExcitation (options) : estimateFromHammer (options);
}
} // namespace

void addFrfCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("frf", "Computes frequency responses from recordings of an excitation or a hammer");
    auto options = std::make_shared<FrfOptions>();
    auto& recordings = options->recordings;
    command
        ->add_option (
            "files", options->files,
            "Sheet of the excitation (excitation.json) and WAV files, each of one or more points, in the order "
            "of the points; or recordings of a hammer alone")
        ->required();
    command->add_option ("--out", options->outputFile, "Universal file to write")->required()->type_name ("FILE");
    command
        ->add_option ("--points", recordings.pointsFile,
                      "CSV of the points, x and y in mm; default: 1 mm apart on a line")
        ->type_name ("FILE");
    addSensorOptions (*command, recordings.sensor);
    command->add_option ("--sync-channel", recordings.syncChannel,
                         "Channel with the sync output, counted from 1; 0: none; default: the last channel");
    command
        ->add_option ("--reference-channel", recordings.referenceChannel,
                      "Channel with the measured voltage of the amplifiers, counted from 1")
        ->check (CLI::Range (1, 16383));
    command
        ->add_option ("--reference-full-scale", recordings.referenceFullScale,
                      "Voltage at the ceramics for a reference sample of 1, V")
        ->capture_default_str();
    command->add_option ("--latency-ms", recordings.latency, "Latency of the sensors without a sync channel, ms")
        ->check (CLI::Range (0.0, 200.0))
        ->capture_default_str();
    command->add_option ("--estimator", options->estimator, "Estimator for noise: h1, h2 or their geometric mean hv")
        ->check (CLI::IsMember ({ "h1", "h2", "hv" }))
        ->capture_default_str();
    command->add_option ("--report", options->reportFolder, "Writes a report with figures into a folder")
        ->type_name ("DIR");
    std::vector<const CLI::Option*> ofExcitation;

    for (const auto* const name : { "--sensitivity-mm-s-per-v", "--input-full-scale-v", "--sync-channel",
                                    "--reference-channel", "--reference-full-scale", "--latency-ms" })
        ofExcitation.push_back (command->get_option (name));

    addHammerRecordingOptions (*command, options->hammer);
    command->callback ([options, ofExcitation] { estimate (*options, ofExcitation); });
}
} // namespace antinode
