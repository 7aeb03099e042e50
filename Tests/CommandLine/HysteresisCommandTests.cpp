#include "Support/RunProgram.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_measurement/Hysteresis.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;
using test::readContent;
using test::runProgram;

namespace
{
constexpr double limit = 150; // V, of the beam's ceramics

/** Ceramic i adds 2 i % at full level. */
std::vector<Hysteresis> different (Eigen::Index ceramics)
{
    std::vector<Hysteresis> all;

    for (Eigen::Index i = 0; i < ceramics; ++i)
        all.push_back ({ 0.02 * static_cast<double> (i), 0 });

    return all;
}

/** Responses that are measured of the beam at a level. */
std::string measuredAt (const std::filesystem::path& folder, const ModalModel& beam, double volts)
{
    const auto name = std::to_string (static_cast<int> (volts));
    const auto levels = Eigen::VectorXd::Constant (beam.actuators(), volts / limit);
    const auto real = withHysteresis (beam, different (beam.actuators()), levels);
    writeWholeFile (folder / "real.json", modalDeviceToJson (real, "").dump());
    writeWholeFile (folder / "points.csv", "x_mm,y_mm\n-61,0\n33,0\n70,0\n");
    const auto run = runProgram ({ "measure", "--device", "beam", "--points", (folder / "points.csv").string(),
                                   "--simulate", "--simulated-device", (folder / "real.json").string(), "--level-v",
                                   name, "--rate", "48000", "--no-questions", "--out", (folder / name).string() });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    return (folder / name / "responses.uff").string();
}
} // namespace

TEST_CASE ("hysteresis tells how ceramics answer at the level that is played", "[command line]")
{
    const TemporaryFolder folder;
    const auto beam = solveStructure (loadDevice ("beam", {}));
    REQUIRE (beam.ceramics[0].voltageLimit == limit);
    const auto low = measuredAt (folder.path(), beam, 5), high = measuredAt (folder.path(), beam, 60);
    const auto out = folder.path() / "out";
    const auto run = [&] (const std::string& played)
    {
        return runProgram ({ "hysteresis", "beam", "--low", low, "--high", high, "--low-level-v", "5", "--high-level-v",
                             "60", "--played-level-v", played, "--out", out.string() });
    };
    const auto done = run ("30");
    INFO (done.errors);
    REQUIRE (done.exitCode == 0);
    const auto told = nlohmann::json::parse (readContent (out / "hysteresis.json"))["ceramics"];
    const auto after = solveStructure (loadDevice ((out / "device.json").string(), {}));
    REQUIRE (static_cast<Eigen::Index> (told.size()) == beam.actuators());

    for (Eigen::Index i = 0; i < beam.actuators(); ++i)
    {
        const auto& ceramic = told[static_cast<std::size_t> (i)];
        // Noise of 40 dB at both levels.
        CHECK (ceramic["gain_at_full_level_percent"].get<double>()
               == Approx (2.0 * static_cast<double> (i)).margin (0.3));
        CHECK (ceramic["lag_at_full_level_deg"].get<double>() == Approx (0).margin (0.2));
        CHECK (after.participation (0, i) / beam.participation (0, i)
               == Approx (1 + 0.02 * static_cast<double> (i) * 30 / limit).margin (1e-3));
    }

    const auto refused = run ("200");
    CHECK (refused.exitCode != 0);
    CHECK (refused.errors.find ("--played-level-v: is 200 V; allowed: up to the limit of") != std::string::npos);
}
