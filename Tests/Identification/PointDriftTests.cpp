#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Lightly damped modes of a free beam at nine points, hit at the first one. */
KnownStructure lightBeam()
{
    KnownStructure beam;
    beam.points.setZero (9, 2);
    beam.points.col (0) = Eigen::VectorXd::LinSpaced (9, 0, 1);
    beam.frequencies = Eigen::Vector3d (112, 307, 596);
    beam.dampingRatios = Eigen::Vector3d (1.4e-4, 1.2e-4, 1e-4);
    beam.shapes.resize (9, 3);

    for (Eigen::Index k = 0; k < 3; ++k)
        beam.shapes.col (k) = (std::numbers::pi * double (k + 2) * beam.points.col (0).array()).cos();

    beam.participation = beam.shapes.row (0).transpose();
    beam.delay = 0;
    return beam;
}

/** 12 Hz around each of some frequencies, every 20 mHz. */
Eigen::VectorXd linesAround (const Eigen::VectorXd& frequencies)
{
    Eigen::VectorXd result (600 * frequencies.size());

    for (Eigen::Index k = 0; k < frequencies.size(); ++k)
        result.segment (600 * k, 600) = lines (frequencies[k] - 6, frequencies[k] + 5.98, 0.02);

    return result;
}

/** Each point measured at other frequencies. @param relative  of point p to that of the mean */
template <typename Relative>
FrequencyResponses driftingResponses (const KnownStructure& truth, const Eigen::VectorXd& frequencies,
                                      const Relative& relative, double decibels)
{
    auto responses = idealResponses (truth, frequencies);

    for (Eigen::Index p = 0; p < truth.points.rows(); ++p)
    {
        auto there = truth;
        there.frequencies *= 1 + relative (p);
        responses.values[0].col (p) = idealResponses (there, frequencies).values[0].col (p);
    }

    addNoise (responses, decibels, 5);
    return responses;
}

std::string driftWarnings (const std::vector<std::string>& warnings)
{
    std::string text;

    for (const auto& warning : warnings)
        text += warning + '\n';

    return text;
}
} // namespace

TEST_CASE ("A mode that drifts from point to point stays one mode, and its drift is said", "[identification]")
{
    const auto truth = lightBeam();
    const auto [decibels, ppm] =
        GENERATE (std::pair (80.0, 30.0), std::pair (80.0, -30.0), std::pair (60.0, 30.0), std::pair (60.0, 300.0));
    CAPTURE (decibels, ppm);
    const auto modes = identify (driftingResponses (
                                     truth, linesAround (truth.frequencies),
                                     [ppm = ppm] (auto p) { return 1e-6 * ppm * (double (p) / 8 - 0.5); }, decibels),
                                 {});
    const auto result = score (modes, truth);
    CHECK (result.found == 3);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.assurance, 1) < 1e-3);
    CHECK (quantile (result.damping, 1) < 0.02);
    const auto said = driftWarnings (modes.warnings);
    const auto at = said.find (ppm > 0 ? "rises by " : "falls by ");
    REQUIRE (at != std::string::npos);
    CHECK (std::stod (said.substr (at + 9)) == Approx (std::abs (ppm)).epsilon (0.2));
}

TEST_CASE ("Two modes 60 ppm apart stay two", "[identification]")
{
    auto truth = lightBeam();
    truth.frequencies[1] = 112 * (1 + 60e-6);
    const auto modes = identify (driftingResponses (
                                     truth, linesAround (Eigen::Vector2d (112, 596)), [] (auto) { return 0.0; }, 80),
                                 {});
    CHECK (modes.modes() == 3);
    CHECK (modes.angularFrequencies[1] / modes.angularFrequencies[0] - 1 == Approx (60e-6).epsilon (0.05));
    CHECK_THAT (driftWarnings (modes.warnings), ! Catch::Contains ("ppm"));
}
