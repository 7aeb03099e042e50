#include "Support/RunProgram.h"

#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace antinode;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

namespace
{
ProgramArguments sensorsArguments (const std::filesystem::path& folder, const ProgramArguments& more)
{
    ProgramArguments arguments { "sensors", "demonstrator",  "--device", "beam",  "--rate",
                                 "48000",   "--duration-ms", "60",       "--out", folder.string() };
    arguments.insert (arguments.end(), more.begin(), more.end());
    return arguments;
}

nlohmann::json choiceOf (const std::filesystem::path& folder, const ProgramArguments& more)
{
    const auto run = runProgram (sensorsArguments (folder, more));
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    return nlohmann::json::parse (readContent (folder / "summary.json"));
}
} // namespace

TEST_CASE ("sensors chooses places that tell more than random ones, and learn takes them", "[command line]")
{
    const TemporaryFolder folder;
    const auto choice = choiceOf (folder.path(), { "--count", "3", "--candidates", "200" });
    REQUIRE (choice["sensors"].size() == 3);
    CHECK (choice["bits"] > choice["random_bits"]);
    CHECK (choice["sensors"][2]["bits"] == choice["bits"]);
    CHECK (choice["sensors"][0]["bits"] < choice["sensors"][1]["bits"]);
    CHECK (readContent (folder.path() / "report.html").find ("Where to listen") != std::string::npos);

    const auto run = runProgram ({ "learn", "demonstrator", "--device", "beam", "--rate", "48000", "--duration-ms",
                                   "60", "--sensors", (folder.path() / "sensors.csv").string(), "--out",
                                   (folder.path() / "pass").string() });
    INFO (run.errors);
    CHECK (run.exitCode == 0);
}

TEST_CASE ("sensors refuses more sensors than candidates", "[command line]")
{
    const TemporaryFolder folder;
    const auto run = runProgram (sensorsArguments (folder.path(), { "--count", "9", "--candidates", "5" }));
    CHECK (run.exitCode == 1);
    CHECK (run.errors.find ("--count: is 9; allowed: 1 to 5, as many as there are candidates") != std::string::npos);
}

TEST_CASE ("sensors takes ceramics that are idle among the candidates", "[command line]")
{
    const TemporaryFolder folder;
    // Two places only: of three sensors one is the ceramic.
    const auto choice = choiceOf (folder.path(), { "--count", "3", "--candidates", "2", "--idle-ceramic", "2" });
    CHECK (choice["candidates"] == 3);
    int ceramics = 0;

    for (const auto& sensor : choice["sensors"])
        ceramics += sensor.contains ("idle_ceramic") && sensor["idle_ceramic"] == 2;

    CHECK (ceramics == 1);
    // The heading and the two places.
    const auto places = readContent (folder.path() / "sensors.csv");
    CHECK (std::count (places.begin(), places.end(), '\n') == 3);
}
