#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** A beam hit by a hammer at two of its measured points: participations are the shapes there. */
KnownStructure hammeredBeam()
{
    auto beam = knownBeam (9, 15, 2);
    beam.frequencies = beam.frequencies.head (4).eval();
    beam.dampingRatios = beam.dampingRatios.head (4).eval();
    beam.shapes = beam.shapes.leftCols (4).eval();
    beam.participation.resize (4, 2);
    beam.participation << beam.shapes.row (2).transpose(), beam.shapes.row (9).transpose();
    return beam;
}

FrequencyResponses hammered()
{
    auto responses = idealResponses (hammeredBeam(), lines (200, 2500, 1));
    addNoise (responses, 50, 1);
    responses.drive = DriveQuantity::force;
    responses.references = { { "hammer 1", 2 }, { "hammer 2", 9 } };
    return responses;
}

double largestError (const Eigen::MatrixXd& found, const Eigen::MatrixXd& truth)
{
    double error = 0;

    for (Eigen::Index k = 0; k < truth.cols(); ++k)
        error =
            std::max (error, std::min ((found.col (k) - truth.col (k)).norm(), (found.col (k) + truth.col (k)).norm())
                                 / truth.col (k).norm());

    return error;
}
} // namespace

TEST_CASE ("A driving point gives shapes their modal mass", "[identification]")
{
    const auto modes = identify (hammered(), {});
    REQUIRE (modes.modes() == 4);
    CHECK (modes.scaling == ShapeScaling::drivingPoint);
    CHECK (largestError (modes.shapes, hammeredBeam().shapes) < 5e-3);
    CHECK (largestError (modes.participation.transpose(), hammeredBeam().participation.transpose()) < 5e-3);
}

TEST_CASE ("A driving point of the wrong sign gives a warning", "[identification]")
{
    auto responses = hammered();

    for (auto& values : responses.values)
        values = -values;

    const auto modes = identify (responses, {});
    REQUIRE (modes.modes() == 4);
    REQUIRE (! modes.quality[0].warnings.empty());
    CHECK_THAT (modes.quality[0].warnings.back() + modes.quality[0].warnings.front(), Catch::Contains ("wrong sign"));
}

TEST_CASE ("Without a driving point the given masses scale, without them a convention that says so", "[identification]")
{
    auto responses = hammered();
    responses.references = { { "hammer 1", {} }, { "hammer 2", {} } };
    IdentificationOptions options;

    SECTION ("masses")
    {
        options.pointMasses = hammeredBeam().masses;
        const auto modes = identify (responses, options);
        REQUIRE (modes.modes() == 4);
        CHECK (modes.scaling == ShapeScaling::knownMass);

        for (Eigen::Index k = 0; k < 4; ++k)
            CHECK (modes.shapes.col (k).cwiseAbs2().dot (options.pointMasses) == Approx (1));
    }

    SECTION ("convention")
    {
        const auto modes = identify (responses, options);
        REQUIRE (modes.modes() == 4);
        CHECK (modes.scaling == ShapeScaling::convention);
        CHECK (! modes.scalingReason.empty());

        for (Eigen::Index k = 0; k < 4; ++k)
            CHECK (modes.shapes.col (k).squaredNorm() == Approx (15));
    }
}

TEST_CASE ("The largest value of every shape is positive", "[identification]")
{
    const auto modes = identify (hammered(), {});

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        CHECK (modes.shapes.col (k).maxCoeff() == modes.shapes.col (k).cwiseAbs().maxCoeff());
}

TEST_CASE ("Complex modes of a structure with real ones are real, and reconstruct as well", "[identification]")
{
    IdentificationOptions options;
    options.complexModes = true;
    const auto responses = hammered();
    const auto modes = identify (responses, options);
    REQUIRE (modes.modes() == 4);
    CHECK ((modes.complexShapes.real() - modes.shapes).norm() < 0.01 * modes.shapes.norm());
    CHECK (modes.complexShapes.imag().norm() < 0.01 * modes.shapes.norm());

    for (const auto& quality : modes.quality)
    {
        CHECK (quality.collinearity > 0.999);
        CHECK (quality.rankOne > 0.999);
    }

    const auto synthesised = synthesise (modes, responses.frequencies);
    CHECK ((synthesised.values[0] - responses.values[0]).norm() < 0.01 * responses.values[0].norm());
}

TEST_CASE ("Complex modes of a structure that has some are found", "[identification]")
{
    // Points that do not pass 0 together, as damping at one end of a structure makes them.
    auto truth = identify (hammered(), {});
    truth.complexShapes = truth.shapes.cast<std::complex<double>>();
    truth.complexShapes.bottomRows (7) *= std::polar (1.0, 0.5);
    truth.complexParticipation = truth.participation.cast<std::complex<double>>();
    auto responses = synthesise (truth, lines (200, 2500, 1));
    addNoise (responses, 60, 2);
    IdentificationOptions options;
    options.complexModes = true;
    const auto modes = identify (responses, options);
    REQUIRE (modes.modes() == 4);
    CHECK (modes.quality[1].collinearity < 0.95);
    CHECK ((modes.angularFrequencies - truth.angularFrequencies)
               .cwiseQuotient (truth.angularFrequencies)
               .cwiseAbs()
               .maxCoeff()
           < 5e-6);
    CHECK (modes.reconstructionError < -55);
    const auto synthesised = synthesise (modes, responses.frequencies);
    CHECK ((synthesised.values[0] - responses.values[0]).norm() < 2e-3 * responses.values[0].norm());
}

TEST_CASE ("Shapes made orthogonal are so, and those of a partly mapped beam are spoilt by it", "[identification]")
{
    auto responses = hammered();
    const Eigen::Index mapped = 10;
    responses.points = responses.points.topRows (mapped).eval();

    for (auto& values : responses.values)
        values = values.leftCols (mapped).eval();

    IdentificationOptions options;
    const auto raw = identify (responses, options);
    options.gramSchmidt = true;
    const auto orthogonal = identify (responses, options);
    REQUIRE (orthogonal.modes() == 4);
    const Eigen::MatrixXd gram = orthogonal.shapes.transpose() * orthogonal.shapes;

    for (Eigen::Index k = 0; k < 4; ++k)
        for (Eigen::Index l = 0; l < k; ++l)
            CHECK (gram (k, l) == Approx (0).margin (1e-9 * gram (k, k)));

    const Eigen::MatrixXd truth = hammeredBeam().shapes.topRows (mapped);
    const auto assurance = [&truth] (const IdentifiedModes& modes, Eigen::Index k)
    {
        const auto cosine = modes.shapes.col (k).normalized().dot (truth.col (k).normalized());
        return cosine * cosine;
    };
    CHECK (1 - assurance (raw, 3) < 1e-5);
    CHECK (1 - assurance (orthogonal, 3) > 1e-3);
}
