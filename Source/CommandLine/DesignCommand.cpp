#include "Commands.h"
#include "CommonOptions.h"
#include "DesignTolerances.h"
#include "FieldNames.h"
#include "FocusOnDevice.h"
#include "Progress.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/MatlabTables.h>
#include <antinode_documents/ToleranceFile.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_focus/LimitWords.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_render/FeltTradeoff.h>
#include <antinode_reports/FeltTradeoffReport.h>
#include <antinode_reports/ToleranceReport.h>
#include <antinode_reports/TradeoffReport.h>
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

void writeTolerances (OutputFolder& folder, const ModalModel& model, const std::string& focus,
                      const std::vector<DesignTolerance>& tolerances)
{
    folder.write ("tolerance.json", toleranceToJson (model, focus, tolerances).dump (2) + "\n");
    folder.write ("tolerance.html", renderReport (toleranceReport (model, focus, tolerances)));
}

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
        tolerances = designTolerances (model, result, all.tolerance, draws, progress);
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

    printPower (model, power);

    if (result.limit)
        std::printf ("%s\n", limitSentence (model, *result.limit).c_str());

    for (const auto& warning : result.warnings)
        std::printf ("Warning: %s\n", warning.c_str());

    if (! tolerances.empty())
        std::printf ("%s%s/tolerance.html\n", tolerancesInWords (model, tolerances).c_str(), options.folder.c_str());

    std::printf ("%s/design.json\n", options.folder.c_str());
}

/** What skin feels of the controlled modes, whatever the limits are. */
FindFeltContrast feltContrasts (const ModalModel& model, Playback playback)
{
    RenderOptions render;
    render.playback = playback;
    render.threshold = findSkinThreshold ({});
    return [unlimited = withoutVoltageLimits (model), render] (const FocusDesign& design)
    { return renderFocus (unlimited, design, render).felt.value().contrast(); };
}

/** All designs, or those that were finished when the user interrupted. @throws Cancelled  where there are none */
Tradeoff designsSoFar (const ModalModel& model, const FocusDescription& focus, const CommonOptions& options)
{
    Progress progress (options.isQuiet);
    Tradeoff soFar;

    try
    {
        progress.show ("Finding the lower bound", 0);
        return sweepTradeoff (
            model, focus, options.playback(),
            [&] (const Tradeoff& now)
            {
                soFar = now;
                progress.show ("Designing", now.expectedShare,
                               formatted ("%zu of %zu designs", now.points.size(), now.planned));
            },
            feltContrasts (model, options.playback()));
    }
    catch (const Cancelled&)
    {
        if (soFar.points.empty())
            throw;

        answerInterruption();
        return soFar;
    }
}

/** As designsSoFar, by the weight of what is felt elsewhere. */
FeltTradeoff weightsSoFar (const ModalModel& model, const FocusDescription& focus, const CommonOptions& options)
{
    Progress progress (options.isQuiet);
    RenderOptions render;
    render.playback = options.playback();
    render.threshold = focus.felt->threshold;
    FeltTradeoff soFar;

    try
    {
        progress.show ("Designing", 0);
        return sweepFeltWeights (
            wideFrom (options, model), focus, render, widenBy (options),
            [&] (const FeltTradeoff& now)
            {
                soFar = now;
                progress.show ("Designing", static_cast<double> (now.points.size()) / static_cast<double> (now.planned),
                               formatted ("%zu of %zu designs", now.points.size(), now.planned));
            });
    }
    catch (const Cancelled&)
    {
        if (soFar.points.empty())
            throw;

        answerInterruption();
        return soFar;
    }
}

/** @param text  for the console */
void writeTradeoff (const CommonOptions& options, const nlohmann::ordered_json& json, const std::string& csv,
                    const ReportPage& page, const std::string& text)
{
    OutputFolder folder (options.folder);
    folder.write ("tradeoff.json", json.dump (2) + "\n");
    folder.write ("tradeoff.csv", csv);
    folder.write ("tradeoff.html", renderReport (page));
    folder.commit();

    if (! options.isQuiet)
        std::printf ("%s%s/tradeoff.html\n", text.c_str(), options.folder.c_str());
}

void sweepWeights (const ModalModel& model, const FocusDescription& focus, const CommonOptions& options)
{
    auto tradeoff = weightsSoFar (model, focus, options);

    for (auto& point : tradeoff.points)
        point.failure = withKeysAndOptions (point.failure);

    writeTradeoff (options, feltTradeoffToJson (tradeoff, focus.name, model.name), feltTradeoffToCsv (tradeoff),
                   feltTradeoffReport (tradeoff, focus.name, model.name), feltTradeoffToText (tradeoff));

    if (tradeoff.points.size() < tradeoff.planned)
        throw Cancelled();
}

void sweep (const CommonOptions& options)
{
    const auto [model, focus] = inputsFrom (options);

    if (focus.felt)
    {
        sweepWeights (model, completed (options, focus), options);
        return;
    }

    auto tradeoff = designsSoFar (model, focus, options);

    for (auto& point : tradeoff.points)
        point.failure = withKeysAndOptions (point.failure);

    writeTradeoff (options, tradeoffToJson (tradeoff, focus.name, model.name), tradeoffToCsv (tradeoff),
                   tradeoffReport (tradeoff, focus.name, model.name), tradeoffToText (tradeoff));

    if (tradeoff.points.size() < tradeoff.planned)
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
