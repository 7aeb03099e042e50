#include "Support/RunProgram.h"

#include <antinode_documents/Inputs.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace antinode;
using test::readContent;
using test::runProgram;

TEST_CASE ("calibrate puts measured amplifiers in front of a device's ceramics", "[command line]")
{
    const TemporaryFolder folder;
    const auto out = folder.path() / "calibrated";
    const auto run = runProgram ({ "calibrate", "--device", "beam", "--simulate", "--simulated-bandwidth-khz", "20",
                                   "--resolution-hz", "50", "--rate", "48000", "--out", out.string() });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    const auto calibration = nlohmann::json::parse (readContent (out / "calibration.json"));
    const auto before = solveStructure (loadDevice ("beam", {}));
    const auto after = solveStructure (loadDevice ((out / "device.json").string(), {}));
    REQUIRE (static_cast<Eigen::Index> (calibration["amplifiers"].size()) == before.actuators());

    for (Eigen::Index i = 0; i < before.actuators(); ++i)
    {
        const auto& amplifier = calibration["amplifiers"][static_cast<std::size_t> (i)];
        const auto gain = amplifier["gain"].get<double>(), bandwidth = amplifier["bandwidth_Hz"].get<double>();
        CAPTURE (i, gain, bandwidth);
        // 10 % of scatter around 20 kHz and 10 us, 5 % around a gain of 1: four deviations, and not all the same.
        CHECK (std::abs (gain - 1) < 0.2);
        CHECK (std::abs (bandwidth / 20000 - 1) < 0.5);
        CHECK (amplifier["delay_us"].get<double>() == Approx (10).margin (4));

        for (Eigen::Index k = 0; k < before.modes(); ++k)
            CHECK (after.participation (k, i) == Approx (gain * before.participation (k, i)).epsilon (1e-6));

        CHECK (after.ceramics[static_cast<std::size_t> (i)].lag.timeConstant
               == Approx (1 / (2 * std::numbers::pi * bandwidth)).epsilon (1e-6));

        CHECK (after.ceramics[static_cast<std::size_t> (i)].voltageLimit * std::max (1.0, gain)
               == Approx (before.ceramics[static_cast<std::size_t> (i)].voltageLimit));
    }

    CHECK (readContent (out / "report.html").find ("Not included") != std::string::npos);
}
