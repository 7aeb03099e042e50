#include "Identify.h"

#include "DeviceChecks.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/MeasuredDevice.h>
#include <antinode_documents/UniversalModes.h>
#include <antinode_identification/IdentifiedModel.h>
#include <antinode_identification/ImpulseResponses.h>
#include <antinode_identification/MeasuredQuantity.h>
#include <antinode_model/Surface.h>
#include <antinode_reports/IdentificationDiagram.h>
#include <antinode_responses/MeasurementReader.h>
#include <antinode_responses/PointsFile.h>
#include <antinode_responses/UniversalFile.h>
#include <antinode_text/NaturalOrder.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace antinode
{
namespace
{
std::optional<ResponseUnit> parseResponse (const IdentifyRequest& request)
{
    if (! request.quantity && ! request.responseUnit)
        return std::nullopt;

    auto unit =
        request.responseUnit ? responseUnit (*request.responseUnit).value_or (ResponseUnit {}) : ResponseUnit {};

    if (request.responseUnit && ! unit.quantity)
        throw InputError ("--response-unit", "is " + inQuotes (*request.responseUnit)
                                                 + "; allowed: a unit, for example m/s, um, g or (mm/s)/V");

    if (! request.quantity)
        return unit;

    const auto said = quantityWord (*request.quantity)->quantity;

    if (unit.quantity && unit.quantity != said)
        throw InputError ("--response-unit",
                          "is " + inQuotes (*request.responseUnit) + "; allowed: a unit of " + *request.quantity);

    unit.quantity = said;
    return unit;
}

std::optional<ResponseUnit> parseDrive (const IdentifyRequest& request)
{
    if (! request.drive && ! request.driveUnit)
        return std::nullopt;

    const auto text = request.driveUnit.value_or (request.drive == "force" ? "N" : "V");
    const auto unit = driveUnit (text);

    if (! unit || (request.drive && (unit->drive == DriveQuantity::force) != (request.drive == "force")))
        throw InputError ("--drive-unit",
                          "is " + inQuotes (text) + "; allowed: a unit of the excitation, for example V, mV or N");

    return unit;
}

CsvForm toCsvForm (const IdentifyRequest& request)
{
    return request.form == "real-imag"       ? CsvForm::realImaginary
           : request.form == "magnitude-deg" ? CsvForm::magnitudeDegrees
           : request.form == "magnitude-rad" ? CsvForm::magnitudeRadians
           : request.form == "dB-deg"        ? CsvForm::decibelDegrees
           : request.form == "dB-rad"        ? CsvForm::decibelRadians
                                             : CsvForm::byHeadings;
}

MeasurementOptions toMeasurementOptions (const IdentifyRequest& request)
{
    MeasurementOptions measurement;
    measurement.response = parseResponse (request);
    measurement.drive = parseDrive (request);
    measurement.references = request.references;

    if (! request.pointsFile.empty())
    {
        const auto points = readPointsFile (request.pointsFile.string());

        for (Eigen::Index p = 0; p < points.rows(); ++p)
            measurement.places.emplace (std::to_string (p + 1), points.row (p).transpose());
    }

    return measurement;
}

IdentificationOptions toIdentificationOptions (const IdentifyRequest& request, Eigen::Index points)
{
    IdentificationOptions search;
    search.method = request.usesPeaks ? IdentificationMethod::peakPicking : IdentificationMethod::maximumLikelihood;

    if (request.kind || request.isGramSchmidt)
        search.complexModes = request.kind == "complex";

    search.gramSchmidt = request.isGramSchmidt;
    search.selected = request.selected;
    search.rejected = request.rejected;
    search.bands = request.bands;
    search.delay = request.delay;

    if (! search.bands.empty())
    {
        const auto lower = [] (const auto& a, const auto& b) { return a.minimum < b.minimum; };
        const auto upper = [] (const auto& a, const auto& b) { return a.maximum < b.maximum; };
        search.minimumFrequency = std::min_element (search.bands.begin(), search.bands.end(), lower)->minimum;
        search.maximumFrequency = std::max_element (search.bands.begin(), search.bands.end(), upper)->maximum;
    }

    if (search.bands.size() == 1) // Where poles are sought within it is chosen.
        search.bands.clear();

    if (request.orders)
        std::tie (search.minimumOrder, search.maximumOrder) = *request.orders;

    if (request.mass)
        search.pointMasses = Eigen::VectorXd::Constant (points, *request.mass / static_cast<double> (points));

    return search;
}

constexpr const char* ascendingPair = "two ascending numbers, for example 300:4000";
constexpr const char* ascendingWhole = "two ascending whole numbers, for example 3:18";

/** Two ascending numbers. */
FrequencyBand bandFrom (const std::vector<double>& numbers)
{
    if (! (numbers[0] >= 0 && numbers[0] < numbers[1]))
        throw InputError ("--band", "is " + inWords (numbers[0]) + ":" + inWords (numbers[1])
                                        + "; allowed: " + std::string (ascendingPair));

    return { numbers[0], numbers[1] };
}

std::pair<int, int> ordersOf (const std::vector<double>& numbers)
{
    constexpr double large = 1e6; // What is allowed says identify.

    if (! (numbers[0] >= 0 && numbers[0] < numbers[1] && std::floor (numbers[0]) == numbers[0]
           && std::floor (numbers[1]) == numbers[1]))
        throw InputError ("--orders", "are " + inWords (numbers[0]) + ":" + inWords (numbers[1])
                                          + "; allowed: " + std::string (ascendingWhole));

    return { static_cast<int> (std::min (numbers[0], large)), static_cast<int> (std::min (numbers[1], large)) };
}

Measurement readFiles (const IdentifyRequest& request)
{
    const auto said = toMeasurementOptions (request);
    const std::vector<std::string> given (request.files.begin(), request.files.end());
    const auto names = inNaturalOrder (given);
    std::vector<MeasurementFile> files;
    files.reserve (names.size());

    for (const auto& name : names)
        files.push_back (readMeasurement (name, toCsvForm (request), request.variables));

    auto measurement = mergedResponses (files, said);

    if (const auto remark = orderRemark (given, names); ! remark.empty())
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
    measurement.remarks.push_back ("Shapes are scaled by the mass of the drawing, " + inWords (1000 * mass)
                                   + " g; --mass-kg sets another one.");
    return Eigen::VectorXd::Constant (points, mass / static_cast<double> (points));
}

/** The device with these modes. Forces in N become voltages in V, since a device has no other excitation. */
ModalModel makeDevice (IdentifiedModes modes, const IdentifyRequest& request, const Eigen::VectorXd& masses,
                       const std::optional<ModalModel>& computed, std::vector<std::string>& remarks)
{
    if (modes.drive == DriveQuantity::force)
        remarks.emplace_back ("Forces excite the surface: in the device 1 V stands for 1 N.");

    modes.drive = DriveQuantity::voltage;
    MappedSurface surface;
    surface.name = request.name;
    surface.masses = masses;
    surface.boundary = boundaryFrom (request.outline);

    if (! surface.boundary && computed && (computed->surface.boundary || computed->surface.grid))
        surface.boundary = boundaryOf (computed->surface);

    surface.voltageLimit = request.voltageLimit;
    surface.fullScaleVoltage =
        request.fullScaleVoltage.value_or (computed ? computed->fullScaleVoltage : request.voltageLimit);

    if (computed && computed->ceramics.size() == modes.references.size())
    {
        surface.ceramics = computed->ceramics;

        for (auto& ceramic : surface.ceramics)
            ceramic.lag = {}; // What was measured has them in its phases.
    }

    auto model = toModalModel (modes, surface);

    if (! surface.boundary && model.surface.kind == SurfaceKind::plate)
        remarks.emplace_back (
            "The surface ends at the outermost points, because no outline is given; --outline sets one.");

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

std::vector<Field> fields (IdentifyRequest& request)
{
    constexpr double microseconds = 1e6;
    const auto decides = "as a test decides", files = "as the files say";
    auto* const r = &request;
    return {
        Field ("files", &r->files, "Universal files, MATLAB files, text tables, WAV files of impulse responses")
            .required()
            .positional(),
        Field ("--against", OptionalDevice { &r->against },
               "Compares with a computed device: an embedded name or a .json file")
            .written ("DEVICE")
            .by ("none"),
        outlineField (r->outline),
        Field ("--name", &r->name, "Name of the device"),
        Field ("--voltage-limit-v", &r->voltageLimit, "Voltage limit of every ceramic, V")
            .as ("voltage_limit_V")
            .positive(),
        Field ("--full-scale-v", &r->fullScaleVoltage, "Voltage of a sample of 1, V")
            .as ("full_scale_V")
            .positive()
            .by ("that of the computed device, else the voltage limit"),
        Field ("--band",
               NumberRows { ascendingPair, 2, 2, true,
                            [r] (const auto& numbers) { r->bands.push_back (bandFrom (numbers)); } },
               "Frequency band, Hz, for example 300:4000; modes are searched in each of several bands separately")
            .as ("bands_Hz")
            .written ("MIN:MAX", ':'),
        Field (
            "--orders",
            NumberRows { ascendingWhole, 2, 2, false, [r] (const auto& numbers) { r->orders = ordersOf (numbers); } },
            "Lowest and highest order of the polynomials, for example 3:18")
            .written ("MIN:MAX", ':')
            .by ("automatic"),
        Field ("--select", &r->selected, "Keeps only the modes nearest to these frequencies, Hz")
            .as ("selected_Hz")
            .written ("HZ", ','),
        Field ("--reject", &r->rejected, "Leaves out the modes nearest to these frequencies, Hz")
            .as ("rejected_Hz")
            .written ("HZ", ','),
        Field ("--delay-us", &r->delay, "Known common delay, us").in (microseconds).by ("identified"),
        Field ("--mass-kg", &r->mass, "Mass that the points represent, evenly distributed, kg: scales the shapes")
            .positive()
            .by ("that of a drawn plate, else the size of shapes is a convention"),
        Field ("", &r->kind, "Kind of modes").as ("kind").oneOf ({ "real", "complex" }).by (decides),
        Field ("--complex", WordFlag { &r->kind, "complex" }, "Identifies complex modes").as ({}).by (decides),
        Field ("--real", WordFlag { &r->kind, "real" }, "Identifies real modes")
            .as ({})
            .by (decides)
            .without ("--complex"),
        Field ("--peaks", &r->usesPeaks, "Uses peaks and their half-power widths, as in the paper, for comparison"),
        Field ("--gram-schmidt", &r->isGramSchmidt,
               "Makes real shapes orthogonal as in the paper; distorts shapes of a partly mapped structure")
            .without ("--complex"),
        Field ("--format", &r->form, "Content of pairs of columns in a table without headings")
            .oneOf ({ "real-imag", "magnitude-deg", "magnitude-rad", "dB-deg", "dB-rad" })
            .by ("real-imag"),
        Field ("--quantity", &r->quantity, "Measured quantity")
            .oneOf ({ "displacement", "velocity", "acceleration" })
            .by (files),
        Field ("--response-unit", &r->responseUnit, "Unit of the measured quantity, for example m/s, um, g or (mm/s)/V")
            .by (files),
        Field ("--drive", &r->drive, "Quantity of the excitation").oneOf ({ "voltage", "force" }).by (files),
        Field ("--drive-unit", &r->driveUnit, "Unit of the excitation, for example V, mV or N").by (files),
        Field ("--points", &r->pointsFile, "Positions of the points: CSV of x and y in mm, in the order of the points")
            .by (files),
        Field ("--drivers", &r->references, "Names of the references in the order of the ceramics")
            .as ("references")
            .written ("NAMES", ','),
        Field ("--variables", &r->variables,
               "Variables of MATLAB files to read; none: H, FRF, or those whose names differ in numbers")
            .written ("NAMES", ','),
        Field ("--window-decay", &r->windowDecay, "Decay rate of the exponential window on the impulse responses, 1/s")
            .as ("window_decay_per_s")
            .within (0, 1e300)
            .by (files),
        cacheField (r->usesCache),
    };
}

IdentificationResult identify (const IdentifyRequest& request, const ShowProgress& progress)
{
    const auto show = [&] (const std::string& what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Reading", 0);
    auto measurement = readFiles (request);
    auto search = toIdentificationOptions (request, measurement.responses.points.rows());
    IdentificationResult result;
    result.described = request.against || request.outline.empty() || isDrawingFile (request.outline)
                           ? request.against
                           : std::optional (loadDevice (request.outline.string(), {}));

    if (result.described)
    {
        result.computed = solveDevice (*result.described, std::nullopt, request.usesCache);

        if (! request.mass)
            search.pointMasses = massesOfDrawing (*result.computed, measurement);
    }

    show ("Identifying", 0.1);
    const RecordEffects effects { measurement.recordLength, request.windowDecay.value_or (measurement.windowDecay) };
    measurement.responses = withModalNumerators (std::move (measurement.responses), effects);
    result.modes = withoutRecordEffects (identify (measurement.responses, search), effects);
    result.remarks = std::move (measurement.remarks);
    result.model = makeDevice (result.modes, request, search.pointMasses, result.computed, result.remarks);

    if (request.against)
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

void writeIdentified (const IdentificationResult& result, const IdentifiedFiles& wanted)
{
    std::vector<std::pair<std::filesystem::path, std::string>> files; // All are computed before the first is written.

    if (! wanted.transferred.empty() && ! result.comparison)
        throw InputError ("--transfer", "needs a computed device; allowed only with --against DEVICE");

    if (! wanted.report.empty())
    {
        const auto diagram = diagramName (wanted.report);
        files.emplace_back (wanted.report, renderReport (identificationReport (result, fileNameOf (diagram))));
        files.emplace_back (diagram, identificationDiagram (result, fileNameOf (wanted.report)));
    }

    if (! wanted.universalFile.empty())
        files.emplace_back (wanted.universalFile, encodeUniversalFile (modeSets (result.model)));

    if (! wanted.transferred.empty())
        files.emplace_back (
            wanted.transferred,
            changedDeviceText (*result.described, *result.computed,
                               transferred (*result.computed, result.modes, *result.comparison),
                               "Computed, with measured frequencies, damping ratios and participations"));

    if (! wanted.device.empty())
        files.emplace_back (wanted.device, identifiedDeviceText (result));

    for (const auto& [name, content] : files)
        writeWholeFile (name, content);
}
} // namespace antinode
