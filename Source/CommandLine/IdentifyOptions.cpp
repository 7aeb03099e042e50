#include "IdentifyOptions.h"

#include "BoundaryOption.h"
#include "CommonOptions.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_responses/PointsFile.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace antinode
{
namespace
{
/** "300:4000" as two numbers, the first the smaller. */
FrequencyBand parseBand (const std::string& option, const std::string& text)
{
    FrequencyBand range;
    const auto colon = text.find (':');
    const auto* const end = text.data() + text.size();
    const auto first = std::from_chars (text.data(), end, range.minimum);
    const auto second =
        colon == std::string::npos ? first : std::from_chars (text.data() + colon + 1, end, range.maximum);

    if (first.ec != std::errc {} || second.ec != std::errc {} || first.ptr != text.data() + colon || second.ptr != end
        || ! (range.minimum >= 0 && range.minimum < range.maximum))
        throw InputError (option, "is " + inQuotes (text) + "; allowed: two ascending numbers, for example 300:4000");

    return range;
}

void addInputOptions (CLI::App& command, IdentifyOptions& options)
{
    command.add_option ("--format", options.form, "Content of pairs of columns in a table without headings")
        ->check (CLI::IsMember ({ "real-imag", "magnitude-deg", "magnitude-rad", "dB-deg", "dB-rad" }));
    command.add_option ("--quantity", options.quantity, "Measured quantity; default: as the files say")
        ->check (CLI::IsMember ({ "displacement", "velocity", "acceleration" }));
    command.add_option ("--response-unit", options.responseUnit,
                        "Unit of the measured quantity, for example m/s, um, g or (mm/s)/V");
    command.add_option ("--drive", options.drive, "Quantity of the excitation; default: as the files say")
        ->check (CLI::IsMember ({ "voltage", "force" }));
    command.add_option ("--drive-unit", options.driveUnit, "Unit of the excitation, for example V, mV or N");
    command.add_option ("--points", options.pointsFile,
                        "Positions of the points: CSV of x and y in mm, in the order of the points");
    command.add_option ("--drivers", options.references, "Names of the references in the order of the ceramics")
        ->delimiter (',');
    command
        .add_option ("--variables", options.variables,
                     "Variables of MATLAB files to read; default: H, FRF, or those whose names differ in numbers")
        ->delimiter (',');
    command
        .add_option ("--window-decay", options.windowDecay,
                     "Decay rate of the exponential window on the impulse responses, 1/s; default: as the files say")
        ->check (CLI::NonNegativeNumber);
}

void addSearchOptions (CLI::App& command, IdentifyOptions& options)
{
    command
        .add_option (
            "--band", options.bands,
            "Frequency band MIN:MAX, Hz, for example 300:4000; modes are searched in each of several bands separately")
        ->allow_extra_args (false)
        ->type_name ("MIN:MAX");
    command
        .add_option ("--orders", options.orders,
                     "Orders MIN:MAX of the polynomials, for example 3:18; default: automatic")
        ->type_name ("MIN:MAX");
    command.add_option ("--select", options.selected, "Keeps only the modes nearest to these frequencies, Hz")
        ->delimiter (',');
    command.add_option ("--reject", options.rejected, "Leaves out the modes nearest to these frequencies, Hz")
        ->delimiter (',');
    command.add_option ("--delay-us", options.delay, "Known common delay, us; default: identified");
    command
        .add_option ("--mass-kg", options.mass,
                     "Mass that the points represent, evenly distributed, kg: scales the shapes")
        ->check (CLI::PositiveNumber);
    auto* const complexModes =
        command.add_flag ("--complex", options.isComplex, "Identifies complex modes; default: as a test decides");
    command.add_flag ("--real", options.isReal, "Identifies real modes; default: as a test decides")
        ->excludes (complexModes);
    command.add_flag ("--peaks", options.usesPeaks,
                      "Uses peaks and their half-power widths, as in the paper, for comparison");
    command
        .add_flag ("--gram-schmidt", options.isGramSchmidt,
                   "Makes real shapes orthogonal as in the paper; distorts shapes of a partly mapped structure")
        ->excludes (complexModes);
}

void addOutputOptions (CLI::App& command, IdentifyOptions& options)
{
    command.add_option ("--out", options.deviceFile, "Device file to write")->type_name ("DEVICE.json");
    command
        .add_option ("--report", options.reportFile,
                     "Writes a report with figures and, beside it, a diagram to pick modes in a browser; default name: "
                     "that of the device file, .html")
        ->expected (0, 1)
        ->type_name ("FILE.html");
    command.add_option ("--uff", options.universalFile, "Writes frequencies and shapes as a Universal File")
        ->type_name ("FILE");
    command
        .add_option ("--against", options.against, "Compares with a computed device: an embedded name or a .json file")
        ->type_name ("DEVICE");
    command
        .add_option ("--transfer", options.transferFile,
                     "Writes the computed device with the measured frequencies, damping ratios and participations")
        ->type_name ("DEVICE.json");
    addOutlineOption (command, options.outline);
    command.add_option ("--name", options.name, "Name of the device")->capture_default_str();
    command.add_option ("--voltage-limit-v", options.voltageLimit, "Voltage limit of every ceramic, V")
        ->check (CLI::PositiveNumber)
        ->capture_default_str();
    command
        .add_option ("--full-scale-v", options.fullScaleVoltage,
                     "Voltage of a sample of 1, V; default: that of --against, else the voltage limit")
        ->check (CLI::PositiveNumber);
    addCacheFlag (command, options.usesCache);
    command.add_flag ("--quiet", options.isQuiet, "Prints only errors");
}

std::optional<ResponseUnit> parseResponse (const IdentifyOptions& options)
{
    if (options.quantity.empty() && options.responseUnit.empty())
        return std::nullopt;

    auto unit =
        options.responseUnit.empty() ? ResponseUnit {} : responseUnit (options.responseUnit).value_or (ResponseUnit {});

    if (! options.responseUnit.empty() && ! unit.quantity)
        throw InputError ("--response-unit", "is " + inQuotes (options.responseUnit)
                                                 + "; allowed: a unit, for example m/s, um, g or (mm/s)/V");

    if (options.quantity.empty())
        return unit;

    const auto said = quantityWord (options.quantity)->quantity;

    if (unit.quantity && unit.quantity != said)
        throw InputError ("--response-unit",
                          "is " + inQuotes (options.responseUnit) + "; allowed: a unit of " + options.quantity);

    unit.quantity = said;
    return unit;
}

std::optional<ResponseUnit> parseDrive (const IdentifyOptions& options)
{
    if (options.drive.empty() && options.driveUnit.empty())
        return std::nullopt;

    const auto text =
        options.driveUnit.empty() ? std::string (options.drive == "force" ? "N" : "V") : options.driveUnit;
    const auto unit = driveUnit (text);

    if (! unit || (! options.drive.empty() && (unit->drive == DriveQuantity::force) != (options.drive == "force")))
        throw InputError ("--drive-unit",
                          "is " + inQuotes (text) + "; allowed: a unit of the excitation, for example V, mV or N");

    return unit;
}
} // namespace

void addIdentifyOptions (CLI::App& command, IdentifyOptions& options)
{
    command
        .add_option ("files", options.files,
                     "Universal files, MATLAB files, text tables, WAV files of impulse responses")
        ->required()
        ->type_name ("FILES");
    addOutputOptions (command, options);
    addSearchOptions (command, options);
    addInputOptions (command, options);
}

CsvForm toCsvForm (const IdentifyOptions& options)
{
    return options.form == "real-imag"       ? CsvForm::realImaginary
           : options.form == "magnitude-deg" ? CsvForm::magnitudeDegrees
           : options.form == "magnitude-rad" ? CsvForm::magnitudeRadians
           : options.form == "dB-deg"        ? CsvForm::decibelDegrees
           : options.form == "dB-rad"        ? CsvForm::decibelRadians
                                             : CsvForm::byHeadings;
}

MeasurementOptions toMeasurementOptions (const IdentifyOptions& options)
{
    MeasurementOptions measurement;
    measurement.response = parseResponse (options);
    measurement.drive = parseDrive (options);
    measurement.references = options.references;

    if (! options.pointsFile.empty())
    {
        const auto points = readPointsFile (options.pointsFile);

        for (Eigen::Index p = 0; p < points.rows(); ++p)
            measurement.places.emplace (std::to_string (p + 1), points.row (p).transpose());
    }

    return measurement;
}

IdentificationOptions toIdentificationOptions (const IdentifyOptions& options, Eigen::Index points)
{
    constexpr double micro = 1e-6;
    IdentificationOptions search;
    search.method = options.usesPeaks ? IdentificationMethod::peakPicking : IdentificationMethod::maximumLikelihood;

    if (options.isComplex || options.isReal || options.isGramSchmidt)
        search.complexModes = options.isComplex;

    search.gramSchmidt = options.isGramSchmidt;
    search.selected = options.selected;
    search.rejected = options.rejected;

    for (const auto& text : options.bands)
        search.bands.push_back (parseBand ("--band", text));

    if (! search.bands.empty())
    {
        const auto lower = [] (const auto& a, const auto& b) { return a.minimum < b.minimum; };
        const auto upper = [] (const auto& a, const auto& b) { return a.maximum < b.maximum; };
        search.minimumFrequency = std::min_element (search.bands.begin(), search.bands.end(), lower)->minimum;
        search.maximumFrequency = std::max_element (search.bands.begin(), search.bands.end(), upper)->maximum;
    }

    if (search.bands.size() == 1) // Where poles are sought within it is chosen.
        search.bands.clear();

    if (! options.orders.empty())
    {
        const auto orders = parseBand ("--orders", options.orders);

        constexpr double large = 1e6; // What is allowed says identify.

        if (std::floor (orders.minimum) != orders.minimum || std::floor (orders.maximum) != orders.maximum)
            throw InputError ("--orders", "is " + inQuotes (options.orders) + "; allowed: whole numbers");

        search.minimumOrder = static_cast<int> (std::min (orders.minimum, large));
        search.maximumOrder = static_cast<int> (std::min (orders.maximum, large));
    }

    if (options.delay)
        search.delay = micro * *options.delay;

    if (options.mass)
        search.pointMasses = Eigen::VectorXd::Constant (points, *options.mass / static_cast<double> (points));

    return search;
}
} // namespace antinode
