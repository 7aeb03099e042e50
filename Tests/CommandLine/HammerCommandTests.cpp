#include "Support/RunProgram.h"

#include "Measurement/SimulatedHits.h"

#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <catch2/catch.hpp>

using namespace antinode;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

TEST_CASE ("frf turns a recording of a hammer into responses, which identify reads with the window's damping taken off",
           "[command line]")
{
    const TemporaryFolder folder;
    const auto path = folder.path();

    for (const auto seed : { 1U, 2U, 3U })
    {
        auto made = test::simulateHits ({ { 0.03, 40, 1e-3 } }, 0.36, seed);

        if (seed == 3)
            made.force += test::simulateHits ({ { 0.05, 12, 1e-3 } }, 0.36, seed).force;

        Eigen::MatrixXd channels (3, made.force.size());
        channels << made.force.transpose() / 100, made.responses / 10;
        writeWholeFile (path / ("hit" + std::to_string (seed) + ".wav"), encodeWave (channels, 1, made.sampleRate));
    }

    const auto wave = [&path] (int number) { return (path / ("hit" + std::to_string (number) + ".wav")).string(); };
    const ProgramArguments arguments { "frf",
                                       wave (1),
                                       wave (2),
                                       wave (3),
                                       "--channels",
                                       "force:1,1,2",
                                       "--force-scale",
                                       "100",
                                       "--response-scale",
                                       "10",
                                       "--quantity",
                                       "velocity",
                                       "--lowest-hz",
                                       "50",
                                       "--highest-hz",
                                       "1000",
                                       "--out",
                                       (path / "h.uff").string(),
                                       "--report",
                                       (path / "report").string() };
    auto run = runProgram (arguments);
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK (run.output.find ("hit1.wav: 1 of 1 hits used") != std::string::npos);
    CHECK (run.output.find ("hit 1 at 0.030 s left out: double hit: 3") != std::string::npos);
    CHECK (run.output.find ("identify subtracts its damping") != std::string::npos);

    const auto report = test::readContent (path / "report" / "report.html");
    CHECK (report.find ("Spectrum of the force") != std::string::npos);
    CHECK (report.find ("left out: double hit: 3") != std::string::npos);
    CHECK (report.find ("one curve per hit point") != std::string::npos);

    run = runProgram ({ "identify", (path / "h.uff").string(), "--out", (path / "d.json").string() });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK (run.output.find ("3 modes") != std::string::npos);

    // Options of the other kind of recording are refused, whichever it is.
    auto other = arguments;
    other.insert (other.end(), { "--sync-channel", "2" });
    CHECK (runProgram (other).errors.find ("--sync-channel: belongs to an excitation") != std::string::npos);
    CHECK (runProgram ({ "frf", "excitation.json", wave (1), "--hit-point", "3", "--out", "x.uff" })
               .errors.find ("--hit-point: belongs to recordings of a hammer")
           != std::string::npos);
}
