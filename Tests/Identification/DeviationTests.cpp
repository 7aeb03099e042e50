#include "Support/DeviationScore.h"

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("Stated deviations hold under white noise, under drift between points and under misfit", "[identification]")
{
    const auto disturbance =
        GENERATE (Disturbance {}, Disturbance { 50e-6, 0 }, Disturbance { 200e-6, 0 }, Disturbance { 0, 0.03 });
    CAPTURE (disturbance.drift, disturbance.misfit);

    const auto result = scoreDeviations (disturbance, 1, 12);
    CAPTURE (result.errors);
    CHECK (result.lost == 0);

    // Frequency and damping, then participation, shape and delay.
    for (const auto error : result.errors)
    {
        CHECK (error > 0.7);
        CHECK (error < 1.6);
    }
}

TEST_CASE ("Deviations of noise alone are too small under misfit", "[identification]")
{
    CHECK (scoreDeviations ({ 0, 0.03 }, 1, 1, true).errors[0] > 4);
}
