#include "Support/MeasuredStructure.h"

#include <antinode_identification/Identification.h>
#include <antinode_identification/MeasuredQuantity.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** A structure that is driven at its first point, unless said. */
KnownStructure structureOf (const Eigen::VectorXd& frequencies, const Eigen::VectorXd& dampingRatios,
                            const Eigen::MatrixXd& shapes)
{
    KnownStructure structure;
    structure.points.setZero (shapes.rows(), 2);
    structure.points.col (0) = Eigen::VectorXd::LinSpaced (shapes.rows(), 0, 1);
    structure.frequencies = frequencies;
    structure.dampingRatios = dampingRatios;
    structure.shapes = shapes;
    structure.participation = shapes.row (0).transpose();
    structure.delay = 0;
    return structure;
}

/** Three modes at four points. */
KnownStructure threeModes (double damping = 0.004)
{
    Eigen::MatrixXd shapes (4, 3);
    shapes << 1, 0.8, 0.6, 0.7, -0.5, -0.9, 0.3, -1, 0.7, -0.4, 0.6, 0.5;
    return structureOf (Eigen::Vector3d (100, 250, 600), Eigen::Vector3d::Constant (damping), shapes);
}

KnownStructure fiveModes()
{
    std::mt19937_64 random (1);
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd shapes = Eigen::MatrixXd::NullaryExpr (12, 5, [&] { return normal (random); });
    Eigen::VectorXd frequencies (5), dampingRatios (5);
    frequencies << 667, 1625, 2069, 2850, 4256;
    dampingRatios << 0.008, 0.006, 0.009, 0.006, 0.0035;
    return structureOf (frequencies, dampingRatios, shapes);
}

/** The numbers of a file that does not say what they are. */
FrequencyResponses numbers (const KnownStructure& structure, const Eigen::VectorXd& frequencies, int integrations,
                            double decibels, unsigned seed = 1)
{
    // What was velocity becomes the measured numbers, which are read as velocities.
    auto responses = asQuantity (idealResponses (structure, frequencies), -integrations);
    responses.integrations = 0;
    responses.isQuantityStated = false;
    addNoise (responses, decibels, seed);
    return responses;
}

FrequencyResponses statedAs (FrequencyResponses responses, int integrations)
{
    responses.isQuantityStated = true;
    return asQuantity (std::move (responses), integrations);
}

std::string joined (const std::vector<std::string>& warnings)
{
    std::string text;

    for (const auto& warning : warnings)
        text += warning + '\n';

    return text;
}

const char* nameOf (int integrations)
{
    return integrations > 0 ? "acceleration" : integrations < 0 ? "displacement" : "velocity";
}

void checkFrequencies (const IdentifiedModes& modes, const KnownStructure& truth)
{
    REQUIRE (modes.modes() == truth.frequencies.size());

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        CHECK (modes.angularFrequencies[k] / (2 * std::numbers::pi) == Approx (truth.frequencies[k]).epsilon (1e-4));
}
} // namespace

TEST_CASE ("A quantity that nothing states is found by what explains the responses best", "[identification]")
{
    const auto integrations = GENERATE (-1, 0, 1);
    CAPTURE (integrations);
    const auto check = [&] (const KnownStructure& truth, const Eigen::VectorXd& frequencies, double decibels)
    {
        const auto modes = identify (numbers (truth, frequencies, integrations, decibels), {});
        CHECK (modes.integrations == integrations);
        CHECK_THAT (joined (modes.warnings), Catch::Contains (std::string (nameOf (integrations)) + " is taken"));
        CHECK_THAT (joined (modes.warnings), ! Catch::Contains ("left out"));
        checkFrequencies (modes, truth);
        // Sizes, too, are those of the quantity.
        const Eigen::MatrixXd products = modes.shapes * modes.participation.col (0).asDiagonal();
        const Eigen::MatrixXd expected = truth.shapes * truth.participation.col (0).asDiagonal();
        CHECK ((products - expected).norm() < 0.02 * expected.norm());
    };

    SECTION ("many points")
    {
        check (fiveModes(), lines (2, 4998, 4), 50);
    }

    SECTION ("two modes at one point: a delay of a quarter period suits one of them")
    {
        check (
            structureOf (Eigen::Vector2d (150, 900), Eigen::Vector2d (0.01, 0.01), Eigen::RowVector2d (0.3456, 0.8216)),
            lines (1, 1499, 1), 50);
    }

    SECTION ("one point")
    {
        auto truth = threeModes();
        truth.points = truth.points.topRows (1).eval();
        truth.shapes = truth.shapes.topRows (1).eval();
        check (truth, lines (1, 700, 1), 60);
    }
}

TEST_CASE ("A quantity that is stated is kept, and what contradicts it is said", "[identification]")
{
    const auto truth = threeModes();
    const auto measured = GENERATE (-1, 0, 1), stated = GENERATE (-1, 0, 1);
    CAPTURE (measured, stated);
    const auto modes = identify (statedAs (numbers (truth, lines (1, 700, 1), measured, 60), stated), {});
    CHECK (modes.integrations == stated);
    const auto said = joined (modes.warnings);

    if (measured == stated)
    {
        CHECK_THAT (said, ! Catch::Contains ("quantity"));
        return;
    }

    CHECK_THAT (said, Catch::Contains (std::string ("as ") + nameOf (measured) + " the responses fit modes"));
    CHECK_THAT (said, Catch::Contains (std::string ("--quantity ") + nameOf (measured)));
    CHECK_THAT (said, ! Catch::Contains ("left out")); // No range makes a wrong quantity right.
}

TEST_CASE ("Where two quantities fit, both are named, and a driving point decides", "[identification]")
{
    // The phases of displacements and accelerations differ by twice the damping ratio: 0.06 degrees are lost in noise.
    const auto integrations = GENERATE (-1, 1);
    CAPTURE (integrations);
    auto responses = numbers (threeModes (0.0005), lines (1, 700, 0.05), integrations, 30);
    responses.drive = DriveQuantity::force;
    responses.references[0].point = 0;
    const auto modes = identify (responses, {});
    CHECK (modes.integrations == integrations);
    CHECK_THAT (joined (modes.warnings), Catch::Contains ("acceleration and displacement explain the responses alike"));
    CHECK_THAT (joined (modes.warnings), Catch::Contains ("the response at the driving point has its sign"));

    // Stated the other way round: the sign alone tells.
    CHECK_THAT (joined (identify (statedAs (responses, -integrations), {}).warnings),
                Catch::Contains ("at the driving point the responses have the sign of"));
}
