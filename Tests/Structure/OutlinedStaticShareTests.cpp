#include "PlateExamples.h"

#include <antinode_outline/PathBuilder.h>
#include <antinode_structure/PlateSection.h>
#include <antinode_structure/StaticShare.h>

#include <Eigen/LU>

#include <random>

using namespace antinode;
using namespace antinode::examples;

namespace
{
constexpr double outlinedRadius = 0.1, discRadius = 0.02;

CeramicDescription discAt (double x, double y, double radius)
{
    auto ceramic = plateCeramic (x - radius, y - radius, 2 * radius, 2 * radius);
    ceramic.shape = CeramicShape::disc;
    return ceramic;
}

OutlinedPlate circle (EdgeCondition condition, const std::vector<CeramicDescription>& ceramics)
{
    OutlinedPlate plate;
    plate.common = plainCommon (1e-3);
    plate.common.ceramics = ceramics;
    plate.outline.paths = { circlePath ({ 0, 0 }, outlinedRadius, 0) };
    plate.edges = { { condition } };
    return plate;
}

Eigen::MatrixXd staticDeflections (const ModalModel& model, const Eigen::MatrixX2d& places)
{
    const Eigen::VectorXd squares = model.angularFrequencies.cwiseAbs2();
    Eigen::MatrixXd shapes (places.rows(), model.modes());

    for (Eigen::Index p = 0; p < places.rows(); ++p)
        shapes.row (p) = shapesAt (model, places (p, 0), places (p, 1));

    return shapes * (squares.cwiseInverse().asDiagonal() * model.participation);
}

/** Even in a circle, with a seed. */
Eigen::MatrixX2d randomPlaces (int count)
{
    std::mt19937 random { 7 };
    std::uniform_real_distribution<double> share;
    Eigen::MatrixX2d places (count, 2);

    for (auto place : places.rowwise())
    {
        const auto radius = 0.999 * outlinedRadius * std::sqrt (share (random)),
                   angle = 2 * std::numbers::pi * share (random);
        place << radius * std::cos (angle), radius * std::sin (angle);
    }

    return places;
}
} // namespace

TEST_CASE ("A disc bends a simply supported circle statically as its closed form says, to 1e-3 by 12 modes",
           "[structure][outlined]")
{
    const auto plate = circle (EdgeCondition::simplySupported, { discAt (0, 0, discRadius) });
    const auto outer = bareSection (plate.common), inner = ceramicSection (plate.common, plate.common.ceramics[0]);

    // w' is 2 c r on the disc, 2 b r + d / r beside it; slope and radial moment go on at its edge, whose jump is the
    // moment per volt, and the moment ends at the plate's edge.
    const auto ratio = outer.d12 / outer.d11, a = discRadius, b = outlinedRadius;
    Eigen::Matrix3d system;
    system << 2 * a, -2 * a, -1 / a,                                                                  //
        2 * (inner.d11 + inner.d12), -2 * (outer.d11 + outer.d12), outer.d11 * (1 - ratio) / (a * a), //
        0, 2 * (1 + ratio), -(1 - ratio) / (b * b);
    const Eigen::Vector3d slopes = system.inverse() * Eigen::Vector3d (0, inner.momentX, 0);
    const auto expected = [&] (double r)
    {
        const auto beside = [&] (double from)
        { return slopes[1] * (from * from - b * b) + slopes[2] * std::log (from / b); };
        return r > a ? beside (r) : beside (a) + slopes[0] * (r * r - a * a);
    };

    const auto model = solveWithStaticShare ({ "circle", {}, plate }, 12);
    REQUIRE (model.modes() == 13);
    const auto places = randomPlaces (200);
    const auto deflections = staticDeflections (model, places);

    for (Eigen::Index p = 0; p < places.rows(); ++p)
        CHECK (deflections (p, 0)
               == Approx (expected (places.row (p).norm())).epsilon (0).margin (1e-3 * std::abs (expected (0))));
}

TEST_CASE ("Modes of a plate with an outline and their static share deflect as four times as many modes do",
           "[structure][outlined]")
{
    auto turned = plateCeramic (-0.02, -0.07, 0.03, 0.02);
    turned.angle = 0.4;

    for (const auto condition : { EdgeCondition::free, EdgeCondition::clamped })
    {
        const auto plate = circle (condition, { discAt (0.04, 0.03, discRadius), turned });
        const auto places = randomPlaces (100);
        const auto model = solveWithStaticShare ({ "few", {}, plate }, 20);
        const auto few = staticDeflections (model, places);
        const auto many = staticDeflections (solveWithStaticShare ({ "many", {}, plate }, 80), places);
        const auto largest = many.cwiseAbs().maxCoeff();
        CHECK ((few - many).cwiseAbs().maxCoeff() < 2e-3 * largest);

        const Eigen::MatrixXd gram = model.shapes.transpose() * model.surface.masses.asDiagonal() * model.shapes;
        CHECK ((gram - Eigen::MatrixXd::Identity (gram.rows(), gram.cols())).cwiseAbs().maxCoeff() < 1e-2);
    }
}
