#include "Commands.h"
#include "PlaceInputs.h"
#include "PlaceOutcome.h"
#include "Progress.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/ChangedDevice.h>
#include <antinode_library/Inputs.h>
#include <antinode_structure/CeramicShapes.h>
#include <antinode_structure/Placing.h>
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
void printResult (const PlacedCeramics& placed, const PlaceOptions& options)
{
    Eigen::Index worst = 0;
    placed.perMode.minCoeff (&worst);
    std::printf ("%zu ceramics in the best of %td positions for %d modes\n", placed.ceramics.size(), placed.candidates,
                 options.modes);
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

std::vector<FocusDescription> loadFocuses (const PlaceOptions& options)
{
    std::vector<FocusDescription> focuses;

    for (const auto& name : options.focuses)
        focuses.push_back (loadFocus (name, options.assignments));

    return focuses;
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

using KeepPlaces = std::function<void (const std::vector<CeramicDescription>&)>;

/** Where the user interrupts, the best places so far are kept. @throws Cancelled  then */
PlacedCeramics placedOrBest (const DeviceDescription& device, const CeramicDescription& like, PlacingOptions placing,
                             const PlaceOptions& options, const std::string& what, const KeepPlaces& keep)
{
    std::vector<CeramicDescription> best;
    placing.better = [&] (const std::vector<CeramicDescription>& ceramics) { best = ceramics; };

    try
    {
        Progress progress (options.isQuiet);
        progress.show (what, 0);
        return placeCeramics (device, like, placing, [&] (double share) { progress.show (what, share); });
    }
    catch (const Cancelled&)
    {
        if (! best.empty())
        {
            answerInterruption();
            keep (best);
            std::fprintf (stderr, "The best places so far are in %s\n", options.file.c_str());
        }

        throw;
    }
}

/** What each number of ceramics comes to. */
void printCurve (const DeviceDescription& device, const CeramicDescription& like, PlacingOptions placing,
                 const std::vector<FocusDescription>& focuses, const PlaceOptions& options, const KeepPlaces& write)
{
    std::printf ("ceramics  peak voltage  field error  contrast  (the worst of %zu focuses)\n", focuses.size());
    std::fflush (stdout);
    const auto keep = [&] (const std::vector<CeramicDescription>& ceramics)
    {
        write (ceramics);
        printRow (device, ceramics, focuses, "  the best so far");
    };

    for (const auto count : options.counts)
    {
        placing.count = count;
        const auto placed =
            placedOrBest (device, like, placing, options, "Placing " + std::to_string (count) + " ceramics", keep);
        printRow (device, placed.ceramics, focuses);
    }
}

void place (PlaceOptions options)
{
    checkAssignments (options.assignments);
    const auto document = loadDeviceDocument (options.device, options.assignments);
    const auto device = loadDevice (options.device, options.assignments);
    const auto isPlate = deviceExtent (device).kind == SurfaceKind::plate;
    const auto like = ceramicLike (document, isPlate, options.size);
    const auto ceramic = describedCeramic (document, like);
    const auto focuses = loadFocuses (options);
    auto placing = placingOptions (options, ceramic);

    if (! focuses.empty())
        placing.cost = peakVoltageCost (device, focuses);
    else if (! options.counts.empty())
        throw InputError ("--counts", "needs --focus: it compares what focuses come to with each number of ceramics");

    if (options.file.empty())
        options.file = device.name + "-placed.json";

    const auto write = [&] (const std::vector<CeramicDescription>& ceramics)
    { writeWholeFile (options.file, deviceText (placedDevice (document, like, ceramics))); };

    if (! options.counts.empty())
        return printCurve (device, ceramic, placing, focuses, options, write);

    const auto placed = placedOrBest (device, ceramic, placing, options, "Placing ceramics", write);
    write (placed.ceramics);

    if (options.isQuiet)
        return;

    printResult (placed, options);

    if (! focuses.empty())
        printOutcomes (solveStructure (withCeramics (device, placed.ceramics)), focuses);
}
} // namespace

void addPlaceCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "place", "Finds the best positions of ceramics on a device for its lowest modes; writes a device file");
    auto options = std::make_shared<PlaceOptions>();
    command->add_option ("device", options->device, "Device: an embedded name or a .json file")->capture_default_str();
    command->add_option ("--count", options->count, "Number of ceramics")
        ->check (CLI::Range (1, 64))
        ->capture_default_str();
    command->add_option ("--size-mm", options->size,
                         "Size L or LxW of a ceramic, mm; default: that of the device's first ceramic, or 10");
    command->add_option ("--step-mm", options->step, "Spacing of positions, mm; default: half a ceramic");
    command->add_option ("--rim-mm", options->edgeDistance, "On a plate: largest distance of ceramics from an edge, mm")
        ->check (CLI::NonNegativeNumber);
    command->add_option ("--free-edge-mm", options->freeEdge, "Least distance of ceramics from free edges, mm")
        ->check (CLI::Range (0.0, 1000.0))
        ->capture_default_str();
    command
        ->add_option ("--focus", options->focuses,
                      "Places for the voltage that this focus needs, an embedded name or a .json file (repeatable)")
        ->allow_extra_args (false);
    command
        ->add_option ("--counts", options->counts,
                      "With --focus: prints what each of these numbers of ceramics comes to")
        ->delimiter (',')
        ->check (CLI::Range (1, 64));
    command->add_option ("--keep-out-mm", options->keepOut, "Rectangle without ceramics, mm (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("X0,Y0,X1,Y1");
    command->add_option ("--modes", options->modes, "Number of the lowest modes to excite")
        ->check (CLI::Range (1, 200))
        ->capture_default_str();
    command->add_option ("--focus-time-ms", options->duration, "Time available to excite the modes, ms; default: 25")
        ->check (CLI::Range (0.1, 60000.0));
    command->add_option ("--out", options->file, "Device file to write; default: DEVICE-placed.json");
    command->add_flag ("--frozen", options->isFrozen, "Does not solve the device again with the placed ceramics");
    command
        ->add_option ("--set", options->assignments,
                      "Overrides a key, for example device.thickness_mm=1.5 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { place (*options); });
}
} // namespace antinode
