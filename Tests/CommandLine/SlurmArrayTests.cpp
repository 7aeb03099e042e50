#include <CommandLine/SlurmArray.h>

#include "Support/ErrorText.h"
#include "Support/RunProgram.h"
#include "Support/TemporaryFolder.h"

#include <antinode_sweep/PartFolder.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <map>

#include <unistd.h>

using namespace antinode;

namespace
{
SlurmArray arrayIn (const std::filesystem::path& folder)
{
    return { "/opt/anti node/antinode", folder, "--partition=long --time=1:00:00", 20, true };
}

/** Programs that stand in for those of Slurm, first in the path as long as this lives. */
class SlurmCommands
{
public:
    explicit SlurmCommands (const std::map<std::string, std::string>& bodies)
    {
        for (const auto& [name, body] : bodies)
        {
            std::ofstream (folder.path() / name) << "#!/bin/sh\necho " << name << " >>'" << calls().string() << "'\n"
                                                 << body << "\n";
            std::filesystem::permissions (folder.path() / name, std::filesystem::perms::owner_all);
        }

        setenv ("PATH", (folder.path().string() + ":" + before).c_str(), 1);
    }

    ~SlurmCommands() { setenv ("PATH", before.c_str(), 1); }
    SlurmCommands (const SlurmCommands&) = delete;
    SlurmCommands& operator= (const SlurmCommands&) = delete;

    std::string called() const { return test::readContent (calls()); }

private:
    std::filesystem::path calls() const { return folder.path() / "calls"; }

    const TemporaryFolder folder;
    const std::string before = std::getenv ("PATH");
};

/** A sweep of four cases in a folder, as an array of two tasks. */
struct SmallSweep
{
    const TemporaryFolder folder;
    SweepInputs inputs = sweepInputs (
        nlohmann::json::parse (
            R"({"schema": "antinode.sweep/1", "focus": "demonstrator", "device": "beam", "scheme": "random", "cases": 4,
            "evaluate": "closed_form", "record": ["peak_ratio"],
            "vary": [{"key": "deviation.damping_percent", "uniform": {"minimum": -10, "maximum": 10}}]})"),
        "plan");
    PartFolder parts = sweepFolder (folder.path() / "out", inputs);
    SlurmArray array { ANTINODE_PROGRAM, folder.path() / "out", "", 2, false };

    void compute() const
    {
        computeBySlurm (parts, array, [] (std::size_t, bool) {});
    }
};

/** sbatch that runs all tasks at once. */
const std::string runTasks =
    "for script; do :; done\nfor task in 1 2; do SLURM_ARRAY_TASK_ID=$task sh \"$script\"; done\necho 17";
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

TEST_CASE ("Shards of a Slurm array are all parts of a sweep", "[slurm]")
{
    const SmallSweep sweep;
    const SlurmCommands commands ({ { "sbatch", runTasks }, { "squeue", "" } });
    sweep.compute();
    CHECK (sweep.parts.missing ({}).empty());
    CHECK (commands.called() == "sbatch\n");
    CHECK_FALSE (std::filesystem::exists (sweep.array.folder / "slurm.job"));

    // All is there: nothing is submitted.
    sweep.compute();
    CHECK (commands.called() == "sbatch\n");
}

TEST_CASE ("Arrays are submitted until three in a row end without a part", "[slurm]")
{
    const SmallSweep sweep;
    const SlurmCommands commands ({ { "sbatch", "echo 17" }, { "squeue", "" } });
    CHECK_THAT (errorText ([&] { sweep.compute(); }),
                Catch::Contains ("3 arrays in a row ended without a finished part") && Catch::Contains ("slurm-*.log"));
    CHECK (commands.called() == "sbatch\nsqueue\nsbatch\nsqueue\nsbatch\nsqueue\n");
}

TEST_CASE ("What Slurm refuses while it answers is refused for good, in its words", "[slurm]")
{
    const SmallSweep sweep;
    const SlurmCommands commands ({ { "sbatch", "echo 'invalid partition: long' >&2; exit 1" }, { "squeue", "" } });
    CHECK (errorText ([&] { sweep.compute(); }) == "--slurm: sbatch failed: invalid partition: long");
}

TEST_CASE ("Where there is no Slurm, a sweep says so at once", "[slurm]")
{
    const SmallSweep sweep;
    const SlurmCommands commands ({ { "sbatch", "exit 127" }, { "squeue", "exit 127" } });
    CHECK_THAT (errorText ([&] { sweep.compute(); }), Catch::StartsWith ("--slurm: sbatch failed: "));
    CHECK (commands.called() == "sbatch\n");
}

TEST_CASE ("An array that a client before has left is watched, not submitted again", "[slurm]")
{
    const SmallSweep sweep;
    std::ofstream (sweep.array.folder / "slurm.job") << "17\n";
    const auto script = slurmScriptFile (sweep.array).string();
    std::ofstream (script) << slurmScript (sweep.array);

    // It is there when it is looked for, and has computed all when it is looked for again.
    const SlurmCommands commands ({ { "sbatch", "exit 1" }, { "squeue", "set -- '" + script + "'\n" + runTasks } });
    sweep.compute();
    CHECK (sweep.parts.missing ({}).empty());
    CHECK (commands.called() == "squeue\n");
}

TEST_CASE ("A controller that does not answer has not ended its arrays", "[slurm]")
{
    const SmallSweep sweep;
    const auto script = slurmScriptFile (sweep.array).string();

    // The tasks run while the controller is away: twice it fails.
    const SlurmCommands commands ({ { "sbatch", "echo 17" },
                                    { "squeue", "set -- '" + script + "'\n[ -e \"$0.once\" ] && { " + "\n" + runTasks
                                                    + " >/dev/null\n}\n: >\"$0.once\"\nexit 1" } });
    sweep.compute();
    CHECK (sweep.parts.missing ({}).empty());
    CHECK (commands.called() == "sbatch\nsqueue\nsqueue\n");
}
