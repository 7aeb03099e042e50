#include "Commands.h"
#include "IdentifyOptions.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/IdentifiedDevice.h>
#include <antinode_documents/UniversalModes.h>
#include <antinode_identification/IdentifiedModel.h>
#include <antinode_library/Inputs.h>
#include <antinode_reports/IdentificationDiagram.h>
#include <antinode_reports/IdentificationReport.h>
#include <antinode_reports/IdentificationTables.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_universal/UniversalFile.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace antinode
{
namespace
{
Measurement readFiles (const IdentifyOptions& options)
{
    const auto said = toMeasurementOptions (options);
    std::vector<MeasurementFile> files;

    for (const auto& file : options.files)
        files.push_back (readMeasurement (file, toCsvForm (options)));

    return mergedResponses (files, said);
}

/** The device with these modes. Forces in N become voltages in V, since a device has no other excitation. */
ModalModel makeDevice (IdentifiedModes modes, const IdentifyOptions& options, const Eigen::VectorXd& masses,
                       const std::optional<ModalModel>& computed, std::vector<std::string>& remarks)
{
    if (modes.drive == DriveQuantity::force)
        remarks.emplace_back ("Forces excite the surface: in the device 1 V stands for 1 N.");

    modes.drive = DriveQuantity::voltage;
    MappedSurface surface;
    surface.name = options.name;
    surface.masses = masses;
    surface.voltageLimit = options.voltageLimit;
    surface.fullScaleVoltage =
        options.fullScaleVoltage.value_or (computed ? computed->fullScaleVoltage : options.voltageLimit);

    if (computed && computed->ceramics.size() == modes.references.size())
        surface.ceramics = computed->ceramics;

    auto model = toModalModel (modes, surface);

    if (! model.frequencyErrors.allFinite()) // Useless to readers of the device.
        model.frequencyErrors.resize (0);

    return model;
}

IdentificationResult identifyFiles (const IdentifyOptions& options)
{
    Progress progress (options.isQuiet);
    progress.show ("Reading", 0);
    auto measurement = readFiles (options);
    const auto search = toIdentificationOptions (options, measurement.responses.points.rows());
    IdentificationResult result;

    if (! options.against.empty())
        result.computed = solveDevice (loadDevice (options.against, {}), std::nullopt, options.usesCache);

    progress.show ("Identifying", 0.1);
    const RecordEffects effects { measurement.recordLength, options.windowDecay.value_or (measurement.windowDecay) };
    measurement.responses = withModalNumerators (std::move (measurement.responses), effects);
    result.modes = withoutRecordEffects (identify (measurement.responses, search), effects);
    result.remarks = std::move (measurement.remarks);
    result.model = makeDevice (result.modes, options, search.pointMasses, result.computed, result.remarks);

    if (result.computed)
        result.comparison = compareModes (result.modes, *result.computed);

    result.measured = std::move (measurement.responses);
    result.pointNames = std::move (measurement.pointNames);
    return result;
}

/** In dB; also that of the measured quantity where it is not a velocity, and of the modes alone, which are all that a
    device has, where residual terms make a difference. */
std::string reconstructionError (const IdentificationResult& result)
{
    const auto& modes = result.modes;
    auto text = fixedText (modes.reconstructionError, 1) + " dB";

    if (result.measured.integrations != 0 && modes.measuredReconstructionError != modes.reconstructionError)
        text += " (" + fixedText (modes.measuredReconstructionError, 1) + " dB of the measured quantity)";

    if (modes.modalReconstructionError > modes.reconstructionError + 0.1)
        text += ", " + fixedText (modes.modalReconstructionError, 1) + " dB by the modes alone, as in the device";

    return text;
}

std::string describeResult (const IdentificationResult& result)
{
    return "Identified from " + std::to_string (result.measured.points.rows()) + " points and "
           + std::to_string (result.measured.references.size()) + " references, "
           + fixedText (result.modes.minimumFrequency, 1) + " to " + fixedText (result.modes.maximumFrequency, 1)
           + " Hz, reconstruction error " + reconstructionError (result);
}

std::string reportName (const IdentifyOptions& options)
{
    if (! options.reportFile.empty())
        return options.reportFile;

    return std::filesystem::path (options.deviceFile.empty() ? options.name : options.deviceFile)
        .replace_extension (".html")
        .string();
}

/** plate.html has plate-diagram.html beside it. */
std::string diagramName (std::filesystem::path report)
{
    return report.replace_filename (report.stem().string() + "-diagram.html").string();
}

std::string fileNameOf (const std::filesystem::path& path)
{
    return path.filename().string();
}

/** All are computed before the first is written. */
void writeFiles (const IdentificationResult& result, const IdentifyOptions& options, bool hasReport)
{
    std::vector<std::pair<std::string, std::string>> files;

    if (hasReport)
    {
        const auto report = reportName (options), diagram = diagramName (report);
        files.emplace_back (report, renderReport (identificationReport (result, fileNameOf (diagram))));
        files.emplace_back (diagram, identificationDiagram (result, fileNameOf (report)));
    }

    if (! options.universalFile.empty())
        files.emplace_back (options.universalFile, encodeUniversalFile (modeSets (result.model)));

    if (! options.transferFile.empty())
        files.emplace_back (options.transferFile,
                            modalDeviceToJson (transferred (*result.computed, result.modes, *result.comparison),
                                               "Computed, with measured frequencies and damping ratios")
                                    .dump (2)
                                + "\n");

    if (! options.deviceFile.empty())
        files.emplace_back (options.deviceFile,
                            identifiedDeviceToJson (result.model, result.modes, describeResult (result)).dump (2)
                                + "\n");

    for (const auto& [name, content] : files)
        writeWholeFile (name, content);
}

void print (const IdentificationResult& result)
{
    const auto& modes = result.modes;
    std::printf ("%s: %td modes from %.1f to %.1f Hz, reconstruction error %s, delay %s us\n%s",
                 result.model.name.c_str(), modes.modes(), modes.minimumFrequency, modes.maximumFrequency,
                 reconstructionError (result).c_str(), delayInWords (modes).c_str(),
                 tableText (modeTable (result)).c_str());

    if (! modes.kindReason.empty())
        std::printf ("%s\n", modes.kindReason.c_str());

    if (result.comparison)
        std::printf ("\n%s", tableText (pairTable (result)).c_str());

    for (const auto& warning : collectWarnings (result))
        std::printf ("Warning: %s\n", warning.c_str());
}

void runIdentify (const IdentifyOptions& options, bool hasReport)
{
    if (! options.transferFile.empty() && options.against.empty())
        throw InputError ("--transfer", "needs a computed device; allowed only with --against DEVICE");

    const auto result = identifyFiles (options);
    writeFiles (result, options, hasReport);

    if (! options.isQuiet)
        print (result);
}
} // namespace

void addIdentifyCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("identify", "Finds the modes in measured frequency responses; writes a device file");
    auto options = std::make_shared<IdentifyOptions>();
    addIdentifyOptions (*command, *options);
    command->callback ([options, command] { runIdentify (*options, command->count ("--report") > 0); });
}
} // namespace antinode
