#include "Support/ErrorText.h"
#include "Support/RunProgram.h"
#include "Support/TemporaryFolder.h"

#include <antinode_text/OutputFolder.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

using namespace antinode;
using namespace antinode::test;
namespace fs = std::filesystem;

namespace
{
std::set<std::string> namesIn (const fs::path& folder, bool hidden = false)
{
    std::set<std::string> names;

    for (const auto& entry : fs::directory_iterator (folder))
        if (const auto name = entry.path().filename().string(); name.starts_with ('.') == hidden)
            names.insert (name);

    return names;
}

/** A process that runs an action until it ends or is killed. */
pid_t startProcess (const std::function<void()>& action)
{
    const auto process = fork();

    if (process == 0)
    {
        action();
        _exit (0);
    }

    return process;
}

void waitFor (pid_t process)
{
    int status = 0;
    REQUIRE (waitpid (process, &status, 0) == process);
}
} // namespace

TEST_CASE ("Files appear at the commit and not before", "[files]")
{
    const TemporaryFolder scratch;
    const auto target = scratch.path() / "a" / "b";
    OutputFolder output (target);
    output.write ("summary.json", "{}");
    output.write ("probe.csv", std::string (100000, 'x'));
    std::ofstream (output.pathFor ("voltages.wav")) << "RIFF";
    CHECK (namesIn (target).empty());

    output.commit();
    CHECK (namesIn (target) == std::set<std::string> { "summary.json", "probe.csv", "voltages.wav" });
    CHECK (namesIn (target, true).empty());
    CHECK (readContent (target / "probe.csv").size() == 100000);
    CHECK (readContent (target / "voltages.wav") == "RIFF");
}

TEST_CASE ("Without a commit nothing appears and nothing old is lost", "[files]")
{
    const TemporaryFolder scratch;
    const auto old = scratch.path() / "old", fresh = scratch.path() / "fresh";

    {
        OutputFolder output (old);
        output.write ("summary.json", "first");
        output.commit();
    }
    {
        OutputFolder intoOld (old), intoFresh (fresh);
        intoOld.write ("summary.json", "second");
        intoFresh.write ("summary.json", "second");
    }

    CHECK (readContent (old / "summary.json") == "first");
    CHECK (namesIn (old, true).empty());
    CHECK_FALSE (fs::exists (fresh));
}

TEST_CASE ("A relative output folder stays where it was when the program changes its own", "[files]")
{
    const TemporaryFolder scratch;
    const auto before = fs::current_path();
    fs::current_path (scratch.path());
    OutputFolder output ("out");
    fs::current_path (before);
    output.write ("summary.json", "{}");
    output.commit();
    CHECK (readContent (scratch.path() / "out" / "summary.json") == "{}");
}

TEST_CASE ("Output folders that cannot be are refused", "[files]")
{
    const TemporaryFolder scratch;
    const auto file = scratch.path() / "file";
    std::ofstream (file) << "text";
    const auto error = [] (const fs::path& path) { return errorText ([&] { const OutputFolder output (path); }); };

    CHECK (error (file) == file.string() + ": is a file; allowed: a folder");
    CHECK (error (file / "below").find (file.string() + "/below: cannot be created: ") == 0);
    CHECK (error ("/proc/none").find ("/proc/none: cannot be created: ") == 0);
    CHECK (error ("/proc/self").find ("/proc/self: cannot be written: ") == 0);
    CHECK_FALSE (error ("").empty());
    CHECK (readContent (file) == "text");
}

TEST_CASE ("A commit that cannot be done changes nothing", "[files]")
{
    const TemporaryFolder scratch;
    const auto target = scratch.path() / "out";
    fs::create_directories (target / "probe.csv");
    OutputFolder output (target);
    output.write ("a.csv", "1");
    output.write ("probe.csv", "2");
    CHECK (errorText ([&] { output.commit(); }).find ("probe.csv: is a folder") != std::string::npos);
    CHECK (namesIn (target) == std::set<std::string> { "probe.csv" });

    OutputFolder other (scratch.path() / "other");
    other.pathFor ("never.wav");
    CHECK (errorText ([&] { other.commit(); }).find ("never.wav: was not written") != std::string::npos);

    for (const auto* const name : { "", ".", "..", "../x", "a/b", ".hidden" })
        CHECK_FALSE (errorText ([&] { other.pathFor (name); }).empty());
}

TEST_CASE ("A full disk is an error", "[files]")
{
    const TemporaryFolder scratch;
    OutputFolder output (scratch.path() / "out");
    fs::create_symlink ("/dev/full", output.pathFor ("probe.csv"));
    CHECK (errorText ([&] { output.write ("probe.csv", std::string (100000, 'x')); })
               .find ("cannot be written: No space left on device")
           != std::string::npos);
}

TEST_CASE ("What a killed program leaves behind is removed by the next, what a running one needs is not", "[files]")
{
    const TemporaryFolder scratch;
    const auto target = scratch.path() / "out";
    const auto killed = startProcess (
        [&]
        {
            OutputFolder output (target);
            output.write ("summary.json", "half");
            kill (getpid(), SIGKILL);
        });
    waitFor (killed);
    CHECK (namesIn (target).empty());
    REQUIRE (namesIn (target, true).size() == 1);
    CHECK (namesIn (target, true).begin()->find (".antinode-" + std::to_string (killed) + "-") == 0);

    const auto other = ".antinode-notes";
    std::ofstream (target / other) << "kept";
    const OutputFolder running (target), second (target);
    CHECK (namesIn (target, true).size() == 3);
    CHECK (namesIn (target, true).contains (other));
}

TEST_CASE ("Killed at any moment, a program leaves only whole files", "[files]")
{
    constexpr std::size_t size = 200000;
    const TemporaryFolder scratch;
    const auto target = scratch.path() / "out";

    for (int round = 1; round <= 8; ++round)
    {
        const auto writer = startProcess (
            [&]
            {
                for (char version = 'a';; version = version == 'z' ? 'a' : static_cast<char> (version + 1))
                {
                    OutputFolder output (target);

                    for (const auto* const name : { "summary.json", "probe.csv", "voltages.wav" })
                        output.write (name, std::string (size, version));

                    output.commit();
                }
            });
        std::this_thread::sleep_for (std::chrono::milliseconds (7 * round));
        kill (writer, SIGKILL);
        waitFor (writer);

        for (const auto& name : fs::exists (target) ? namesIn (target) : std::set<std::string> {})
        {
            const auto content = readContent (target / name);
            INFO (name);
            CHECK (content == std::string (size, content.empty() ? ' ' : content.front()));
        }
    }

    {
        const OutputFolder cleaning (target);
    }
    CHECK (namesIn (target, true).empty());
}

TEST_CASE ("A single file appears whole, in new folders, and through a link", "[files]")
{
    const TemporaryFolder scratch;
    const auto path = scratch.path() / "a" / "b" / "modes.csv";
    writeWholeFile (path, "first");
    CHECK (readContent (path) == "first");
    writeWholeFile (path, std::string (100000, 'x'));
    CHECK (readContent (path).size() == 100000);

    const auto link = scratch.path() / "link.csv";
    fs::create_symlink (path, link);
    writeWholeFile (link, "through");
    CHECK (fs::is_symlink (link));
    CHECK (readContent (path) == "through");

    const auto before = fs::current_path();
    fs::current_path (scratch.path());
    writeWholeFile ("bare.csv", "here");
    fs::current_path (before);
    CHECK (readContent (scratch.path() / "bare.csv") == "here");
    CHECK (namesIn (scratch.path(), true).empty());
    CHECK (namesIn (path.parent_path(), true).empty());
}

TEST_CASE ("A single file that cannot be written is refused in a sentence", "[files]")
{
    const TemporaryFolder scratch;
    const auto error = [] (const fs::path& path) { return errorText ([&] { writeWholeFile (path, "x"); }); };
    CHECK (error (scratch.path()) == scratch.path().string() + ": is a folder; allowed: a file");
    CHECK (error ("/dev/null") == "/dev/null: is a device or pipe; allowed: a plain file");
    CHECK (fs::is_character_file ("/dev/null"));
    CHECK (error ("/proc/none/modes.csv").find ("/proc/none: cannot be created: ") == 0);
    CHECK (error (scratch.path() / "new" / "") == (scratch.path() / "new/").string() + ": is not a file name");
    CHECK (error ("") == "is not a file name");
    CHECK (namesIn (scratch.path()).empty());
}
