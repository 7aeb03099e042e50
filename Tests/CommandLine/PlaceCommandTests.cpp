#include "Support/RunProgram.h"

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <vector>

using namespace antinode;
using test::linesIn;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

TEST_CASE ("place writes a device that can be solved, with as many ceramics as asked for", "[command line]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "placed.json";
    const auto run = runProgram (
        { "place", "aluminium-200x120", "--count", "5", "--size-mm", "20x15", "--modes", "12", "--out", file });
    REQUIRE (run.exitCode == 0);
    const auto device = nlohmann::json::parse (readContent (file));
    REQUIRE (device["ceramics"].size() == 5);
    CHECK (device["ceramics"][4]["name"] == "C5");
    CHECK (device["ceramics"][0]["size_x_mm"] == 20);
    CHECK (device["ceramics"][0]["size_y_mm"] == 15);
    CHECK (device["ceramics"][0]["material"] == "NCE51");
    CHECK (runProgram ({ "modes", file, "--count", "5", "--no-cache" }).exitCode == 0);

    const auto beam = folder.path() / "beam.json";
    CHECK (
        runProgram ({ "place", "beam", "--count", "3", "--modes", "8", "--frozen", "--quiet", "--out", beam }).exitCode
        == 0);
    CHECK (runProgram ({ "modes", beam, "--count", "5", "--no-cache" }).exitCode == 0);
}

TEST_CASE ("place refuses impossible options in one line that names the option", "[command line]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "placed.json";

    for (const auto& arguments : std::vector<ProgramArguments> { { "--size-mm", "20x" },
                                                                 { "--size-mm", "-3" },
                                                                 { "--size-mm", "300" },
                                                                 { "--step-mm", "0" },
                                                                 { "--step-mm", "0.0001" },
                                                                 { "--size-mm", "90", "--count", "9" },
                                                                 { "--size-mm", "1e-9" } })
    {
        ProgramArguments all { "place", "phone-bare", "--out", file };
        all.insert (all.end(), arguments.begin(), arguments.end());
        const auto run = runProgram (all);
        CAPTURE (arguments.front().text, arguments[1].text, run.errors);
        CHECK_THAT (run.errors, Catch::StartsWith ("antinode: --"));
        CHECK (run.exitCode == 1);
        CHECK (linesIn (run.errors) == 1);
        CHECK_FALSE (std::filesystem::exists (file));
    }

    CHECK (runProgram ({ "place", "phone-bare", "--count", "0" }).exitCode == 2);
    CHECK (runProgram ({ "place", "phone-bare", "--count", "65" }).exitCode == 2);
}
