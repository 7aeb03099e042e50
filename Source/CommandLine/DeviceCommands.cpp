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
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <limits>
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

/** What some ceramics come to: the worst of all focuses. */
void printRow (const DeviceDescription& device, const std::vector<CeramicDescription>& ceramics,
               const std::vector<FocusDescription>& focuses, const char* remark = "")
{
    PlacementOutcome worst { {}, 0, 0, 0, std::numeric_limits<double>::infinity() };

    for (const auto& each : placementOutcomes (solveStructure (withCeramics (device, ceramics)), focuses))
    {
        worst.peakVoltage = std::max (worst.peakVoltage, each.peakVoltage);
        worst.fieldError = std::max (worst.fieldError, each.fieldError);
        worst.contrast = std::min (worst.contrast, each.contrast);
    }

    std::printf ("%8zu  %10s V  %9.2f %%  %8s%s\n", ceramics.size(), inWords (worst.peakVoltage).c_str(),
                 100 * worst.fieldError, inWords (worst.contrast).c_str(), remark);
    std::fflush (stdout);
}

void write (const PlaceOptions& options, const std::vector<CeramicDescription>& ceramics)
{
    writeWholeFile (options.file, deviceText (placedDevice (options.request, ceramics)));
}

/** Where the user interrupts, the best places so far are kept. @throws Cancelled  then */
PlacedCeramics placedOrBest (const PlaceOptions& options)
{
    std::vector<CeramicDescription> best;

    try
    {
        Progress progress (options.isQuiet);
        return placed (
            options.request, [&] (const std::vector<CeramicDescription>& ceramics) { best = ceramics; },
            progress.shown());
    }
    catch (const Cancelled&)
    {
        if (! best.empty())
        {
            answerInterruption();
            write (options, best);

            if (! options.counts.empty())
                printRow (options.request.device, best, options.request.focuses, "  the best so far");

            std::fprintf (stderr, "The best places so far are in %s\n", options.file.c_str());
        }

        throw;
    }
}

/** What each number of ceramics comes to. */
void printCurve (PlaceOptions options)
{
    const auto& focuses = options.request.focuses;

    if (focuses.empty())
        throw InputError ("--counts", "needs --focus: it compares the focuses for each number of ceramics");

    std::printf ("ceramics  peak voltage  field error  contrast  (the worst of %zu focuses)\n", focuses.size());
    std::fflush (stdout);

    for (const auto count : options.counts)
    {
        options.request.count = count;
        printRow (options.request.device, placedOrBest (options).ceramics, focuses);
    }
}

void runPlace (PlaceOptions& options)
{
    const auto& request = options.request;

    if (options.file.empty())
        options.file = request.device.name + "-placed.json";

    if (! options.counts.empty())
        return printCurve (options);

    const auto found = placedOrBest (options);
    write (options, found.ceramics);

    if (options.isQuiet)
        return;

    printResult (found, options);

    if (! request.focuses.empty())
        printOutcomes (solveStructure (withCeramics (request.device, found.ceramics)), request.focuses);
}
} // namespace

void addPlaceCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        placeText.name, "Finds the best positions of ceramics on a device for its lowest modes; writes a device file");
    auto options = std::make_shared<PlaceOptions>();
    auto all = fields (options->request);
    append (all, { Field ("--counts", &options->counts,
                          "With --focus: prints the result for each of these numbers of ceramics")
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
