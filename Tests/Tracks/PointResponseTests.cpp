#include "Support/SinePlate.h"

#include <antinode_tracks/PointResponses.h>
#include <antinode_tracks/WindowedResponses.h>

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <complex>
#include <numbers>

using namespace antinode;

TEST_CASE ("Loads change the responses of points as they change mass, damping and stiffness", "[tracks]")
{
    using Complex = std::complex<double>;
    const auto model = test::SinePlate().model (12);
    Eigen::MatrixXd shapes (2, model.modes());
    shapes << shapesAt (model, 0.05, 0.06), shapesAt (model, 0.13, 0.1);
    const std::vector<SurfaceLoad> loads { { shapes.row (0), 1e-4, 1.5, 600 },
                                           { shapesAt (model, 0.16, 0.03), 2e-4, 0.8, 900 } };
    const auto responses = pointResponses (model, shapes, loads, 6000, 120);
    CHECK (responses.values.rows() == 61);

    for (const Eigen::Index line : { 0, 7, 20, 60 })
    {
        // The modal equations with the loads in their matrices, solved as they stand.
        const Complex s (0, 2 * std::numbers::pi * 50 * static_cast<double> (line));
        Eigen::MatrixXcd system = Eigen::MatrixXcd::Zero (model.modes(), model.modes());

        for (Eigen::Index k = 0; k < model.modes(); ++k)
            system (k, k) = s * s + 2 * model.dampingRatios[k] * model.angularFrequencies[k] * s
                            + std::pow (model.angularFrequencies[k], 2);

        for (const auto& load : loads)
            system += (load.mass * s * s + load.damping * s + load.stiffness)
                      * (load.shapes.transpose() * load.shapes).cast<Complex>();

        const Eigen::MatrixXcd expected =
            shapes.cast<Complex>() * system.partialPivLu().solve (model.participation.cast<Complex>());
        CHECK ((responses.atLine (line) - expected).norm() < 1e-10 * expected.norm());
    }
}

TEST_CASE ("A table's responses are those of the modal sum, with loads, and 0 beyond its highest frequency", "[tracks]")
{
    // 3 of 40 modes below 1.2 kHz: most are a power series, also where they resonate only twice as high.
    const auto model = test::SinePlate().model (40);
    Eigen::MatrixXd shapes (3, model.modes());
    shapes << shapesAt (model, 0.05, 0.06), shapesAt (model, 0.13, 0.1), shapesAt (model, 0.09, 0.03);
    const std::vector<SurfaceLoad> loads { { shapes.row (0), 1e-4, 1.5, 600 },
                                           { shapesAt (model, 0.16, 0.03), 2e-4, 0.8, 900 } };
    const ResponseTable table (model, model.participation, 4000, 400, 1200);
    const auto exact = pointResponses (model, shapes, loads, 4000, 400), quick = table.responses (shapes, loads);
    REQUIRE (quick.values.rows() == 201);
    const auto counted = exact.values.topRows (121);
    CHECK ((quick.values.topRows (121) - counted).cwiseAbs().maxCoeff() < 1e-4 * counted.cwiseAbs().maxCoeff());
    CHECK (quick.values.bottomRows (80).norm() == 0);
}

TEST_CASE ("The preconditioner is the inverse of each line's responses", "[tracks]")
{
    const auto model = test::SinePlate().model (12);
    Eigen::MatrixXd shapes (3, model.modes());
    shapes << shapesAt (model, 0.05, 0.06), shapesAt (model, 0.13, 0.1), shapesAt (model, 0.09, 0.03);
    constexpr Eigen::Index length = 120, line = 7;
    const auto responses = pointResponses (model, shapes, {}, 6000, length);
    const auto compliance = 1e-4 * responses.atLine (line).squaredNorm();
    WindowedResponses windowed (responses, length, compliance);
    const Eigen::VectorXd tone = Eigen::VectorXd::NullaryExpr (
        length,
        [] (Eigen::Index n) { return std::cos (2 * std::numbers::pi * line * static_cast<double> (n) / length); });
    const auto inverted = windowed.precondition (tone * Eigen::RowVector3d (1, -2, 0.5));

    // A window as long as the event: the inverse is exact.
    const Eigen::MatrixXd back =
        windowed.motion (windowed.pulls (inverted)) + compliance * inverted - tone * Eigen::RowVector3d (1, -2, 0.5);
    CHECK (back.norm() < 1e-9 * tone.norm());
}
