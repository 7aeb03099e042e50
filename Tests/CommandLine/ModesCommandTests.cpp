#include "Support/RunProgram.h"

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;
using test::linesIn;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

TEST_CASE ("modes as JSON has the keys of the contract", "[command line]")
{
    const auto run = runProgram ({ "modes", "staple", "--json", "--count", "6" });
    REQUIRE (run.exitCode == 0);
    const auto json = nlohmann::json::parse (run.output);
    CHECK (json.at ("device") == "staple");
    CHECK (json.at ("kind") == "staple");
    CHECK (json.at ("rigid_body_modes") == 0);
    CHECK (json.at ("unknowns") > 0);
    CHECK (json.at ("time_ms") > 0);
    REQUIRE (json.at ("modes").size() == 6);
    CHECK (json.at ("modes").at (0).at ("frequency_Hz") == Approx (399).epsilon (0.002));
    CHECK (json.at ("modes").at (0).at ("participation_per_V").size() == 8);
    CHECK (json.at ("modes").at (0).contains ("error_estimate_relative"));
    CHECK (json.at ("modes").at (0).at ("damping_ratio") == Approx (1.0 / 380));
}

TEST_CASE ("Solved modes are kept for the next run, without a cache they are not", "[command line]")
{
    const TemporaryFolder folder;
    const auto cached = folder.path() / "cache" / "antinode" / "modes";
    const auto run = [&] (const ProgramArguments& arguments)
    {
        return test::waitForProgram (
            test::startProgram (arguments, folder.path(), { { test::userCacheVariable, folder.path() / "cache" } }));
    };

    REQUIRE (run ({ "modes", "beam", "--no-cache" }) == 0);
    CHECK_FALSE (std::filesystem::exists (cached));
    const auto solved = readContent (folder.path() / "stdout");
    REQUIRE (run ({ "modes", "beam" }) == 0);
    CHECK_FALSE (std::filesystem::is_empty (cached));
    CHECK (readContent (folder.path() / "stdout") == solved);
    REQUIRE (run ({ "modes", "beam" }) == 0);
    CHECK (readContent (folder.path() / "stdout") == solved);
}

TEST_CASE ("modes writes files beside what it prints", "[command line]")
{
    const TemporaryFolder folder;
    const auto csv = folder.path() / "modes.csv", uff = folder.path() / "modes.uff";
    const auto run = runProgram ({ "modes", "staple", "--count", "5", "--json", "--csv", csv, "--uff", uff });
    REQUIRE (run.exitCode == 0);
    CHECK (nlohmann::json::parse (run.output)["modes"].size() == 5);
    CHECK (linesIn (readContent (csv)) == 6);
    CHECK (readContent (uff).starts_with ("    -1\n   151\n"));

    const auto refused = runProgram ({ "modes", "staple", "--uff", folder.path() });
    CHECK (refused.exitCode == 1);
    CHECK (refused.output.empty());
    CHECK (linesIn (refused.errors) == 1);
}

TEST_CASE ("modes --report writes a page beside the table, or says in a line why not", "[command line]")
{
    const TemporaryFolder folder;
    const auto run = runProgram ({ "modes", "staple", "--count", "5", "--report", folder.path() / "modes" });
    REQUIRE (run.exitCode == 0);
    CHECK (linesIn (run.output) == 9);
    const auto page = readContent (folder.path() / "modes" / "report.html");
    CHECK_THAT (page, Catch::Contains ("staple: modes") && Catch::Contains ("The lowest 5 of 5 modes"));
    const auto refused = runProgram ({ "modes", "staple", "--report", "/dev/null" });
    CHECK (refused.exitCode == 1);
    CHECK (linesIn (refused.errors) == 1);
    CHECK (refused.output.empty());
}
