#include "Commands.h"
#include "CommonOptions.h"
#include "DesignTolerances.h"
#include "DesignTradeoffs.h"
#include "FocusOnDevice.h"
#include "Progress.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/MatlabTables.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/ExpectedError.h>
#include <antinode_focus/LimitWords.h>
#include <antinode_library/Inputs.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace antinode
{
namespace
{
struct DesignCommandOptions
{
    CommonOptions common;
    ToleranceCommandOptions tolerance;
    bool isTradeoff = false;
    bool isForMatlab = false;
};

void design (const DesignCommandOptions& all)
{
    const auto& options = all.common;
    const auto made = designFrom (options);
    const auto& result = made.design;
    const auto model = firstModes (made.wide.model, made.wide.known);
    const auto power = designedPower (made, options.playback(), options.repetitions);
    std::vector<DesignTolerance> tolerances;
    const auto draws = std::filesystem::path (options.folder) / "tolerance-draws";
    OutputFolder folder (options.folder);
    folder.write ("design.json", designDocument (made, power).dump (2) + "\n");

    if (all.isForMatlab)
        folder.write ("design.mat", encodeDesignForMatlab (result, designedModel (made.wide)));

    if (all.tolerance.isWanted)
    {
        Progress progress (options.isQuiet);
        tolerances = designTolerances (model, result, all.tolerance, draws,
                                       [&] (const std::string& what, double share) { progress.show (what, share); });
        writeTolerances (folder, model, result.description.name, tolerances);
    }

    folder.commit();
    std::error_code ignored;
    std::filesystem::remove_all (draws, ignored);

    if (options.isQuiet)
        return;

    std::printf ("%s on %s: %zu modes, captured %.4f, peak %s V of %s V\n", result.description.name.c_str(),
                 model.name.c_str(), result.controlledModes.size(), result.captured,
                 inWords (peakVoltage (result)).c_str(), inWords (result.program.voltageLimits.maxCoeff()).c_str());

    if (const auto expected = expectedError (model, result))
        std::printf ("Field error on the device: %s\n", expected->sentence.c_str());

    printPower (model, power);

    if (result.limit)
        std::printf ("%s\n", limitSentence (model, *result.limit).c_str());

    for (const auto& warning : result.warnings)
        std::printf ("Warning: %s\n", warning.c_str());

    if (! tolerances.empty())
        std::printf ("%s%s/tolerance.html\n", tolerancesInWords (model, tolerances).c_str(), options.folder.c_str());

    std::printf ("%s/design.json\n", options.folder.c_str());
}

/** All designs, or those that were finished when the user interrupted. @throws Cancelled  where there are none */
DesignTradeoff designsSoFar (const CommonOptions& options)
{
    checkAssignments (options.assignments);
    const auto focus = loadFocus (options.focus, options.assignments);
    const auto wanted = focus.felt ? completed (options, focus) : focus;
    Progress progress (options.isQuiet);
    progress.show (focus.felt ? "Designing" : "Finding the lower bound", 0);
    DesignTradeoff soFar;

    try
    {
        return designTradeoff (
            loadDevice (options.device, options.assignments), wanted, options.playback(), options.usesCache,
            [&] (const DesignTradeoff& now, double share)
            {
                soFar = now;
                progress.show ("Designing", share, formatted ("%zu of %zu designs", now.designs(), now.planned()));
            });
    }
    catch (const Cancelled&)
    {
        if (soFar.designs() == 0)
            throw;

        answerInterruption();
        return soFar;
    }
}

void sweep (const CommonOptions& options)
{
    const auto tradeoff = designsSoFar (options);
    writeTradeoff (options.folder, tradeoff);

    if (! options.isQuiet)
        std::printf ("%s%s/tradeoff.html\n", tradeoffInWords (tradeoff).c_str(), options.folder.c_str());

    if (tradeoff.designs() < tradeoff.planned())
        throw Cancelled();
}
} // namespace

void addDesignCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("design", "Computes the voltages of a focus and writes design.json");
    auto options = std::make_shared<DesignCommandOptions>();
    command->add_option ("focus", options->common.focus, "Focus: an embedded name or a .json file")
        ->capture_default_str();
    addCommonOptions (*command, options->common);
    addToleranceOptions (*command, options->tolerance);
    auto* matlab = command->add_flag ("--mat", options->isForMatlab, "Also writes drives and allocation as design.mat");
    auto* tradeoff = command->add_flag (
        "--tradeoff", options->isTradeoff,
        "Compares all methods and growths instead: peak voltage against time in motion; of a focus with "
        "'felt' its weights: peak voltage against felt contrast");
    tradeoff->excludes (command->get_option ("--tolerance"))->excludes (matlab);
    command->callback (
        [options]
        {
            auto& common = options->common;
            common.device =
                deviceFor (LibraryKind::focus, { common.focus }, common.device, usualDevice, common.assignments);
            options->isTradeoff ? sweep (common) : design (*options);
        });
}
} // namespace antinode
