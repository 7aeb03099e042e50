#include "Support/SinePlate.h"

#include <antinode_tracks/PointResponses.h>

#include <catch2/catch.hpp>

#include <Eigen/Dense>

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
