#include "Support/RunProgram.h"
#include "Support/ScoreNumbers.h"

#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <vector>

using namespace antinode;
using test::linesIn;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;
using test::scoreNumber;

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

namespace
{
const ProgramArguments placeForTap { "place",      "aluminium-200x120",
                                     "--at",       "60,50",
                                     "--at",       "140,70",
                                     "--modes",    "12",
                                     "--rim-mm",   "10",
                                     "--step-mm",  "20",
                                     "--size-mm",  "20",
                                     "--set",      "device.quality_factor=15",
                                     "--waveforms" };

ProgramArguments joined (ProgramArguments first, const ProgramArguments& more)
{
    first.insert (first.end(), more.begin(), more.end());
    return first;
}
} // namespace

TEST_CASE ("place puts ceramics where waveforms need least, with a device and a row per number", "[command line]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "tap.ahap", out = folder.path() / "few.json";
    writeWholeFile (file, R"({ "Pattern": [ { "Event": { "Time": 0, "EventType": "HapticTransient" } } ] })");
    const auto run = runProgram (joined (placeForTap, { file, "--counts", "1,3,5", "--out", out }));
    CAPTURE (run.errors, run.output);
    REQUIRE (run.exitCode == 0);
    CHECK_THAT (run.output, Catch::StartsWith ("ceramics   peak/V  energy/uJ"));
    CHECK_THAT (run.output, Catch::Contains ("1  failed: --count: is 1; allowed: at least 2, one per touched point"));

    // The level is reached, and more ceramics need no more.
    const auto table = readContent (folder.path() / "few.csv");
    CHECK (linesIn (table) == 4);
    CHECK_THAT (table, Catch::Contains ("\nfew-3,3,"));
    CHECK (scoreNumber (table, "few-3,", "felt_level_dB")
           == Approx (22.5).margin (0.2)); // 25 dB at intensity 1, here 0.75
    CHECK (scoreNumber (table, "few-5,", "peak_voltage_V") < scoreNumber (table, "few-3,", "peak_voltage_V"));

    // The device of a row has its numbers.
    const auto performed = runProgram ({ "perform", file, "--device", folder.path() / "few-3.json", "--at", "60,50",
                                         "--at", "140,70", "--no-report", "--out", folder.path() / "out" });
    REQUIRE (performed.exitCode == 0);
    const auto summary = nlohmann::json::parse (readContent (folder.path() / "out" / "summary.json"));
    CHECK (summary["peak_voltage_V"].get<double>()
           == Approx (scoreNumber (table, "few-3,", "peak_voltage_V")).epsilon (1e-6));

    const auto least = runProgram (joined (placeForTap, { file, "--count", "3", "--least", "energy", "--out", out }));
    CAPTURE (least.errors);
    REQUIRE (least.exitCode == 0);
    CHECK_THAT (least.output, Catch::Contains ("of the level/dB"));
}
