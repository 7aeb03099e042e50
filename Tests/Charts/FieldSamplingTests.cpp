#include "Support/SinePlate.h"

#include <antinode_reports/PlateCharts.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
/** A shape of the sine plate at the middles of the cells of a map, scaled to 1. */
Eigen::MatrixXd exactMap (Eigen::Index rows, Eigen::Index columns, int m, int n)
{
    return Eigen::MatrixXd::NullaryExpr (
        rows, columns,
        [&] (Eigen::Index row, Eigen::Index column)
        {
            const auto x = (static_cast<double> (column) + 0.5) / static_cast<double> (columns);
            const auto y = (static_cast<double> (row) + 0.5) / static_cast<double> (rows);
            return std::sin (m * std::numbers::pi * x) * std::sin (n * std::numbers::pi * y);
        });
}
} // namespace

TEST_CASE ("A map of a plate has its aspect and the field's values, the first row at the bottom")
{
    const test::SinePlate plate;
    const auto model = plate.model (12);
    const auto maps = fieldMaps (model.surface, model.shapes / plate.amplitude(), 40);
    const auto halves = plate.halfWaves (12);
    REQUIRE (maps.size() == 12);

    for (std::size_t mode = 0; mode < maps.size(); ++mode)
    {
        REQUIRE (maps[mode].cols() == 40);
        REQUIRE (maps[mode].rows() == 30);
        const auto exact = exactMap (30, 40, halves[mode].first, halves[mode].second);
        // Polynomials of degree 11 over at most one half wave: 1e-8 at the ends of a segment.
        CHECK ((maps[mode] - exact).cwiseAbs().maxCoeff() < 1e-7);
    }
}

TEST_CASE ("A map of scattered points is coarse and close to the field")
{
    const auto model = test::scatteredPlate (4, 300);
    const auto maps = fieldMaps (model.surface, model.shapes / test::SinePlate().amplitude(), 220);
    REQUIRE (maps.size() == 4);
    REQUIRE (maps[3].cols() == 64);
    REQUIRE (maps[3].rows() == 48);
    // Points lie some 10 mm apart, half waves are 67 mm long; at the rim the spline goes on beyond the points.
    CHECK ((maps[3] - exactMap (48, 64, 3, 1)).cwiseAbs().maxCoeff() < 0.15);
    CHECK ((maps[3] - exactMap (48, 64, 3, 1)).norm() < 0.02 * maps[3].norm());
}

TEST_CASE ("A field at places of a plate is what the shapes are there")
{
    for (const auto& model : { test::SinePlate().model (9), test::scatteredPlate (9, 200) })
    {
        const Eigen::MatrixX2d places = (Eigen::MatrixX2d (3, 2) << 0.01, 0.02, 0.1, 0.14, 0.19, 0.075).finished();
        const auto values = fieldsAt (model.surface, model.shapes, places);

        for (Eigen::Index i = 0; i < 3; ++i)
            CHECK ((values.row (i) - shapesAt (model, places (i, 0), places (i, 1))).norm() == 0);
    }
}
