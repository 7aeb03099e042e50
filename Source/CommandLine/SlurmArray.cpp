#include "SlurmArray.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/System.h>
#include <antinode_base/Watch.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/OutputFolder.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>
#include <thread>
#include <vector>

namespace antinode
{
namespace
{
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int arraysWithoutPart = 3, refusalsForGood = 2;
constexpr int commandNotFound = 127; // of a shell
constexpr auto patienceAtFirst = 1min, patienceLater = 60min;
constexpr auto shortestPause = 1000ms, longestPause = 10000ms, look = 50ms;

/** A text as one word of a shell. */
std::string shellWord (const std::string& text)
{
    std::string word = "'";

    for (const auto letter : text)
        word += letter == '\'' ? std::string ("'\\''") : std::string (1, letter);

    return word + "'";
}

/** A path in which sbatch replaces nothing: %a would be the number of the task. */
std::string withoutPatterns (const std::string& path)
{
    std::string text;

    for (const auto letter : path)
        text += letter == '%' ? std::string ("%%") : std::string (1, letter);

    return text;
}

/** What a command did, with what it said of errors. */
CommandOutcome runCommand (const std::string& command)
{
    auto outcome = runShellCommand (command + " 2>&1");

    if (! outcome)
        throw InputError ("--slurm", "no command can be started");

    return *outcome;
}

std::vector<std::string> linesOf (const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream (text);

    for (std::string line; std::getline (stream, line);)
        lines.push_back (line);

    return lines;
}

/** What a command said, for an error: without the ends of its lines. */
std::string oneLine (const std::string& text)
{
    std::string joined;

    for (const auto& line : linesOf (text))
        joined += (joined.empty() ? "" : "; ") + line;

    return joined;
}

/** Whether an array waits or runs; nothing where Slurm does not answer, which is no answer. */
std::optional<bool> isQueued (const std::string& job)
{
    const auto outcome = runCommand (slurmListing (job));

    if (outcome.exitCode != 0)
        return {};

    const auto number = job.substr (0, job.find (';'));
    const auto lines = linesOf (outcome.printed);
    return std::any_of (lines.begin(), lines.end(),
                        [&] (const auto& line) { return line.substr (0, line.find (' ')) == number; });
}

void rest (Clock::duration pause)
{
    for (const auto end = Clock::now() + pause; Clock::now() < end;)
    {
        checkWatch();
        std::this_thread::sleep_for (look);
    }
}

/** Where the array is noted, so that a run that takes over finds it. */
std::filesystem::path noteFile (const SlurmArray& array)
{
    return array.folder / "slurm.job";
}

/** @param patience  how long a controller is waited for that does not answer */
std::string submit (const SlurmArray& array, Clock::duration patience)
{
    writeWholeFile (slurmScriptFile (array), slurmScript (array));
    const auto end = Clock::now() + patience;

    for (int refusals = 0;;)
    {
        const auto outcome = runCommand (slurmSubmission (array));
        auto job = slurmJobIn (outcome.printed);

        if (outcome.exitCode == 0 && ! job.empty())
        {
            writeWholeFile (noteFile (array), job + "\n");
            return job;
        }

        // While a controller starts, sbatch fails as it does where options are wrong; then the controller answers.
        if (outcome.exitCode == commandNotFound || (isQueued ({}).has_value() && ++refusals == refusalsForGood)
            || Clock::now() > end)
            throw InputError ("--slurm", "sbatch failed: " + printable (oneLine (outcome.printed), 300));

        rest (shortestPause);
    }
}

/** Waits until an array has ended, or all parts are there: then what is left of it has nothing to do. */
void waitForArray (const std::string& job, const PartFolder& folder,
                   const std::function<void (std::size_t, bool)>& show)
{
    for (Clock::duration pause = shortestPause; folder.written() < folder.parts().size();
         pause = std::min<Clock::duration> (pause * 5 / 4, longestPause))
    {
        const auto queued = isQueued (job);

        if (queued && ! *queued)
            return;

        show (folder.parts().size() - folder.written(), queued.has_value());
        rest (pause);
    }
}

/** The array that a run before has submitted, where it still waits or runs; otherwise empty. */
std::string arrayInQueue (const SlurmArray& array)
{
    std::error_code error;

    if (! std::filesystem::exists (noteFile (array), error))
        return {};

    const auto job = slurmJobIn (readWholeFile (noteFile (array), { "the number of a job" }));
    return ! job.empty() && isQueued (job).value_or (false) ? job : std::string();
}
} // namespace

std::filesystem::path slurmScriptFile (const SlurmArray& array)
{
    return array.folder / "sweep.sbatch";
}

std::string slurmScript (const SlurmArray& array)
{
    return "#!/bin/sh\nexec " + shellWord (array.program.string()) + " sweep "
           + shellWord ((array.folder / "plan.json").string()) + " --out " + shellWord (array.folder.string())
           + " --shard \"$SLURM_ARRAY_TASK_ID/" + std::to_string (array.tasks)
           + "\" --threads \"${SLURM_CPUS_PER_TASK:-1}\" --quiet" + (array.usesCache ? "\n" : " --no-cache\n");
}

std::string slurmSubmission (const SlurmArray& array)
{
    return "sbatch --parsable --requeue --array=1-" + std::to_string (array.tasks)
           + " --output=" + shellWord (withoutPatterns (array.folder.string()) + "/slurm-%a.log")
           + (array.options.empty() ? "" : " " + array.options) + " " + shellWord (slurmScriptFile (array).string());
}

std::string slurmJobIn (const std::string& printed)
{
    for (const auto& line : linesOf (printed))
        if (const auto digits = line.find_first_not_of ("0123456789");
            digits > 0 && ! line.empty() && (digits == std::string::npos || line[digits] == ';'))
            return line;

    return {};
}

std::string slurmListing (const std::string& job)
{
    const auto cluster = job.find (';');
    return "squeue --noheader --user=" + std::to_string (ownUser()) + " --format=%F"
           + (cluster == std::string::npos ? "" : " --clusters=" + shellWord (job.substr (cluster + 1)));
}

void computeBySlurm (const PartFolder& folder, const SlurmArray& array,
                     const std::function<void (std::size_t, bool)>& show)
{
    auto missing = folder.missing ({}).size();
    auto job = missing > 0 ? arrayInQueue (array) : std::string();
    Clock::duration patience = patienceAtFirst;

    for (int fruitless = 0; missing > 0;)
    {
        auto next = array;
        next.tasks = static_cast<int> (std::min<std::size_t> (array.tasks, missing));

        if (job.empty())
            job = submit (next, patience);

        waitForArray (job, folder, show);
        job.clear();
        patience = patienceLater;
        const auto left = folder.missing ({}).size();
        fruitless = left < missing ? 0 : fruitless + 1;
        missing = left;

        if (fruitless == arraysWithoutPart)
            throw InputError ("--slurm", std::to_string (fruitless)
                                             + " arrays in a row ended without a finished part; the logs "
                                             + printable ((array.folder / "slurm-*.log").string(), 300) + " say why");
    }

    std::error_code ignored;
    std::filesystem::remove (noteFile (array), ignored);
}
} // namespace antinode
