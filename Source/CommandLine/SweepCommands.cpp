#include "CommandLine.h"
#include "SlurmArray.h"
#include "TaskCommand.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_reports/IdentificationTables.h>
#include <antinode_sweep/CaseEvaluator.h>
#include <antinode_sweep/PartFolder.h>
#include <antinode_sweep/SweepCases.h>
#include <antinode_sweep/SweepTable.h>
#include <antinode_tasks/Compare.h>
#include <antinode_tasks/Map.h>
#include <antinode_tasks/SweptFiles.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>

namespace antinode
{
namespace
{
void printMap (const MappedDevice& mapped, const std::string& folder)
{
    const auto& map = mapped.map;
    const auto print =
        [&] (const char* name, const char* unit, const std::function<std::optional<double> (const MapPlace&)>& value)
    {
        std::vector<double> values;

        for (const auto& place : map.places)
            if (const auto found = place.error.empty() ? value (place) : std::nullopt)
                values.push_back (*found);

        if (values.empty())
            return;

        std::sort (values.begin(), values.end());
        std::printf ("  %-14s %10.4g %10.4g %10.4g %s\n", name, values.front(), values[values.size() / 2],
                     values.back(), unit);
    };
    std::printf ("%s on %s: %td x %td places\n  %-14s %10s %10s %10s\n", map.focus.c_str(), map.device.c_str(),
                 map.columns, map.rows, "", "least", "median", "largest");
    print ("captured", "", [] (const MapPlace& place) { return place.captured; });
    print ("v-score", "", [] (const MapPlace& place) { return place.vScore; });
    print ("peak voltage", "V", [] (const MapPlace& place) { return place.peakVoltage; });
    print ("felt contrast", "dB", [] (const MapPlace& place) { return place.contrast; });

    const auto failed =
        std::count_if (map.places.begin(), map.places.end(), [] (const auto& place) { return ! place.error.empty(); });

    if (failed > 0)
        std::printf ("  %td places cannot be designed for; map.csv says why\n", failed);

    std::printf ("Maps: %s/report.html\n", folder.c_str());
}
} // namespace

void addMapCommand (CLI::App& app)
{
    addFolderTask (app, mapText, "antinode-out", &map, &writeMap, &printMap);
}

void addCompareCommand (CLI::App& app)
{
    addFolderTask (app, compareText, "antinode-out", &compare, &writeCompared,
                   [] (const ComparedDevices& compared, const std::string& folder) {
                       std::printf ("%sReport: %s/report.html\n", tableText (comparisonTable (compared.cases)).c_str(),
                                    folder.c_str());
                   });
}

namespace
{
struct SweepOptions
{
    std::string plan, folder = "antinode-out", shard, merged;
    std::optional<int> single;
    std::optional<std::string> slurm; // options of sbatch
    int threads = 0;                  // 0: all
    int tasks = 16;                   // of a Slurm array
    bool usesCache = true, isQuiet = false;
};

/** Writes what all parts of a folder say together. */
void finish (const PartFolder& folder, const SweepInputs& inputs, const std::string& path, bool isQuiet)
{
    const auto table = mergeParts (folder, inputs);
    const auto summary = summarise (table);
    writeSwept (path, table, summary);
    folder.tidy();

    if (! isQuiet)
        std::printf ("%s%s/report.html\n", sweepInWords (table, summary).c_str(), path.c_str());
}

void merge (const SweepOptions& options)
{
    const auto inputs = loadSweep (std::filesystem::path (options.merged) / "plan.json");
    finish (sweepFolder (options.merged, inputs), inputs, options.merged, options.isQuiet);
}

/** A case as text: its keys as --set takes them, and what is recorded of it. */
void printCase (const SweepOptions& options)
{
    const auto inputs = loadSweep (options.plan);
    const auto number = static_cast<std::uint64_t> (*options.single);

    if (number >= inputs.plan.cases)
        throw InputError ("--case", "is " + std::to_string (number) + "; allowed: 0 to "
                                        + std::to_string (inputs.plan.cases - 1));

    for (const auto& [key, value] : caseAssignments (inputs.plan, number))
        std::printf ("%s%s\n", key == "device" ? "--device " : ("--set " + key + "=").c_str(),
                     value.is_string() ? value.get<std::string>().c_str() : value.dump().c_str());

    const auto result = CaseEvaluator (inputs, options.usesCache).evaluate (number);
    const auto columns = sweepColumns (inputs.plan);

    if (! result.error.empty())
        throw InputError ("case " + std::to_string (number), result.error);

    for (std::size_t i = 0; i < columns.size(); ++i)
        std::printf ("%s = %s\n", columns[i].c_str(),
                     std::isfinite (result.values[i]) ? formatted ("%.17g", result.values[i]).c_str() : "none");
}

void compute (const CaseEvaluator& evaluator, const PartFolder& folder, SweepShard shard, const SweepOptions& options)
{
    const auto parts = folder.missing (shard);
    const auto all = folder.casesOf (parts);
    Progress progress (options.isQuiet);
    computeParts ([&] (std::uint64_t number) { return evaluator.evaluate (number); }, folder, parts,
                  options.threads > 0 ? static_cast<std::size_t> (options.threads) : processorThreads(),
                  [&] (std::uint64_t done)
                  {
                      progress.show ("Sweeping", static_cast<double> (done) / static_cast<double> (all),
                                     std::to_string (done) + " of " + std::to_string (all) + " cases");
                  });
}

/** Lets a cluster compute all parts, with this program and the folder as it is here. */
void computeOnCluster (const PartFolder& folder, const SweepOptions& options)
{
    SlurmArray array;
    array.program = std::filesystem::read_symlink ("/proc/self/exe");
    array.folder = std::filesystem::absolute (options.folder);
    array.options = *options.slurm;
    array.tasks = options.tasks;
    array.usesCache = options.usesCache;

    const auto all = static_cast<double> (folder.parts().size());
    Progress progress (options.isQuiet);
    computeBySlurm (folder, array,
                    [&] (std::size_t left, bool answers)
                    {
                        progress.show ("Sweeping on the cluster", 1 - static_cast<double> (left) / all,
                                       std::to_string (left) + " parts left"
                                           + (answers ? "" : "; Slurm does not answer"));
                    });
}

void sweepPlan (const SweepOptions& options)
{
    if (! options.merged.empty())
        return merge (options);

    if (options.plan.empty())
        throw InputError ("sweep", "needs a plan; allowed: a .json file, or --merge DIR");

    if (options.single)
        return printCase (options);

    const auto shard = options.shard.empty() ? SweepShard {} : readShard (options.shard);
    const CaseEvaluator evaluator (loadSweep (options.plan), options.usesCache);
    evaluator.check();
    const auto folder = sweepFolder (options.folder, evaluator.inputs());

    if (options.slurm)
        computeOnCluster (folder, options);
    else
        compute (evaluator, folder, shard, options);

    if (options.shard.empty())
        return finish (folder, evaluator.inputs(), options.folder, options.isQuiet);

    if (! options.isQuiet)
        std::printf ("Shard %s is done; when all are: antinode sweep --merge %s\n", options.shard.c_str(),
                     options.folder.c_str());
}
} // namespace

void addSweepCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "sweep", "Computes many cases of a plan: tables and statistics; resumable, also in shards on many computers");
    auto options = std::make_shared<SweepOptions>();
    const auto read = addFields (
        *command,
        { Field ("plan", &options->plan, "Plan: a .json file"),
          Field ("--out", &options->folder, "Folder of the parts and results"),
          Field ("--shard", &options->shard, "I/N: computes only every Nth part, from the Ith on, and does not merge")
              .written ("I/N"),
          Field ("--merge", &options->merged, "Merges the parts of all shards in this folder")
              .written ("DIR")
              .without ("plan")
              .without ("--out")
              .without ("--shard"),
          Field ("--case", &options->single, "Computes one case alone and prints it, from 0")
              .written ("N")
              .without ("--out")
              .without ("--shard"),
          Field ("--threads", &options->threads, "Cases at once").within (1, 1024).by ("one per processor"),
          Field ("--slurm", &options->slurm,
                 "Submits an array to Slurm with these options of sbatch, waits and merges, for example "
                 "--slurm='--partition=long'")
              .written ("OPTIONS")
              .without ("--shard"),
          Field ("--tasks", &options->tasks, "Tasks of the Slurm array").within (1, 10000).with ("--slurm"),
          cacheField (options->usesCache), quietField (options->isQuiet) });
    auto* const slurm = command->get_option ("--slurm")->expected (0, 1);
    command->callback (
        [options, read, slurm]
        {
            read();

            if (slurm->count() > 0) // Alone it stands for no options of sbatch.
                options->slurm = options->slurm.value_or ("");

            sweepPlan (*options);
        });
}
} // namespace antinode
