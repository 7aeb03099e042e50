#include "IdentifyFiles.h"

#include "BoundaryOption.h"

#include <antinode_base/NumberText.h>
#include <antinode_documents/ChangedDevice.h>
#include <antinode_documents/IdentifiedDevice.h>
#include <antinode_documents/UniversalModes.h>
#include <antinode_identification/IdentifiedModel.h>
#include <antinode_identification/MeasuredQuantity.h>
#include <antinode_library/Inputs.h>
#include <antinode_library/Library.h>
#include <antinode_model/BoundedSurface.h>
#include <antinode_reports/IdentificationDiagram.h>
#include <antinode_text/NaturalOrder.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_universal/UniversalFile.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
Measurement readFiles (const IdentifyOptions& options)
{
    const auto said = toMeasurementOptions (options);
    const auto names = inNaturalOrder (options.files);
    std::vector<MeasurementFile> files;
    files.reserve (names.size());

    for (const auto& name : names)
        files.push_back (readMeasurement (name, toCsvForm (options), options.variables));

    auto measurement = mergedResponses (files, said);

    if (const auto remark = orderRemark (options.files, names); ! remark.empty())
        measurement.remarks.push_back (remark);

    return measurement;
}

/** The mass of a drawn plate, evenly, where nobody says the measured one; empty where there is none. */
Eigen::VectorXd massesOfDrawing (const ModalModel& drawn, Measurement& measurement)
{
    const auto& surface = drawn.surface;

    if (drawn.origin.source != ModeSource::drawn || surface.kind != SurfaceKind::plate || ! drawn.coversWholeBody)
        return {};

    const auto points = measurement.responses.points.rows();
    const auto mass = surface.masses.sum();
    measurement.remarks.push_back ("Shapes have the size that the mass of the drawing, " + inWords (1000 * mass)
                                   + " g, gives them; --mass-kg says another one.");
    return Eigen::VectorXd::Constant (points, mass / static_cast<double> (points));
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
    surface.boundary = boundaryFrom (options.outline);

    if (! surface.boundary && computed && (computed->surface.boundary || computed->surface.grid))
        surface.boundary = boundaryOf (computed->surface);

    surface.voltageLimit = options.voltageLimit;
    surface.fullScaleVoltage =
        options.fullScaleVoltage.value_or (computed ? computed->fullScaleVoltage : options.voltageLimit);

    if (computed && computed->ceramics.size() == modes.references.size())
    {
        surface.ceramics = computed->ceramics;

        for (auto& ceramic : surface.ceramics)
            ceramic.lag = {}; // What was measured has them in its phases.
    }

    auto model = toModalModel (modes, surface);

    if (! surface.boundary && model.surface.kind == SurfaceKind::plate)
        remarks.emplace_back ("The surface ends at the outermost points, since nothing says where its edges are: "
                              "--outline does.");

    if (! model.origin.scaleIsKnown)
        remarks.emplace_back ("The size of shapes is a convention: fingers and power need --mass-kg.");

    if (! model.frequencyErrors.allFinite()) // Useless to readers of the device.
        model.frequencyErrors.resize (0);

    return model;
}

std::string describeResult (const IdentificationResult& result)
{
    return "Identified from " + std::to_string (result.measured.points.rows()) + " points and "
           + std::to_string (result.measured.references.size()) + " references, "
           + inWords (result.modes.minimumFrequency) + " to " + inWords (result.modes.maximumFrequency)
           + " Hz, reconstruction error " + reconstructionError (result);
}

/** Those of the device that was measured; where it has other ceramics, whether it has to be armed. */
nlohmann::ordered_json limitsOf (const IdentificationResult& result)
{
    auto limits = result.described ? limitsInFile (*result.described) : nlohmann::ordered_json();

    if (limits.is_null() || result.computed->ceramics.size() == result.model.ceramics.size())
        return limits;

    return { { "voltage_V", voltageLimits (result.model).maxCoeff() },
             { "requires_arming", limits.value ("requires_arming", false) } };
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
} // namespace

IdentificationResult identifyFiles (const IdentifyOptions& options, const std::optional<DeviceDescription>& against,
                                    const ShowProgress& progress)
{
    const auto show = [&] (const std::string& what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Reading", 0);
    auto measurement = readFiles (options);
    auto search = toIdentificationOptions (options, measurement.responses.points.rows());
    IdentificationResult result;
    result.described = against || options.outline.empty() || isDrawingFile (options.outline)
                           ? against
                           : std::optional (loadDevice (options.outline, {}));

    if (result.described)
    {
        result.computed = solveDevice (*result.described, std::nullopt, options.usesCache);

        if (! options.mass)
            search.pointMasses = massesOfDrawing (*result.computed, measurement);
    }

    show ("Identifying", 0.1);
    const RecordEffects effects { measurement.recordLength, options.windowDecay.value_or (measurement.windowDecay) };
    measurement.responses = withModalNumerators (std::move (measurement.responses), effects);
    result.modes = withoutRecordEffects (identify (measurement.responses, search), effects);
    result.remarks = std::move (measurement.remarks);
    result.model = makeDevice (result.modes, options, search.pointMasses, result.computed, result.remarks);

    if (against)
        result.comparison = compareModes (result.modes, *result.computed);

    result.measured = asQuantity (std::move (measurement.responses), result.modes.integrations);
    result.pointNames = std::move (measurement.pointNames);
    return result;
}

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

std::string identifiedDeviceText (const IdentificationResult& result)
{
    return deviceText (identifiedDeviceToJson (result.model, result.modes, describeResult (result), limitsOf (result)));
}

void writeIdentified (const IdentificationResult& result, const IdentifyOptions& options, bool hasReport)
{
    std::vector<std::pair<std::string, std::string>> files; // All are computed before the first is written.

    if (hasReport)
    {
        const auto report = reportName (options), diagram = diagramName (report);
        files.emplace_back (report, renderReport (identificationReport (result, fileNameOf (diagram))));
        files.emplace_back (diagram, identificationDiagram (result, fileNameOf (report)));
    }

    if (! options.universalFile.empty())
        files.emplace_back (options.universalFile, encodeUniversalFile (modeSets (result.model)));

    if (! options.transferFile.empty())
        files.emplace_back (
            options.transferFile,
            changedDeviceText (*result.described, *result.computed,
                               transferred (*result.computed, result.modes, *result.comparison),
                               "Computed, with measured frequencies, damping ratios and participations"));

    if (! options.deviceFile.empty())
        files.emplace_back (options.deviceFile, identifiedDeviceText (result));

    for (const auto& [name, content] : files)
        writeWholeFile (name, content);
}
} // namespace antinode
