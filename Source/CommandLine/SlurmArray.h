#pragma once

#include <antinode_sweep/PartFolder.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace antinode
{
/** A sweep as an array of jobs of Slurm, each of which computes a shard. */
struct SlurmArray
{
    std::filesystem::path program; ///< Absolute, as all nodes see it.
    std::filesystem::path folder;  ///< Absolute: of the sweep, with its plan.json.
    std::string options;           ///< Of sbatch, as a shell reads them.
    int tasks = 16;
    bool usesCache = true;
};

/** The script of each task. [any] Docs/Design/sweeps.md. */
std::string slurmScript (const SlurmArray&);

/** Where that script is kept. [any] */
std::filesystem::path slurmScriptFile (const SlurmArray&);

/** The command for a shell that submits the script. Options of the user come last: they override. [any] */
std::string slurmSubmission (const SlurmArray&);

/** The array in what `sbatch --parsable` prints, also with warnings: "17", or "17;name" where another cluster took it;
    empty where there is none. [any] */
std::string slurmJobIn (const std::string& printed);

/** The command for a shell that lists the arrays of this user, one number a line. @param job  as slurmJobIn [any] */
std::string slurmListing (const std::string& job);

/** Lets a cluster compute the parts that are missing. What is still missing when an array has ended is submitted again,
    as long as every third array at least has finished a part. An array that a run before has left is watched, not
    submitted again. A controller that does not answer is waited for.
    @param show  called now and then with how many parts are left, and whether Slurm answers
    @throws InputError  when Slurm refuses the array or is not there, or arrays end without a part
    @throws Cancelled   when a watch of this thread says no; the array goes on
    [worker] Docs/Design/sweeps.md. */
void computeBySlurm (const PartFolder&, const SlurmArray&, const std::function<void (std::size_t, bool)>& show);
} // namespace antinode
