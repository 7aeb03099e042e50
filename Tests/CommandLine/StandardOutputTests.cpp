#include "Support/RunProgram.h"

#include <antinode_base/System.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
/** Runs the program with its standard output redirected. @return  the exit code and what it says of it */
std::pair<int, std::string> runInto (const std::string& arguments, const std::string& redirection)
{
    const TemporaryFolder folder;
    const auto errors = folder.path() / "errors";
    const auto outcome = runShellCommand ("{ '" ANTINODE_PROGRAM "' " + arguments + " " + redirection + "; } 2> '"
                                          + errors.string() + "'");
    REQUIRE (outcome);
    return { outcome->exitCode, test::readContent (errors) };
}
} // namespace

TEST_CASE ("A command whose standard output cannot be written ends with 1 and a sentence", "[command line]")
{
    const auto* const command = GENERATE ("modes staple --json", "devices", "version", "--help", "modes --help");
    CAPTURE (command);
    CHECK (runInto (command, "> /dev/null") == std::pair (0, std::string()));

    for (const auto* const closed : { "> /dev/full", ">&-" })
    {
        const auto [code, said] = runInto (command, closed);
        CHECK (code == 1);
        CHECK (said.starts_with ("antinode: standard output: cannot be written"));
        CHECK (test::linesIn (said) == 1);
    }

    // A pipe whose reader has gone.
    const TemporaryFolder folder;
    const auto pipe = (folder.path() / "pipe").string();
    const auto gone = "mkfifo '" + pipe + "'; sleep 0 < '" + pipe + "' & exec 4> '" + pipe + "'; wait; ";
    const auto outcome = runShellCommand (gone + "'" ANTINODE_PROGRAM "' " + command + " >&4 2> '" + pipe + ".errors'");
    REQUIRE (outcome);
    CHECK (outcome->exitCode == 1);
    CHECK (test::readContent (pipe + ".errors").starts_with ("antinode: standard output: cannot be written"));
}

TEST_CASE ("What is wrong with the input is said before what is wrong with standard output", "[command line]")
{
    CHECK (runInto ("modes nonsense", "> /dev/full").first == 1);
    CHECK (runInto ("nonsense", "> /dev/full").first == 2);
}
