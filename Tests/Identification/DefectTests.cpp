#include "Support/IdentificationScore.h"

#include <antinode_base/InputError.h>
#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** The lowest five modes of a beam at 12 points, driven by 3 ceramics, without anything above the measured lines. */
KnownStructure smallBeam()
{
    auto beam = knownBeam (7, 12, 3);
    beam.frequencies = beam.frequencies.head (5).eval();
    beam.dampingRatios = beam.dampingRatios.head (5).eval();
    beam.shapes = beam.shapes.leftCols (5).eval();
    beam.participation = beam.participation.topRows (5).eval();
    return beam;
}

FrequencyResponses smallMeasurement (double decibels = 40)
{
    auto responses = idealResponses (smallBeam(), lines (200, 3500, 1));
    addNoise (responses, decibels, 3);
    return responses;
}

constexpr auto notMeasured = std::numeric_limits<double>::quiet_NaN();
} // namespace

TEST_CASE ("Values that were not measured are left out, whichever they are", "[identification]")
{
    auto responses = smallMeasurement();

    SECTION ("single values")
    {
        ComplexNoise random (4);

        for (auto& values : responses.values)
            for (auto& value : values.reshaped())
                if (random().real() > 1.5) // some 2 %
                    value = notMeasured;
    }

    SECTION ("lines")
    {
        for (auto& values : responses.values)
            values.middleRows (300, 40).setConstant (notMeasured);
    }

    SECTION ("a point with one reference")
    {
        responses.values[1].col (4).setConstant (notMeasured);
    }

    SECTION ("lines that are not there at all, and others not evenly")
    {
        Eigen::VectorXd frequencies (2000);
        FrequencyResponses fewer = responses;
        fewer.frequencies.resize (2000);

        for (auto& values : fewer.values)
            values.resize (2000, 12);

        for (Eigen::Index f = 0; f < 2000; ++f)
        {
            const auto from = f < 1000 ? f : 1000 + (f - 1000) * 2;
            fewer.frequencies[f] = responses.frequencies[from];

            for (std::size_t i = 0; i < 3; ++i)
                fewer.values[i].row (f) = responses.values[i].row (from);
        }

        responses = fewer;
    }

    const auto result = score (identify (responses, {}), smallBeam());
    CHECK (result.found == 5);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 1) < 30e-6);
    CHECK (quantile (result.damping, 1) < 0.5e-2);
    CHECK (quantile (result.assurance, 1) < 1e-4);
}

TEST_CASE ("A point without data has no shape, and spoils no other", "[identification]")
{
    auto responses = smallMeasurement();

    for (auto& values : responses.values)
        values.col (5).setConstant (notMeasured);

    const auto modes = identify (responses, {});
    CHECK (modes.modes() == 5);
    CHECK (modes.shapes.row (5).array().isNaN().all());
    CHECK (modes.shapes.row (4).allFinite());
    CHECK (modes.participation.allFinite());
}

TEST_CASE ("A point with much more noise than others counts for as much less", "[identification]")
{
    auto responses = smallMeasurement (60);
    ComplexNoise noise (8);

    for (auto& values : responses.values)
        for (auto& value : values.col (3))
            value += 0.3 * rootMeanSquare (responses) * noise();

    const auto modes = identify (responses, {});
    const auto result = score (modes, smallBeam());
    CHECK (result.found == 5);
    CHECK (result.falseOnes == 0);
    // Some 0.03 ppm without that point; with it weighted alike more than 1 ppm.
    CHECK (quantile (result.frequency, 0.5) < 0.5e-6);
    CHECK (modes.deviations.shapes (3, 0) > 50 * modes.deviations.shapes (4, 0));
}

TEST_CASE ("Few points, one reference, or both still show the modes that they contain", "[identification]")
{
    const auto whole = smallMeasurement();
    FrequencyResponses part = whole;
    auto truth = smallBeam();

    SECTION ("one reference")
    {
        part.references.resize (1);
        part.values.resize (1);
    }

    SECTION ("one point")
    {
        part.points = whole.points.row (0).eval();

        for (auto& values : part.values)
            values = values.leftCols (1).eval();
    }

    SECTION ("one of either")
    {
        part.references.resize (1);
        part.values = { whole.values[0].leftCols (1) };
        part.points = whole.points.row (0).eval();
    }

    const auto modes = identify (part, {});
    CHECK (modes.modes() == 5);
    CHECK ((modes.angularFrequencies / (2 * std::numbers::pi) - truth.frequencies)
               .cwiseQuotient (truth.frequencies)
               .cwiseAbs()
               .maxCoeff()
           < 100e-6);
}

TEST_CASE ("Heavily damped modes are identified too", "[identification]")
{
    auto truth = smallBeam();
    truth.dampingRatios << 0.05, 0.1, 0.04, 0.06, 0.08;
    auto responses = idealResponses (truth, lines (50, 4500, 2));
    addNoise (responses, 40, 2);
    const auto result = score (identify (responses, {}), truth);
    CHECK (result.found == 5);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.damping, 1) < 1e-2);
}

TEST_CASE ("A rigid body's motion and lines from 0 Hz on do not disturb", "[identification]")
{
    const auto truth = smallBeam();
    auto responses = idealResponses (truth, lines (0, 3500, 1));
    const auto level = rootMeanSquare (responses);

    for (auto& values : responses.values)
        for (Eigen::Index f = 1; f < values.rows(); ++f)
            values.row (f).array() += level * 100 / std::complex (0.0, responses.frequencies[f]);

    addNoise (responses, 60, 2);
    const auto result = score (identify (responses, {}), truth);
    CHECK (result.found == 5);
    CHECK (result.falseOnes == 0);
}

TEST_CASE ("What holds no mode is said to hold none", "[identification]")
{
    auto responses = smallMeasurement();

    SECTION ("noise")
    {
        for (auto& values : responses.values)
            values.setZero();

        ComplexNoise noise (5);

        for (auto& values : responses.values)
            for (auto& value : values.reshaped())
                value = noise();

        CHECK_THROWS_WITH (identify (responses, {}), Catch::Contains ("mode"));
    }

    SECTION ("nothing")
    {
        for (auto& values : responses.values)
            values.setZero();

        CHECK_THROWS_AS (identify (responses, {}), InputError);
    }

    SECTION ("no value")
    {
        for (auto& values : responses.values)
            values.setConstant (notMeasured);

        CHECK_THROWS_WITH (identify (responses, {}), Catch::Contains ("half of the values"));
    }

    SECTION ("responses with the other sign of time")
    {
        for (auto& values : responses.values)
            values = values.conjugate().eval();

        CHECK_THROWS_WITH (identify (responses, {}), Catch::Contains ("complex conjugates"));
    }

    SECTION ("a range without lines")
    {
        IdentificationOptions options;
        options.minimumFrequency = 5000;
        CHECK_THROWS_WITH (identify (responses, options), Catch::Contains ("lines"));
    }
}

TEST_CASE ("The user's picks are kept, and rejected candidates are not", "[identification]")
{
    const auto responses = smallMeasurement();
    const auto truth = smallBeam();
    IdentificationOptions options;

    SECTION ("selected")
    {
        options.selected = { truth.frequencies[1], truth.frequencies[3] };
        CHECK (identify (responses, options).modes() == 2);
    }

    SECTION ("rejected")
    {
        options.rejected = { truth.frequencies[2] };
        CHECK (identify (responses, options).modes() == 4);
    }

    SECTION ("where there is nothing")
    {
        options.selected = { 1.1 * truth.frequencies[1] };
        CHECK_THROWS_WITH (identify (responses, options), Catch::Contains ("no candidate"));
    }
}

TEST_CASE ("A mode at the edge of two bands is found once", "[identification]")
{
    // Bands are chosen from the lowest line on, each to 1.6 times its lower end: the first edges are at 320 and 512 Hz.
    auto truth = smallBeam();
    truth.frequencies.head (2) << 320.01, 512;
    auto responses = idealResponses (truth, lines (200, 3500, 1));
    addNoise (responses, 20, 3);
    const auto result = score (identify (responses, {}), truth);
    CHECK (result.found == 5);
    CHECK (result.falseOnes == 0);
}

TEST_CASE ("A delay as long as that of an audio interface is found", "[identification]")
{
    auto truth = knownBeam (6, 20, 3);
    truth.delay = 0.6e-3;
    auto responses = idealResponses (truth, lines (10, 12000, 4));
    addNoise (responses, 40, 1);
    const auto modes = identify (responses, {});
    CHECK (modes.delay == Approx (truth.delay).margin (0.05e-6));
    const auto result = score (modes, truth);
    CHECK (result.found >= (truth.frequencies.array() < 11900).count());
    CHECK (result.falseOnes == 0);
}

TEST_CASE ("A single input finds most modes of a plate by the shapes of its points", "[identification]")
{
    auto truth = knownPlate (5);
    truth.participation = truth.participation.leftCols (1).eval();
    auto responses = idealResponses (truth, lines (100, 6000, 2));
    addNoise (responses, 40, 1);
    const auto result = score (identify (responses, {}), truth);
    // With the driver as the only reference it is half of them.
    CHECK (result.found >= 0.8 * static_cast<double> ((truth.frequencies.array() < 6000).count()));
    CHECK (result.falseOnes == 0);
}

TEST_CASE ("The same responses give the same modes to the bit", "[identification]")
{
    const auto responses = smallMeasurement();
    const auto one = identify (responses, {}), other = identify (responses, {});
    CHECK (one.angularFrequencies == other.angularFrequencies);
    CHECK (one.shapes == other.shapes);
    CHECK (one.participation == other.participation);
}
