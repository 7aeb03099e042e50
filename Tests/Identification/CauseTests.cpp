#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Five modes of a beam at eight points from two ceramics. */
KnownStructure beamOfFive()
{
    auto beam = knownBeam (7, 8, 2);
    beam.frequencies = beam.frequencies.head (5).eval();
    beam.dampingRatios = beam.dampingRatios.head (5).eval();
    beam.shapes = beam.shapes.leftCols (5).eval();
    beam.participation = beam.participation.topRows (5).eval();
    return beam;
}

FrequencyResponses measurement()
{
    auto responses = idealResponses (beamOfFive(), lines (200, 3500, 2));
    addNoise (responses, 45, 3);
    return responses;
}

/** The warnings as one text. */
std::string warnings (const FrequencyResponses& responses)
{
    std::string text;

    for (const auto& warning : identify (responses, {}).warnings)
        text += warning + '\n';

    return text;
}

template <typename Factor>
void multiply (FrequencyResponses& responses, std::size_t reference, Eigen::Index point, const Factor& factor)
{
    for (Eigen::Index f = 0; f < responses.frequencies.size(); ++f)
        responses.values[reference](f, point) *= factor (2 * std::numbers::pi * responses.frequencies[f]);
}
} // namespace

TEST_CASE ("A wrong quantity is named", "[identification]")
{
    auto responses = measurement();
    const auto each = [&responses] (const auto& factor)
    {
        for (std::size_t i = 0; i < 2; ++i)
            for (Eigen::Index p = 0; p < 8; ++p)
                multiply (responses, i, p, factor);
    };

    SECTION ("displacements said to be velocities")
    {
        each ([] (double omega) { return 1.0 / std::complex<double> (0, omega); });
        CHECK_THAT (warnings (responses), Catch::Contains ("--quantity displacement"));
    }
}
