#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("Of 124 modes of a plate whose widths overlap at least 122 are found at 40 dB, and none that is not there",
           "[identification]")
{
    const auto truth = knownPlate (2);
    auto responses = idealResponses (truth, lines (200, 30500, 4));
    addNoise (responses, 40, 2);
    IdentificationOptions options;
    options.pointMasses = truth.masses;
    const auto modes = identify (responses, options);
    const auto result = score (modes, truth);
    CHECK (result.found >= 122);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 0.5) < 0.3e-6);
    CHECK (quantile (result.damping, 0.5) < 0.02e-2);
    CHECK (quantile (result.participation, 0.5) < 0.05e-2);
    CHECK (std::abs (modes.delay - truth.delay) < 0.001e-6);

    for (const auto z : { result.zFrequency, result.zDamping, result.zShape, result.zParticipation })
    {
        CHECK (z > 0.8);
        CHECK (z < 1.25);
    }
}

TEST_CASE ("Modes above the measured range do not disturb those within it", "[identification]")
{
    const auto truth = knownPlate (3);
    auto responses = idealResponses (truth, lines (200, 8000, 2));
    addNoise (responses, 40, 3);
    const auto result = score (identify (responses, {}), truth);
    const auto below = static_cast<int> ((truth.frequencies.array() < 7900).count());
    CHECK (result.found >= below);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 0.5) < 3e-6);
}

TEST_CASE ("A thin plate with sixty modes to a band shows them all", "[identification]")
{
    auto truth = knownPlate (2);
    truth.frequencies /= 6;
    auto responses = idealResponses (truth, lines (35, 5080, 1));
    addNoise (responses, 40, 2);
    const auto result = score (identify (responses, {}), truth);
    CHECK (result.found >= 122);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 0.5) < 0.5e-6);
}
