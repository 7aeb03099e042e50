#include "CommandLine.h"
#include "TaskCommand.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/MeasuredDevice.h>
#include <antinode_structure/DescribedCeramic.h>
#include <antinode_structure/Materials.h>
#include <antinode_tasks/Place.h>
#include <antinode_tasks/PlacementOutcomes.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>

namespace antinode
{
namespace
{
constexpr int materialColumn = 21;

struct DevicesOptions
{
    bool showsMaterials = false, showsFocuses = false;
    std::string shown;
};

std::string firstSentence (const std::string& text)
{
    const auto end = text.find (". ");
    return end == std::string::npos ? text : text.substr (0, end + 1);
}

void listDevices()
{
    for (const auto& name : factoryNames (LibraryKind::device))
    {
        const auto document = loadDocument (LibraryKind::device, name);
        std::printf ("%-16s %-7s %2zu ceramics  %s\n", name.c_str(), document.at ("kind").get<std::string>().c_str(),
                     document.value ("ceramics", nlohmann::json::array()).size(),
                     firstSentence (document.value ("description", "")).c_str());
    }
}

/** "sinc of 25 mm at 24 mm, 40 mm/s, after 25 ms". */
std::string targetsInWords (const FocusDescription& focus)
{
    std::string text;

    for (const auto& target : focus.targets)
    {
        const auto place =
            inWords (target.x * milli) + (target.y != 0 ? ", " + inWords (target.y * milli) : "") + " mm";
        text += (text.empty() ? "" : "; ") + std::string (wordFor (targetShapeWords, target.shape)) + " of "
                + inWords (target.width * milli) + " mm at " + place + ", "
                + inWords (target.phase * target.peakVelocity * milli) + " mm/s, after "
                + inWords (target.time.value_or (focus.focusTime) * milli) + " ms";
    }

    return text;
}

void listFocuses()
{
    for (const auto& name : factoryNames (LibraryKind::focus))
        std::printf ("%-16s %s\n", name.c_str(), targetsInWords (loadFocus (name, {})).c_str());
}

void printNotes (const MaterialNotes& notes)
{
    std::printf ("%*s %s; source: %s\n", materialColumn, "", std::string (notes.scatter).c_str(),
                 std::string (notes.source).c_str());
}

void printElastic (const std::string& name, const ElasticMaterial& material)
{
    std::printf ("%-*s E %g GPa", materialColumn, name.c_str(), material.youngsModulus1 / 1e9);

    if (material.youngsModulus2 != material.youngsModulus1)
        std::printf (" along x, %g along y, G12 %g GPa", material.youngsModulus2 / 1e9, material.shearModulus / 1e9);

    std::printf (", Poisson's ratio %g, density %g kg/m3\n", material.poissonRatio12, material.density);
}

void printPiezoelectric (const std::string& name, const PiezoelectricMaterial& material)
{
    std::printf ("%-*s E %g GPa, Poisson's ratio %g, density %g kg/m3, d31 %g m/V, ", materialColumn, name.c_str(),
                 material.youngsModulus / 1e9, material.poissonRatio, material.density, material.d31);

    if (material.fibres)
        std::printf ("across the fibres E %g GPa, d32 %g m/V, electrodes %g mm apart\n",
                     material.fibres->youngsModulus2 / 1e9, material.fibres->d32,
                     material.fibres->electrodeDistance * milli);
    else
        std::printf ("relative permittivity %g\n", material.permittivityRelative);
}

void printViscoelastic (const std::string& name, const ViscoelasticMaterial& material)
{
    std::printf ("%-*s density %g kg/m3; shear modulus and loss factor", materialColumn, name.c_str(),
                 material.density);

    for (const auto& row : material.table)
        std::printf ("%s %g MPa, %g at %g Hz", &row == &material.table.front() ? "" : ";", row.shearModulus / 1e6,
                     row.lossFactor, row.frequency);

    std::printf ("\n");
}

void listMaterials()
{
    std::printf ("Plates and layers\n\n");

    for (const auto& [notes, material] : elasticMaterials())
    {
        printElastic (std::string (notes.name), material);
        printNotes (notes);
    }

    std::printf ("\nCeramics\n\n");

    for (const auto& [notes, material] : piezoelectricMaterials())
    {
        printPiezoelectric (std::string (notes.name), material);
        printNotes (notes);
    }

    std::printf ("\nSoft layers\n\n");

    for (const auto& [notes, material] : viscoelasticMaterials())
    {
        printViscoelastic (std::string (notes.name), material);
        printNotes (notes);
    }
}

/** No two documents have one name. */
LibraryKind kindOf (const std::string& name)
{
    for (const auto kind : { LibraryKind::focus, LibraryKind::waveforms })
        if (const auto names = factoryNames (kind); std::find (names.begin(), names.end(), name) != names.end())
            return kind;

    return LibraryKind::device;
}

void run (const DevicesOptions& options)
{
    if (! options.shown.empty())
        std::printf ("%s\n", loadDocument (kindOf (options.shown), options.shown).dump (2).c_str());
    else if (options.showsMaterials)
        listMaterials();
    else if (options.showsFocuses)
        listFocuses();
    else
        listDevices();
}
} // namespace

void addDevicesCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("devices", "Lists the embedded devices, focuses and materials");
    auto options = std::make_shared<DevicesOptions>();
    addFields (*command,
               { Field ("--materials", &options->showsMaterials,
                        "Lists the built-in materials with values, scatter and sources"),
                 Field ("--focuses", &options->showsFocuses, "Lists the embedded focuses").without ("--materials"),
                 Field ("--show", &options->shown,
                        "Writes an embedded device, focus or waveforms as JSON, as a starting point for new ones")
                     .written ("NAME")
                     .without ("--materials")
                     .without ("--focuses") });
    command->callback ([options] { run (*options); });
}

namespace
{
struct PlaceOptions
{
    PlaceRequest request;
    std::filesystem::path file;
    std::vector<int> counts;
    bool isQuiet = false;
};

void printResult (const PlacedCeramics& placed, const PlaceOptions& options)
{
    Eigen::Index worst = 0;
    placed.perMode.minCoeff (&worst);
    std::printf ("%zu ceramics in the best of %td positions for %d modes\n", placed.ceramics.size(), placed.candidates,
                 options.request.modes);
    std::printf ("  The worst combination of modes is moved %.4g times as well as from average positions;\n"
                 "  the worst single mode, %td, %.4g times.\n",
                 placed.controllability, worst + 1, placed.perMode[worst]);

    if (placed.resolved)
        std::printf ("  Including mass and stiffness of the ceramics: %.4g times.\n", *placed.resolved);

    for (const auto& ceramic : placed.ceramics)
        if (fillsItsRectangle (ceramic))
            std::printf ("  %-4s x %8.3f  y %8.3f mm, %g x %g mm\n", ceramic.name.c_str(), ceramic.x * milli,
                         ceramic.y * milli, ceramic.sizeX * milli, ceramic.sizeY * milli);
        else
            std::printf ("  %-4s centre %8.3f, %8.3f mm, %g x %g mm\n", ceramic.name.c_str(),
                         ceramic.centre().x() * milli, ceramic.centre().y() * milli, ceramic.sizeX * milli,
                         ceramic.sizeY * milli);

    std::printf ("Device: %s\n", options.file.c_str());
}

void printOutcomes (const ModalModel& model, const std::vector<FocusDescription>& focuses)
{
    for (const auto& outcome : placementOutcomes (model, focuses))
        std::printf ("  %-24s %8s V of %s V, field error %.2f %%, contrast %s\n", outcome.focus.c_str(),
                     inWords (outcome.peakVoltage).c_str(), inWords (outcome.limit).c_str(), 100 * outcome.fieldError,
                     inWords (outcome.contrast).c_str());
}

/** A number of a row, the unit of what is printed, and where the row has it. */
struct RowColumn
{
    const char* heading;
    int width;
    std::function<std::string (const SeriesResult&)> text;
};

std::vector<RowColumn> rowColumns (bool isOfWaveforms)
{
    const auto number = [] (const char* key, double perUnit = 1)
    { return [=] (const SeriesResult& row) { return inWords (seriesNumber (row, key) * perUnit); }; };
    const RowColumn peak { "peak/V", 8, number ("peak_voltage_V") };

    if (! isOfWaveforms)
        return { peak,
                 { "limit/V", 8, number ("voltage_limit_V") },
                 { "field error/%", 14, number ("field_error", 100) },
                 { "contrast", 9, number ("contrast") } };

    return { peak,
             { "energy/uJ", 10, number ("energy_J", micro) },
             { "current/mA", 11, number ("peak_current_A", milli) },
             { "felt/dB SL", 11,
               [] (const SeriesResult& row) { return fixedText (seriesNumber (row, "felt_level_dB"), 1); } },
             { "of the level/dB", 16,
               [] (const SeriesResult& row) { return fixedText (seriesNumber (row, "level_share_dB"), 1); } } };
}

/** The rows of numbers of ceramics: printed as soon as they are there, and all of them in a table beside the devices.
 */
class PlacementRows
{
public:
    explicit PlacementRows (const PlaceOptions& optionsToUse)
        : options (optionsToUse), columns (rowColumns (options.request.waveforms.has_value()))
    {
    }

    void add (SeriesResult row, std::size_t ceramics, const char* remark = "")
    {
        print (row, ceramics, remark);
        row.numbers.insert (row.numbers.begin(), { "ceramics", static_cast<double> (ceramics) });
        rows.push_back (std::move (row));

        if (! options.counts.empty())
            writeWholeFile (std::filesystem::path (options.file).replace_extension (".csv"), scoreTable (rows));
    }

private:
    void print (const SeriesResult& row, std::size_t ceramics, const char* remark) const
    {
        if (options.isQuiet)
            return;

        if (rows.empty())
        {
            std::printf ("ceramics");

            for (const auto& column : columns)
                std::printf (" %*s", column.width, column.heading);

            std::printf ("\n");
        }

        std::printf ("%8zu", ceramics);

        for (const auto& column : columns)
            if (row.error.empty())
                std::printf (" %*s", column.width, column.text (row).c_str());

        std::printf ("%s%s\n", row.error.empty() ? remark : "  failed: ", row.error.c_str());
        std::fflush (stdout);
    }

    const PlaceOptions& options;
    const std::vector<RowColumn> columns;
    std::vector<SeriesResult> rows;
};

void write (const PlaceRequest& request, const std::filesystem::path& file,
            const std::vector<CeramicDescription>& ceramics)
{
    writeWholeFile (file, deviceText (placedDevice (request, ceramics)));
}

/** The row of a device that was written. */
SeriesResult rowOf (const PlaceRequest& request, const std::filesystem::path& file)
{
    return { file.stem().string(), placementNumbers (request, loadDevice (file.string(), {})), {} };
}

/** The best places so far are always in the file. @throws Cancelled  where the user interrupts, with a row for them */
PlacedCeramics placedOrBest (const PlaceOptions& options, const PlaceRequest& request,
                             const std::filesystem::path& file, PlacementRows& rows)
{
    std::size_t written = 0;

    try
    {
        Progress progress (options.isQuiet);
        return placed (
            request,
            [&] (const std::vector<CeramicDescription>& ceramics)
            {
                write (request, file, ceramics);
                written = ceramics.size();
            },
            progress.shown());
    }
    catch (const Cancelled&)
    {
        if (written > 0)
        {
            answerInterruption();

            if (! options.counts.empty())
                rows.add (rowOf (request, file), written, "  the best so far");

            std::fprintf (stderr, "The best places so far are in %s\n", file.c_str());
        }

        throw;
    }
}

/** What each number of ceramics comes to, each with its device. */
void placeCounts (const PlaceOptions& options)
{
    PlacementRows rows (options);

    if (options.request.focuses.empty() && ! options.request.waveforms)
        throw InputError ("--counts", "needs --focus or --waveforms: it compares what these need of each number of "
                                      "ceramics");

    for (const auto count : options.counts)
    {
        auto request = options.request;
        request.count = count;
        auto file = options.file;
        file.replace_filename (file.stem().string() + "-" + std::to_string (count) + ".json");

        try
        {
            write (request, file, placedOrBest (options, request, file, rows).ceramics);
            rows.add (rowOf (request, file), static_cast<std::size_t> (count));
        }
        catch (const InputError& error)
        {
            rows.add ({ file.stem().string(), {}, withKeysAndOptions (error.what()) },
                      static_cast<std::size_t> (count));
        }
    }
}

void runPlace (PlaceOptions& options)
{
    const auto& request = options.request;

    if (options.file.empty())
        options.file = request.device.name + "-placed.json";

    if (! options.counts.empty())
        return placeCounts (options);

    PlacementRows rows (options);
    const auto found = placedOrBest (options, request, options.file, rows);
    write (request, options.file, found.ceramics);

    if (options.isQuiet)
        return;

    printResult (found, options);

    if (request.waveforms)
        rows.add (rowOf (request, options.file), found.ceramics.size());
    else if (! request.focuses.empty())
        printOutcomes (solveStructure (withCeramics (request.device, found.ceramics)), request.focuses);
}
} // namespace

void addPlaceCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        placeText.name, "Finds the best positions of ceramics on a device for its lowest modes; writes a device file");
    auto options = std::make_shared<PlaceOptions>();
    auto all = fields (options->request);
    append (all,
            { Field ("--counts", &options->counts,
                     "With --focus or --waveforms: a device and a row of a table for each of these numbers of ceramics")
                  .written ("N", ',')
                  .within (1, 64),
              Field ("--out", &options->file, "Device file to write").by ("DEVICE-placed.json"),
              quietField (options->isQuiet) });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            runPlace (*options);
        });
}
} // namespace antinode
