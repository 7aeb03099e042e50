#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Five modes of a beam at eight points. */
KnownStructure beamOfFive (Eigen::Index ceramics)
{
    auto beam = knownBeam (7, 8, ceramics);
    beam.frequencies = beam.frequencies.head (5).eval();
    beam.dampingRatios = beam.dampingRatios.head (5).eval();
    beam.shapes = beam.shapes.leftCols (5).eval();
    beam.participation = beam.participation.topRows (5).eval();
    return beam;
}

FrequencyResponses measurement (Eigen::Index ceramics = 2)
{
    auto responses = idealResponses (beamOfFive (ceramics), lines (200, 3500, 2));
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

    SECTION ("accelerations said to be velocities")
    {
        each ([] (double omega) { return std::complex<double> (0, omega); });
        CHECK_THAT (warnings (responses), Catch::Contains ("--quantity acceleration"));
    }
}

TEST_CASE ("An inverted channel is named", "[identification]")
{
    // Of two references only their relation is known; three tell which one it is.
    auto responses = measurement (3);
    multiply (responses, 1, 4, [] (double) { return -1.0; });
    const auto said = warnings (responses);
    CHECK_THAT (said, Catch::Contains ("inverted"));
    CHECK_THAT (said, Catch::Contains ("point 5, driver C2"));
}

TEST_CASE ("Delays that differ from channel to channel are named", "[identification]")
{
    auto responses = measurement();

    for (std::size_t i = 0; i < 2; ++i)
        for (Eigen::Index p = 0; p < 8; ++p)
            multiply (responses, i, p, [p] (double omega) { return std::polar (1.0, -15e-6 * omega * double (p)); });

    const auto said = warnings (responses);
    CHECK_THAT (said, Catch::Contains ("delays differ"));
    CHECK_THAT (said, Catch::Contains ("point 8"));
}

TEST_CASE ("Good responses have no cause named", "[identification]")
{
    const auto said = warnings (measurement());
    CHECK_THAT (said, ! Catch::Contains ("quantity"));
    CHECK_THAT (said, ! Catch::Contains ("delays differ"));
    CHECK_THAT (said, ! Catch::Contains ("inverted"));
    CHECK_THAT (said, ! Catch::Contains ("left out"));
}
