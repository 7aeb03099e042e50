#include "Commands.h"
#include "FieldOptions.h"
#include "Progress.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/MatlabTables.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/ExpectedError.h>
#include <antinode_focus/LimitWords.h>
#include <antinode_tasks/Tolerance.h>
#include <antinode_tasks/Tradeoffs.h>
#include <antinode_text/OutputFolder.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace antinode
{
namespace
{
struct DesignOptions
{
    ToleranceRequest request;
    std::filesystem::path folder = "antinode-out";
    bool hasTolerance = false, isTradeoff = false, isForMatlab = false, isQuiet = false;
};

void print (const DesignedFocus& designed, const FocusPower& power)
{
    const auto& result = designed.made.design;
    const auto model = ownModel (designed);
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
}

void runDesign (DesignOptions& options)
{
    auto& request = options.request;
    const auto designed = std::make_shared<const DesignedFocus> (design (request.design, {}));
    const auto power = designedPower (*designed);
    std::optional<DesignOnDevices> played;
    OutputFolder folder (options.folder);
    folder.write ("design.json", designFileText (*designed, power));

    if (options.isForMatlab)
        folder.write ("design.mat", encodeDesignForMatlab (designed->made.design, designedModel (designed->made.wide)));

    if (options.hasTolerance)
    {
        Progress progress (options.isQuiet);
        request.made = designed;
        request.folder = options.folder / "tolerance-draws";
        played = tolerance (request, progress.shown());
        writeTolerances (folder, *played);
    }

    folder.commit();
    std::error_code ignored;
    std::filesystem::remove_all (options.folder / "tolerance-draws", ignored);

    if (options.isQuiet)
        return;

    print (*designed, power);

    if (played)
        std::printf ("%s%s/tolerance.html\n", tolerancesInWords (*played).c_str(), options.folder.c_str());

    std::printf ("%s/design.json\n", options.folder.c_str());
}

/** All designs, or those that were finished when the user interrupted. @throws Cancelled  where there are none */
DesignTradeoff designsSoFar (const DesignOptions& options)
{
    const auto& request = options.request.design;
    Progress progress (options.isQuiet);
    progress.show (request.focus.felt ? "Designing" : "Finding the lower bound", 0);
    DesignTradeoff soFar;

    try
    {
        return designTradeoff (request,
                               [&] (const DesignTradeoff& now, double share)
                               {
                                   soFar = now;
                                   progress.show ("Designing", share,
                                                  formatted ("%zu of %zu designs", now.designs(), now.planned()));
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

void sweep (const DesignOptions& options)
{
    const auto tradeoff = designsSoFar (options);
    writeTradeoff (options.folder, tradeoff);

    if (! options.isQuiet)
        std::printf ("%s%s/tradeoff.html\n", tradeoffInWords (tradeoff).c_str(), options.folder.c_str());

    if (tradeoff.designs() < tradeoff.planned())
        throw Cancelled();
}
} // namespace

void printPower (const ModalModel& model, const FocusPower& power)
{
    const std::array headings { "current", "power", "amplifier" };
    const auto sentences = powerInWords (model, power);

    for (std::size_t i = 0; i < sentences.size(); ++i)
        std::printf ("  %-14s %s\n", sentences.size() == 1 ? "power" : headings[i], sentences[i].c_str());
}

void addDesignCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("design", "Computes the voltages of a focus and writes design.json");
    auto options = std::make_shared<DesignOptions>();
    auto& request = options->request;
    const std::string tolerance = "--tolerance";
    auto all = fields (request.design);
    append (all, { Field ("--out", &options->folder, "Output folder"), quietField (options->isQuiet),
                   Field (tolerance, &options->hasTolerance,
                          "Computes the field error on devices that differ from the model") });

    for (auto& field : spreadFields (request))
        all.push_back (field.with (tolerance));

    append (all,
            { Field ("--mat", &options->isForMatlab, "Also writes drives and allocation as design.mat"),
              Field ("--tradeoff", &options->isTradeoff,
                     "Compares all methods and growths instead: peak voltage against time in motion; of a focus with "
                     "'felt' its weights: peak voltage against felt contrast")
                  .without (tolerance)
                  .without ("--mat") });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            options->isTradeoff ? sweep (*options) : runDesign (*options);
        });
}
} // namespace antinode
