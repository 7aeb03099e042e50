#include "Support/RunProgram.h"

#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;
using test::readContent;
using test::runProgram;

namespace
{
constexpr auto tap = R"({ "Pattern": [ { "Event": { "Time": 0, "EventType": "HapticTransient", "EventParameters":
    [ { "ParameterID": "HapticIntensity", "ParameterValue": 1 }, { "ParameterID": "HapticSharpness",
        "ParameterValue": 0.8 } ] } } ] })";
} // namespace

TEST_CASE ("perform plays haptic content at places, with its level, and writes what power it takes", "[command line]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "tap.ahap", out = folder.path() / "out";
    writeWholeFile (file, tap);
    const auto run = runProgram ({ "perform", file, "--at", "40,40", "--device", "aluminium-200x120", "--out", out });
    CAPTURE (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK_THAT (run.output, Catch::Contains ("tap on ") && Catch::Contains ("uJ per event")
                                && Catch::Contains ("amplifier") && Catch::Contains ("65 to 300 Hz"));

    // Intensity 1 is 25 dB SL, as it is reached under a medium finger.
    const auto summary = nlohmann::json::parse (readContent (out / "summary.json"));
    CHECK (summary["fingers"][0]["level_dB_SL"].get<double>() == Approx (25).margin (0.1));
    CHECK (summary["fingers"][0]["place_mm"] == nlohmann::json ({ 40.0, 40.0 }));

    // One row, with the energy of summary.json.
    const auto scores = readContent (out / "scores.csv");
    CHECK (scores.starts_with ("folder,felt_level_dB,energy_J,peak_current_A,peak_power_W,"));
    const auto energy = scores.substr (scores.find (',', scores.find ("\ntap,") + 5) + 1);
    CHECK (std::stod (energy)
           == Approx (summary["power"]["per_focus"]["electrical_in_uJ"].get<double>() * 1e-6).epsilon (1e-6));
    CHECK_THAT (readContent (out / "report.html"), Catch::Contains ("Power, energy and current"));
}

TEST_CASE ("perform puts one track at several places and refuses places that do not fit", "[command line]")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "tap.ahap", out = folder.path() / "out";
    writeWholeFile (file, tap);
    const auto run = runProgram ({ "perform", file, "--at", "40,40", "--at", "140,80", "--at", "40,40", "--level-um",
                                   "0.5", "--device", "aluminium-200x120", "--no-report", "--quiet", "--out", out });
    CAPTURE (run.errors);
    REQUIRE (run.exitCode == 0);
    const auto summary = nlohmann::json::parse (readContent (out / "summary.json"));
    REQUIRE (summary["fingers"].size() == 2);
    CHECK (summary["fingers"][1]["wanted_peak_um"].get<double>() == Approx (0.5).epsilon (0.01));
    CHECK (summary["fingers"][0]["wanted_peak_um"].get<double>() == Approx (1).epsilon (0.01));
    CHECK (summary["warnings"][1] == "Track 3 is at the place of another track: the waveform there is their sum.");

    CHECK_THAT (runProgram ({ "perform", file, "--device", "aluminium-200x120" }).errors,
                Catch::Contains ("track 1: has no place; allowed: --at X,Y"));
    CHECK_THAT (runProgram ({ "perform", "phone-fingers", "--at", "40,40" }).errors,
                Catch::Contains ("--at: gives 1 places; allowed: 3, one per track"));
    CHECK (runProgram ({ "perform", file, "--at", "40;40" }).exitCode == 1);
}
