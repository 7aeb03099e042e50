#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** A wooden plate: twelve modes from 62 to 880 Hz, damping ratios .6 to 1.4 %, at some points, hit at a few places. */
KnownStructure woodenPlate (Eigen::Index points, Eigen::Index hits)
{
    constexpr Eigen::Index modes = 12;
    std::mt19937_64 random (21);
    std::uniform_real_distribution<double> uniform (0, 1);
    KnownStructure plate;
    plate.points.resize (points, 2);
    plate.masses.setConstant (points, 0.4 / static_cast<double> (points));
    plate.frequencies.resize (modes);
    plate.frequencies << 62, 91, 148, 171, 252, 297, 341, 436, 512, 604, 729, 880;
    plate.dampingRatios.resize (modes);
    plate.shapes.resize (points, modes);
    plate.participation.resize (modes, hits);
    plate.delay = 0;

    for (Eigen::Index p = 0; p < points; ++p)
        plate.points.row (p) << 0.5 * uniform (random), 0.2 * uniform (random);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        plate.dampingRatios[k] = 0.006 + 0.008 * uniform (random);
        const auto waveX = std::numbers::pi * static_cast<double> (k % 4 + 1) / 0.5;
        const auto waveY = std::numbers::pi * static_cast<double> (k / 4 + 1) / 0.2;

        for (Eigen::Index p = 0; p < points; ++p)
            plate.shapes (p, k) =
                3 * std::cos (waveX * plate.points (p, 0) + 0.2) * std::cos (waveY * plate.points (p, 1) + 0.1);

        for (Eigen::Index i = 0; i < hits; ++i)
            plate.participation (k, i) = 1 + uniform (random);
    }

    return plate;
}

bool hasWarning (const IdentifiedModes& modes, const std::string& part)
{
    return std::any_of (modes.warnings.begin(), modes.warnings.end(),
                        [&part] (const auto& warning) { return warning.find (part) != std::string::npos; });
}
} // namespace

TEST_CASE ("Lines of the mains and a point without signal are left out and named", "[identification]")
{
    const auto truth = woodenPlate (10, 2);
    auto responses = idealResponses (truth, lines (30, 1000, 0.5));
    addNoise (responses, 40, 3);
    ComplexNoise noise (4);

    for (auto& values : responses.values)
    {
        for (const Eigen::Index hertz : { 50, 150, 250 })
            for (Eigen::Index p = 0; p < 10; ++p)
                values (2 * (hertz - 30), p) += 20 * rootMeanSquare (responses) * noise();

        values.col (6).setZero();
    }

    const auto modes = identify (responses, {});
    const auto result = score (modes, truth);
    CHECK (result.found == 12);
    CHECK (result.falseOnes == 0);
    CHECK (hasWarning (modes, "50, 150, 250 Hz"));
    CHECK (hasWarning (modes, "point 7"));
    CHECK (modes.shapes.row (6).array().isNaN().all());
    CHECK (modes.shapes.row (5).allFinite());
}
