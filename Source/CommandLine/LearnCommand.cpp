#include "Commands.h"
#include "FolderTask.h"

#include <antinode_learning/LearningVerdict.h>
#include <antinode_render/LagOutcome.h>
#include <antinode_tasks/LearnFiles.h>

#include <cstdio>

namespace antinode
{
namespace
{
void printLearnt (const LearntDevice& device, const std::string& folder)
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
        std::printf ("  sensors held back: %.2g %% not predicted by the others, %.2g %% by the previous device\n",
                     100 * learnt.learnt.heldBack, 100 * learnt.learnt.heldBackBefore);

    if (! learnt.refusal.empty())
        std::printf ("  %s%s\n", keptInWords (learnt).c_str(), learnt.refusal.c_str());

    if (const auto warning = warningOf (learnt); ! warning.empty())
        std::printf ("  %s\n", warning.c_str());

    if (needsLagFilters (setup.nominal.model))
        std::printf ("  lags of ceramics: %s\n", lagsInWords (learntOutputs (learnt, settings)).c_str());

    std::printf ("Next voltages and what was learnt: %s/voltages.wav, report.html\n", folder.c_str());
}

std::vector<Field> audioFields (LearnRequest& request)
{
    std::vector<Field> all {
        Field ("--play", &request.isPlayed,
               "Plays and records through an audio device: ceramics from output 1 up, sensors at --sensor-input")
            .as ({}),
        Field ("--idle-ma-per-v", &request.idleScale, "Current of an idle ceramic per volt at its input, mA per V")
            .within (1e-9, 1e9)
    };
    append (all, fields (request.wiring));
    return all;
}
} // namespace

void addLearnCommand (CLI::App& app)
{
    addFolderTask (app, learnText, "antinode-learnt", &learn, &writeLearnt, &printLearnt, &audioFields);
}
} // namespace antinode
