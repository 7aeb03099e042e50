#include "BendingExamples.h"

#include <antinode_numerics/Quadrature.h>

#include <numbers>
#include <random>

using namespace antinode;
using namespace antinode::examples;
using tests::CircularEdge;

namespace
{
EdgeSupport supportOfCircle (const CircularEdge& edge)
{
    EdgeSupport support;
    support.holdsDisplacement = edge.translation >= tests::rigid;
    support.holdsSlope = edge.rotation >= tests::rigid;
    support.translation = support.holdsDisplacement ? 0 : edge.translation;
    support.rotation = support.holdsSlope ? 0 : edge.rotation;
    return support;
}

const CircularEdge freeCircle {}, supportedCircle { tests::rigid, 0 }, clampedCircle { tests::rigid, tests::rigid };

struct RoundPlate
{
    double hole = 0;
    CircularEdge inner, outer;
    double poissonRatio = 0.3;
};

BendingProblem problemOf (const RoundPlate& plate, const Eigen::Vector2d& centre)
{
    std::vector<ClosedPath> paths { circlePath (centre, 1, 0) };

    if (plate.hole > 0)
        paths.push_back (circlePath (centre, plate.hole, 1));

    return unitPlate (plate.poissonRatio, paths, { supportOfCircle (plate.outer), supportOfCircle (plate.inner) });
}

tests::CircularPlate exactPlate (const RoundPlate& plate)
{
    return { plate.hole, { { 1, 1, plate.poissonRatio, 1 } }, plate.inner, plate.outer };
}
} // namespace

TEST_CASE ("The determinants of Bessel's functions give the reference values", "[immersed][plate]")
{
    const std::vector<std::pair<std::string, RoundPlate>> plates {
        { "circle_free_nu0.3", { 0, {}, freeCircle, 0.3 } },
        { "circle_simply_nu0.22", { 0, {}, supportedCircle, 0.22 } },
        { "circle_clamped_nu0.3", { 0, {}, clampedCircle, 0.3 } },
        { "annulus_inner_clamped_outer_free_b0.3_nu0.22", { 0.3, clampedCircle, freeCircle, 0.22 } },
        { "circle_elastic_kT100_kR1_nu0.22", { 0, {}, { 100, 1 }, 0.22 } },
        { "annulus_elastic_inner_kT20_kR0.1_outer_kT50_kR0.5_b0.3_nu0.22", { 0.3, { 20, 0.1 }, { 50, 0.5 }, 0.22 } }
    };

    for (const auto& [name, plate] : plates)
    {
        CAPTURE (name);
        std::vector<double> once;

        for (const auto& mode : tests::circularModes (exactPlate (plate), 20))
            if (once.empty() || mode.angularFrequency > once.back())
                once.push_back (mode.angularFrequency);

        const auto& expected = outlineReferences()["circular"][name]["values"];

        for (std::size_t k = 0; k < 10; ++k)
            CHECK (once[k] == Approx (expected[k].get<double>()).epsilon (1e-8));
    }
}

TEST_CASE ("Fifty modes of circles and rings, free, supported, clamped and on springs, to 1e-4", "[immersed][plate]")
{
    const auto plate = GENERATE (values<RoundPlate> ({ { 0, {}, freeCircle, 0.3 },
                                                       { 0, {}, freeCircle, 0.05 },
                                                       { 0, {}, supportedCircle, 0.22 },
                                                       { 0, {}, clampedCircle, 0.45 },
                                                       { 0, {}, { 10, 0 }, 0.22 },
                                                       { 0, {}, { 10000, 10 }, 0.3 },
                                                       { 0.3, freeCircle, freeCircle, 0.22 },
                                                       { 0.05, freeCircle, freeCircle, 0.3 },
                                                       { 0.8, freeCircle, freeCircle, 0.3 },
                                                       { 0.2, freeCircle, clampedCircle, 0.3 },
                                                       { 0.3, clampedCircle, freeCircle, 0.3 },
                                                       { 0.05, clampedCircle, freeCircle, 0.3 },
                                                       { 0.1, supportedCircle, freeCircle, 0.3 },
                                                       { 0.5, clampedCircle, clampedCircle, 0.22 },
                                                       { 0.3, { 20, 0.1 }, { 50, 0.5 }, 0.22 } }));
    CAPTURE (plate.hole, plate.inner.translation, plate.outer.translation, plate.poissonRatio);
    CHECK (deviationFrom (frequencies (problemOf (plate, { 0.3, -0.2 }), 50), exactPlate (plate)) < 1e-4);
}

TEST_CASE ("On request fifty modes are right to 1e-5", "[immersed][plate]")
{
    const auto plate = GENERATE (values<RoundPlate> ({ { 0, {}, freeCircle, 0.3 },
                                                       { 0, {}, clampedCircle, 0.3 },
                                                       { 0.05, freeCircle, freeCircle, 0.3 },
                                                       { 0.3, clampedCircle, freeCircle, 0.22 } }));
    CAPTURE (plate.hole);
    const auto values = frequencies (problemOf (plate, { 0, 0 }), 50, ModeAccuracy::high);
    CHECK (deviationFrom (values, exactPlate (plate)) < 1e-5);
}

TEST_CASE ("Wherever the plate lies on its cells, no mode is missing, none is false", "[immersed][plate]")
{
    std::mt19937 random (7);
    std::uniform_real_distribution<> any (0, 1);
    const auto outer = GENERATE (values<CircularEdge> ({ freeCircle, supportedCircle, clampedCircle }));
    const RoundPlate plate { 0, {}, outer, 0.3 };
    const auto exact = tests::circularModes (exactPlate (plate), 30);

    for (int i = 0; i < 34; ++i)
    {
        const auto problem = problemOf (plate, { any (random), any (random) });
        auto resolution = resolutionFor (problem, 30, ModeAccuracy::usual);
        resolution.offset = 0.01 + 0.98 * any (random);
        const auto modes = bendingModes (problem, 30, resolution);
        CAPTURE (i, resolution.offset, outer.translation);
        CHECK (modes.rigidBodyModes == (outer.translation > 0 ? 0 : 3));

        for (std::size_t k = 0; k < exact.size(); ++k)
            CHECK (std::sqrt (modes.eigenvalues[static_cast<Eigen::Index> (k)])
                   == Approx (exact[k].angularFrequency).epsilon (1e-5));
    }
}

TEST_CASE ("Modes are orthonormal, and none moves the plate as a whole", "[immersed][plate]")
{
    const auto problem = problemOf ({ 0.3, freeCircle, freeCircle, 0.3 }, { 0, 0 });
    const auto modes = bendingModes (problem, 12, resolutionFor (problem, 12, ModeAccuracy::usual));

    // Sums over rings by Gauss's rule and around by equal steps, which are exact for these waves.
    Eigen::MatrixX2d places (20 * 64, 2);
    Eigen::VectorXd weights (places.rows());
    const auto rule = gaussLegendre (20, 1);

    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 64; ++j)
        {
            const auto radius = 0.3 + 0.7 * rule.nodes[i], angle = 2 * std::numbers::pi * j / 64;
            places.row (64 * i + j) << radius * std::cos (angle), radius * std::sin (angle);
            weights[64 * i + j] = 0.7 * rule.weights[i] * radius * 2 * std::numbers::pi / 64;
        }

    const auto shapes = modes.space.evaluate (places, modes.coefficients, 0, 0);
    CHECK ((shapes.transpose() * weights.asDiagonal() * shapes - Eigen::MatrixXd::Identity (12, 12)).norm() < 1e-6);
    CHECK ((weights.transpose() * shapes).norm() < 1e-7);
    CHECK ((weights.cwiseProduct (places.col (1)).transpose() * shapes).norm() < 1e-7);
}
