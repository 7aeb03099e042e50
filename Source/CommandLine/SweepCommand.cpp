#include "Commands.h"
#include "CommonOptions.h"
#include "FieldNames.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_reports/SweepReport.h>
#include <antinode_sweep/SweepCases.h>
#include <antinode_sweep/SweepSummary.h>
#include <antinode_text/OutputFolder.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

namespace antinode
{
namespace
{
struct SweepOptions
{
    std::string plan, folder = "antinode-out", shard, merged;
    std::optional<std::uint64_t> single;
    std::optional<std::string> slurm; // options of sbatch
    int threads = 0;                  // 0: all
    int tasks = 16;                   // of a Slurm array
    bool usesCache = true, isQuiet = false;
};

/** Writes what all parts of a folder say together. */
void finish (const SweepFolder& folder, const SweepInputs& inputs, const std::string& path, bool isQuiet)
{
    const auto table = mergeParts (folder, inputs);
    const auto summary = summarise (table);
    OutputFolder output (path);
    output.write ("results.csv", sweepToCsv (table, withKeysAndOptions));
    output.write ("results.mat", sweepToMatlab (table));
    output.write ("report.html", renderReport (sweepReport (table, summary)));
    output.write ("summary.json", sweepToJson (table, summary).dump (2) + "\n");
    output.commit();
    folder.tidy();

    if (! isQuiet)
        std::printf ("%s%s/report.html\n", sweepInWords (table, summary).c_str(), path.c_str());
}

void merge (const SweepOptions& options)
{
    const auto inputs = loadSweep (std::filesystem::path (options.merged) / "plan.json");
    finish (SweepFolder (options.merged, inputs), inputs, options.merged, options.isQuiet);
}

/** A case as text: its keys as --set takes them, and what is recorded of it. */
void printCase (const SweepOptions& options)
{
    const auto inputs = loadSweep (options.plan);
    const auto number = *options.single;

    if (number >= inputs.plan.cases)
        throw InputError ("--case", "is " + std::to_string (number) + "; allowed: 0 to "
                                        + std::to_string (inputs.plan.cases - 1));

    for (const auto& [key, value] : caseAssignments (inputs.plan, number))
        std::printf ("--set %s=%s\n", key.c_str(),
                     value.is_string() ? value.get<std::string>().c_str() : value.dump().c_str());

    const auto result = CaseEvaluator (inputs, options.usesCache).evaluate (number);
    const auto columns = sweepColumns (inputs.plan);

    if (! result.error.empty())
        throw InputError ("case " + std::to_string (number), result.error);

    for (std::size_t i = 0; i < columns.size(); ++i)
        std::printf ("%s = %s\n", columns[i].c_str(),
                     std::isfinite (result.values[i]) ? formatted ("%.17g", result.values[i]).c_str() : "none");
}

void compute (const CaseEvaluator& evaluator, const SweepFolder& folder, SweepShard shard, const SweepOptions& options)
{
    const auto parts = folder.missing (shard);
    std::uint64_t all = 0;

    for (const auto part : parts)
        all += folder.parts()[part].count;

    Progress progress (options.isQuiet);
    computeParts (evaluator, folder, parts,
                  options.threads > 0 ? static_cast<std::size_t> (options.threads) : processorThreads(),
                  [&] (std::uint64_t done)
                  {
                      progress.show ("Sweeping", static_cast<double> (done) / static_cast<double> (all),
                                     std::to_string (done) + " of " + std::to_string (all) + " cases");
                  });
}

/** A text as one word of a shell. */
std::string shellWord (const std::string& text)
{
    std::string word = "'";

    for (const auto letter : text)
        word += letter == '\'' ? std::string ("'\\''") : std::string (1, letter);

    return word + "'";
}

/** What a command prints. @throws InputError  where it fails */
std::string outputOf (const std::string& command)
{
    std::string output;
    std::array<char, 256> some {};
    auto* const pipe = popen (command.c_str(), "re");

    while (pipe != nullptr && std::fgets (some.data(), some.size(), pipe) != nullptr)
        output += some.data();

    if (pipe == nullptr || pclose (pipe) != 0)
        throw InputError ("--slurm", "the command '" + command.substr (0, command.find (' ')) + "' failed");

    return output;
}

/** An array of jobs, each of which takes every so many-th part. @return  its number */
std::string submitArray (const SweepOptions& options, int tasks)
{
    const auto folder = std::filesystem::absolute (options.folder).string();
    const auto program = std::filesystem::read_symlink ("/proc/self/exe").string();
    const auto script = folder + "/sweep.sbatch";
    writeWholeFile (script, "#!/bin/sh\nexec " + shellWord (program) + " sweep " + shellWord (folder + "/plan.json")
                                + " --out " + shellWord (folder) + " --shard \"$SLURM_ARRAY_TASK_ID/"
                                + std::to_string (tasks) + "\" --threads \"${SLURM_CPUS_PER_TASK:-1}\" --quiet"
                                + (options.usesCache ? "\n" : " --no-cache\n"));
    const auto job =
        outputOf ("sbatch --parsable --requeue --array=1-" + std::to_string (tasks) + " --output="
                  + shellWord (folder + "/slurm-%a.log") + " " + *options.slurm + " " + shellWord (script));
    return job.substr (0, job.find_first_of (";\n"));
}

/** Lets a cluster compute all parts. What is still missing when its jobs have ended is submitted again. */
void computeBySlurm (const SweepFolder& folder, const SweepOptions& options)
{
    using namespace std::chrono_literals;
    constexpr int rounds = 3;
    Progress progress (options.isQuiet);

    for (int round = 0; round < rounds; ++round)
    {
        auto missing = folder.missing ({}).size();

        if (missing == 0)
            return;

        const auto job = submitArray (options, static_cast<int> (std::min<std::size_t> (options.tasks, missing)));

        while (! outputOf ("squeue --noheader --array --jobs=" + shellWord (job) + " 2>/dev/null || true").empty())
        {
            checkWatch();
            missing = folder.missing ({}).size();
            progress.show ("Sweeping on the cluster",
                           1 - static_cast<double> (missing) / static_cast<double> (folder.parts().size()),
                           std::to_string (missing) + " parts left");
            std::this_thread::sleep_for (1s);
        }
    }
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
    const SweepFolder folder (options.folder, evaluator.inputs());

    if (options.slurm)
        computeBySlurm (folder, options);
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
    auto* plan = command->add_option ("plan", options->plan, "Plan: a .json file");
    auto* out =
        command->add_option ("--out", options->folder, "Folder of the parts and results")->capture_default_str();
    auto* shard = command->add_option ("--shard", options->shard,
                                       "I/N: computes only every Nth part, from the Ith on, and does not merge");
    shard->type_name ("I/N");
    command->add_option ("--merge", options->merged, "Merges the parts of all shards in this folder")
        ->type_name ("DIR")
        ->excludes (plan)
        ->excludes (out)
        ->excludes (shard);
    command->add_option ("--case", options->single, "Computes one case alone and prints it, from 0")
        ->type_name ("N")
        ->excludes (out)
        ->excludes (shard);
    command->add_option ("--threads", options->threads, "Cases at once; default: one per processor")
        ->check (CLI::Range (1, 1024))
        ->type_name ("INT");
    auto* slurm = command->add_option ("--slurm", options->slurm,
                                       "Submits an array to Slurm with these options of sbatch, waits and merges, for "
                                       "example --slurm='--partition=long'");
    slurm->type_name ("OPTIONS")->expected (0, 1)->excludes (shard);
    command->add_option ("--tasks", options->tasks, "Tasks of the Slurm array")
        ->needs (slurm)
        ->check (CLI::Range (1, 10000))
        ->capture_default_str();
    addCacheFlag (*command, options->usesCache);
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { sweepPlan (*options); });
}
} // namespace antinode
