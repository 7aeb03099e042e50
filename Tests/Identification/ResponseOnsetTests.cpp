#include "Support/IdentificationScore.h"

#include <antinode_base/InputError.h>
#include <antinode_identification/Identification.h>
#include <antinode_identification/ImpulseResponses.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Three modes at four points, accelerations per force; lines every hertz. */
KnownStructure delayedStructure()
{
    KnownStructure structure;
    structure.points.setZero (4, 2);
    structure.points.col (0) = Eigen::VectorXd::LinSpaced (4, 0, 1);
    structure.frequencies = Eigen::Vector3d (100, 250, 600);
    structure.dampingRatios = Eigen::Vector3d (0.005, 0.004, 0.003);
    structure.shapes.resize (4, 3);
    structure.shapes << 1, 0.8, 0.6, 0.7, -0.5, -0.9, 0.3, -1, 0.7, -0.4, 0.6, 0.5;
    structure.participation = structure.shapes.row (0).transpose();
    structure.delay = 0;
    return structure;
}

/** With noise that is white in what was measured. */
FrequencyResponses measurement (int integrations, double delay, double highest = 700)
{
    const auto accelerations = [&] (FrequencyResponses responses)
    {
        for (auto& values : responses.values)
            for (Eigen::Index f = 0; f < values.rows(); ++f)
                values.row (f) *=
                    std::pow (std::complex<double> (0, 2 * std::numbers::pi * responses.frequencies[f]), integrations);

        return responses;
    };
    auto truth = delayedStructure();
    truth.delay = delay;
    auto responses = accelerations (idealResponses (truth, lines (1, highest, 1)));
    addNoise (responses, 60, 1);

    for (auto& values : responses.values)
        for (Eigen::Index f = 0; f < values.rows(); ++f)
            values.row (f) /=
                std::pow (std::complex<double> (0, 2 * std::numbers::pi * responses.frequencies[f]), integrations);

    responses.integrations = integrations;
    return responses;
}
} // namespace

TEST_CASE ("A delay costs no mode, however long it is", "[identification]")
{
    const auto milliseconds = GENERATE (-4.0, 0.0, 0.3, 1.7, 3.0, 5.0, 20.0, 100.0, 640.0);
    const auto integrations = GENERATE (-1, 0, 1);
    CAPTURE (milliseconds, integrations);
    const auto delay = 1e-3 * milliseconds;
    const auto modes = identify (measurement (integrations, delay), {});
    const auto result = score (modes, delayedStructure());
    CHECK (result.found == 3);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 1) < 5e-6);
    CHECK (quantile (result.participation, 1) < 1e-3);
    constexpr double sample = 1 / 1400.0;
    CHECK (std::abs (modes.delay - delay) < 0.1 * sample);
}

TEST_CASE ("A delay that is known may be long, too", "[identification]")
{
    IdentificationOptions options;
    options.delay = 0.02;
    const auto modes = identify (measurement (1, 0.02), options);
    CHECK (score (modes, delayedStructure()).found == 3);
    CHECK (modes.modes() == 3);
    CHECK (modes.delay == 0.02);
}

TEST_CASE ("Responses that begin at once have no onset, whatever was measured", "[identification]")
{
    for (const auto integrations : { -1, 0, 1 })
    {
        const auto impulse = impulseEnergy (measurement (integrations, 0), 0, 1e12);
        REQUIRE (impulse);
        CHECK (onsetDelay (*impulse) == 0);
        CHECK (! seemsStationary (*impulse));
    }
}

TEST_CASE ("The spectrum of a record that goes on evenly is told from an impulse response", "[identification]")
{
    // What a structure does under random forces: each line has a phase of its own.
    auto responses = measurement (0, 0, 2000);
    ComplexNoise noise (3);

    for (Eigen::Index f = 0; f < responses.frequencies.size(); ++f)
        responses.values[0].row (f) *= noise();

    CHECK_THROWS_WITH (identify (responses, {}), Catch::Contains ("neither begin nor decay"));
}

TEST_CASE ("Responses that are all 0 are said to come from constant signals", "[identification]")
{
    auto responses = measurement (0, 0);
    responses.values[0].setZero();
    CHECK_THROWS_WITH (identify (responses, {}), Catch::Contains ("constant"));
}
