#include "Support/RunProgram.h"
#include "Support/ScoreNumbers.h"

#include <antinode_text/OutputFolder.h>

#include <catch2/catch.hpp>

using namespace antinode;
using test::readContent;
using test::runProgram;
using test::scoreNumber;

TEST_CASE ("compare has the numbers of render and of perform for each device, and what cannot be played",
           "[command line]")
{
    const TemporaryFolder folder;
    const auto tap = folder.path() / "tap.ahap", out = folder.path() / "out";
    writeWholeFile (tap, R"({ "Pattern": [ { "Event": { "Time": 0, "EventType": "HapticTransient" } } ] })");
    const auto run = runProgram ({ "compare", "aluminium-200x120", "beam", "--focus", "aluminium-centre", "--waveforms",
                                   tap, "--at", "60,50", "--draws", "20", "--figures", "pdf", "--out", out });
    CAPTURE (run.errors, run.output);
    REQUIRE (run.exitCode == 0);
    const auto scores = readContent (out / "scores.csv");
    CHECK (test::linesIn (scores) == 5);
    CHECK_THAT (run.output, Catch::Contains ("19 of 20 devices"));
    CHECK_THAT (readContent (out / "report.html"), Catch::Contains ("Comparison of 2 devices"));
    const auto page = readContent (out / "report.html");
    CHECK (page.find ("<table") < page.find ("<figure"));
    CHECK_THAT (readContent (out / "compare.pdf"), Catch::StartsWith ("%PDF-1."));
    CHECK (std::filesystem::exists (out / "figure-what-each-device-needs-and-gives-1.pdf"));

    // A beam has no such places, which does not stop the others.
    CHECK_THAT (scores, Catch::Contains ("\nbeam: tap,,"));

    const auto performed =
        runProgram ({ "perform", tap, "--at", "60,50", "--device", "aluminium-200x120", "--tolerance", "--draws", "20",
                      "--no-report", "--out", folder.path() / "tap" });
    REQUIRE (performed.exitCode == 0);
    CHECK_THAT (performed.output,
                Catch::Contains ("20 random devices; standard deviations:") && Catch::Contains ("track 1, felt/dB SL"));
    CHECK (test::linesIn (readContent (folder.path() / "tap" / "tolerance.csv")) == 21);
    const auto alone = readContent (folder.path() / "tap" / "scores.csv");

    for (const auto* const key : { "peak_voltage_V", "energy_J", "felt_level_dB" })
        CHECK (scoreNumber (scores, "aluminium-200x120: tap", key) == scoreNumber (alone, "tap", key));

    CHECK (scoreNumber (scores, "aluminium-200x120: tap", "tolerance_level_dB_SL")
           < scoreNumber (alone, "tap", "felt_level_dB"));

    CHECK (scoreNumber (scores, "aluminium-200x120: aluminium-centre", "peak_voltage_V") > 0);
    CHECK (scoreNumber (scores, "aluminium-200x120: aluminium-centre", "tolerance_field_error_percent") > 0);
    CHECK_THAT (runProgram ({ "compare", "beam" }).errors, Catch::Contains ("has nothing to compare; allowed:"));
}
