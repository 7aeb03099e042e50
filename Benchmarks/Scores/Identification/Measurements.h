#pragma once

#include "Support/MeasuredStructure.h"

#include <functional>
#include <string>

namespace antinode::test
{
/** A measurement of a structure that is known. */
struct Measured
{
    KnownStructure truth;
    FrequencyResponses responses;
};

struct Measurement
{
    std::string name;
    std::function<Measured()> make;
};

/** Beams and plates at 40, 20 and 10 dB, few points, modes above the range, weak modes, drift, misfit, suspension,
    wrong quantity, delays.
    @param seed  others give other structures and noise of the same kinds */
std::vector<Measurement> measurements (unsigned seed);
} // namespace antinode::test
