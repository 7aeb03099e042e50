#include <CommandLine/SlurmArray.h>

#include "Support/TemporaryFolder.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

#include <unistd.h>

using namespace antinode;

namespace
{
SlurmArray arrayIn (const std::filesystem::path& folder)
{
    return { "/opt/anti node/antinode", folder, "--partition=long --time=1:00:00", 20, true };
}
} // namespace

TEST_CASE ("The script of a Slurm array computes the shard of its task with the processors of its task", "[slurm]")
{
    auto array = arrayIn ("/shared/tolerance");
    CHECK (slurmScript (array)
           == "#!/bin/sh\n"
              "exec '/opt/anti node/antinode' sweep '/shared/tolerance/plan.json' --out '/shared/tolerance' --shard "
              "\"$SLURM_ARRAY_TASK_ID/20\" --threads \"${SLURM_CPUS_PER_TASK:-1}\" --quiet\n");

    array.usesCache = false;
    CHECK_THAT (slurmScript (array), Catch::EndsWith (" --quiet --no-cache\n"));
}

TEST_CASE ("Options of the user come after those of the array, so that they override them", "[slurm]")
{
    CHECK (slurmSubmission (arrayIn ("/shared/tolerance"))
           == "sbatch --parsable --requeue --array=1-20 --output='/shared/tolerance/slurm-%a.log' --partition=long "
              "--time=1:00:00 '/shared/tolerance/sweep.sbatch'");
}

TEST_CASE ("sbatch replaces nothing in the name of the folder, and a shell takes it as one word", "[slurm]")
{
    auto array = arrayIn ("/shared/5%a's");
    array.options.clear();
    CHECK (slurmSubmission (array)
           == "sbatch --parsable --requeue --array=1-20 --output='/shared/5%%a'\\''s/slurm-%a.log' "
              "'/shared/5%a'\\''s/sweep.sbatch'");
}

TEST_CASE ("A shell runs the script with the words that it was made of", "[slurm]")
{
    const TemporaryFolder folder;
    const auto program = folder.path() / "it's a $program";
    std::ofstream (program) << "#!/bin/sh\nfor word; do echo \"<$word>\"; done >'" << (folder.path() / "words").string()
                            << "'\n";
    std::filesystem::permissions (program, std::filesystem::perms::owner_all);
    auto array = arrayIn ("/shared/5%a's \"$HOME\"");
    array.program = program;
    std::ofstream (folder.path() / "script") << slurmScript (array);
    const auto command = "SLURM_ARRAY_TASK_ID=7 SLURM_CPUS_PER_TASK=4 sh '" + (folder.path() / "script").string() + "'";
    REQUIRE (std::system (command.c_str()) == 0);
    std::ifstream words (folder.path() / "words");
    CHECK (std::string (std::istreambuf_iterator<char> (words), {})
           == "<sweep>\n</shared/5%a's \"$HOME\"/plan.json>\n<--out>\n</shared/5%a's "
              "\"$HOME\">\n<--shard>\n<7/20>\n<--threads>\n<4>\n<--quiet>\n");
}

TEST_CASE ("The number of an array is found among warnings of sbatch", "[slurm]")
{
    CHECK (slurmJobIn ("17\n") == "17");
    CHECK (slurmJobIn ("17;north\n") == "17;north");
    CHECK (slurmJobIn ("sbatch: warning: 3 nodes are down\n42\n") == "42");
    CHECK (slurmJobIn ("12 nodes are down\n").empty());
    CHECK (slurmJobIn (";north\n").empty());
    CHECK (slurmJobIn ("sbatch: error: invalid partition specified: long\n").empty());
    CHECK (slurmJobIn ("").empty());
}

TEST_CASE ("Arrays are looked for among those of the user, on the cluster that took them", "[slurm]")
{
    const auto own = "squeue --noheader --user=" + std::to_string (getuid()) + " --format=%F";
    CHECK (slurmListing ("17") == own);
    CHECK (slurmListing ("17;north") == own + " --clusters='north'");
}
