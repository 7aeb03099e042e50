#include "Support/ErrorText.h"

#include <antinode_identification/IdentifiedModel.h>
#include <antinode_outline/PathBuilder.h>

#include <catch2/catch.hpp>

#include <numbers>
#include <random>

using namespace antinode;

namespace
{
Outline ring()
{
    return { { circlePath ({ 0, 0 }, 0.1, 0), circlePath ({ 0.02, 0 }, 0.03, 1) } };
}

/** Even places of an outline, and a pair of waves there. */
IdentifiedModes wavesOn (const Outline& outline)
{
    IdentifiedModes modes;
    std::vector<Eigen::RowVector2d> places;

    for (double y = -0.095; y < 0.1; y += 0.01)
        for (double x = -0.095; x < 0.1; x += 0.01)
            if (outline.contains (x, y))
                places.emplace_back (x, y);

    const auto count = static_cast<Eigen::Index> (places.size());
    modes.points.resize (count, 2);
    modes.shapes.resize (count, 2);

    for (Eigen::Index p = 0; p < count; ++p)
    {
        modes.points.row (p) = places[static_cast<std::size_t> (p)];
        modes.shapes.row (p) << std::sin (30 * modes.points (p, 0)), std::cos (25 * modes.points (p, 1));
    }

    modes.angularFrequencies = Eigen::Vector2d (500, 900);
    modes.dampingRatios = Eigen::Vector2d (0.01, 0.01);
    modes.participation = Eigen::MatrixXd::Ones (2, 1);
    modes.deviations.angularFrequencies = Eigen::Vector2d::Zero();
    modes.references = { { "C1", {} } };
    modes.drive = DriveQuantity::voltage;
    return modes;
}
} // namespace

TEST_CASE ("Cells of scattered points fill an outline with a hole, and no more", "[identification][outlined]")
{
    std::mt19937 random { 11 };
    std::uniform_real_distribution<double> any (-0.1, 0.1);
    Eigen::MatrixX2d points (80, 2);

    for (Eigen::Index p = 0; p < points.rows();)
        if (const Eigen::RowVector2d place (any (random), any (random)); ring().contains (place.x(), place.y()))
            points.row (p++) = place;

    const auto cells = voronoiCells (points, ring());
    CHECK (cells.minCoeff() > 0);
    CHECK (cells.sum() == Approx (std::numbers::pi * (0.01 - 0.0009)).epsilon (3e-3)); // by chords

    // A half of the points of a square has a half of it.
    const Outline square { { polygonPath ({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, 0) } };
    Eigen::MatrixX2d two (2, 2);
    two << 0.25, 0.5, 0.75, 0.5;
    CHECK (voronoiCells (two, square) == Eigen::Vector2d (0.5, 0.5));
}

TEST_CASE ("Identified modes end at the outline that is known", "[identification][outlined]")
{
    const auto modes = wavesOn (ring());
    MappedSurface mapped;
    mapped.boundary = SurfaceBoundary { ring(), {} };
    const auto model = toModalModel (modes, mapped);
    CHECK (model.surface.xMinimum == Approx (-0.1));
    CHECK (model.surface.areas.sum() == Approx (areaOf (ring())).epsilon (3e-3));
    CHECK_THROWS_AS (shapesAt (model, 0.02, 0.0), InputError);
    CHECK (shapesAt (model, -0.05, 0.05)[0] == Approx (std::sin (-1.5)).epsilon (0.02));

    mapped.boundary = SurfaceBoundary { { { circlePath ({ 0, 0 }, 0.05, 0) } }, {} };
    CHECK_THAT (errorText ([&] { toModalModel (modes, mapped); }), Catch::StartsWith ("outline: leaves out the point"));
}
