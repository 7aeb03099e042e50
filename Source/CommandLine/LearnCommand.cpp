#include "Commands.h"
#include "FieldOptions.h"
#include "Progress.h"

#include <antinode_learning/LearningVerdict.h>
#include <antinode_render/LagOutcome.h>
#include <antinode_tasks/LearnFiles.h>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct LearnOptions
{
    LearnRequest request;
    std::filesystem::path folder = "antinode-learnt";
    bool isQuiet = false;
};

void print (const std::string& folder, const LearntDevice& device)
{
    const auto& [setup, settings, learnt] = device;
    std::printf ("%s on %s\n", setup.focus.name.c_str(), setup.nominal.model.name.c_str());
    std::printf ("  %-6s %22s %34s\n", "pass", "field error (estimated)", "not predicted, of the noise (nominal)");

    for (std::size_t i = 0; i < learnt.passes.size(); ++i)
        std::printf ("  %-6zu %21.2f %% %24.1f (%.1f)\n", i + 1, 100 * learnt.passes[i].estimatedError,
                     learnt.passes[i].surprise, learnt.passes[i].nominalSurprise);

    if (! learnt.passes.empty())
        std::printf ("  not explained in the end: %.2g %% of the signals, %.2f of the noise\n",
                     100 * learnt.learnt.unexplained, learnt.learnt.residual);

    if (learnt.learnt.heldBackBefore > 0)
        std::printf ("  sensors held back: %.2g %% not predicted by the others, %.2g %% by the device as it was\n",
                     100 * learnt.learnt.heldBack, 100 * learnt.learnt.heldBackBefore);

    if (! learnt.refusal.empty())
        std::printf ("  %s%s\n", keptInWords (learnt).c_str(), learnt.refusal.c_str());

    if (const auto warning = warningOf (learnt); ! warning.empty())
        std::printf ("  %s\n", warning.c_str());

    if (needsLagFilters (setup.nominal.model))
        std::printf ("  lags of ceramics: %s\n", lagsInWords (learntOutputs (learnt, settings)).c_str());

    std::printf ("Next voltages and what was learnt: %s/voltages.wav, report.html\n", folder.c_str());
}
} // namespace

void addLearnCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (learnText.name, learnText.summary);
    auto options = std::make_shared<LearnOptions>();
    auto& request = options->request;
    auto all = fields (request);
    append (
        all,
        { Field ("--play", &request.isPlayed,
                 "Plays and records through an audio device: ceramics from output 1 on, sensors as --sensor-input "
                 "says"),
          Field ("--idle-ma-per-v", &request.idleScale, "Current of an idle ceramic per volt at its input, mA per V")
              .within (1e-9, 1e9) });
    append (all, fields (request.wiring));
    append (all, { Field ("--out", &options->folder, "Output folder"), quietField (options->isQuiet) });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            Progress progress (options->isQuiet);
            const auto learnt = learn (options->request, progress.shown());
            writeLearnt (options->folder, learnt);

            if (! options->isQuiet)
                print (options->folder.string(), learnt);
        });
}
} // namespace antinode
