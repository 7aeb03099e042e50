#include "PlateExamples.h"
#include "PlateStatics.h"

#include <antinode_structure/SolvedPlate.h>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** Two layers of PVDF of 0.5 mm, 100 x 5 mm, clamped at one end, glued to a film so thin that it hardly counts; in
   series, one volt across both. Tzou, Hwang and Park's example: w = 3 d31 V L^2 / (8 H^2) at the tip, H the thickness
   of a layer. */
PlateDescription polymerBimorph (double width)
{
    auto plate = barePlate ("CFFF", 0.1, width, 0.29);
    plate.common.thickness = 1e-6;
    plate.common.material = { 2e9, 2e9, 2e9 / (2 * 1.29), 0.29, 1800 };
    auto layer = plateCeramic (0, 0, 0.1, width);
    layer.material = { 2e9, 0.29, 1800, 2.2e-11, 12 };
    layer.wiring = CeramicWiring::series;
    plate.common.ceramics = { layer };
    return plate;
}

double largest (const Eigen::MatrixXd& matrix)
{
    return matrix.cwiseAbs().maxCoeff();
}
} // namespace

TEST_CASE ("The tip of the polymer bimorph moves 0.33 um per volt", "[structure][plate]")
{
    const auto tipDeflection = [] (double width)
    {
        const auto plate = polymerBimorph (width);
        const auto solution = solvePlateModes (plate, 10);
        const auto model = makeModel (plate, solution);
        const auto shapes = staticShapes (plate, solution, model.surface.grid.value());
        const auto last = model.points() - 1;
        return std::abs (shapes (last, 0)) * std::pow (0.1 / model.surface.points (last, 0), 2);
    };

    // A beam's clamp lets it contract; a plate's does not, which bends it 1 + nu times as much over about half its
    // width.
    const auto narrow = tipDeflection (0.001), wide = tipDeflection (0.005);
    CHECK (narrow == Approx (3.3e-7).epsilon (0.01));
    CHECK (wide > narrow);
    CHECK (wide == Approx (3.3e-7).epsilon (0.012));
}

TEST_CASE ("Modes and the static residual give the deflection of a finer solution to 0.1 %", "[structure][plate]")
{
    const auto plate = patchedPlate();
    const auto solution = solvePlateModes (plate, 50);
    const auto model = makeModel (plate, solution);
    const Eigen::VectorXd squares = model.angularFrequencies.cwiseAbs2();
    const Eigen::MatrixXd modalSum = model.shapes * (squares.cwiseInverse().asDiagonal() * model.participation);
    const Eigen::MatrixXd residual = staticShapes (plate, solution, model.surface.grid.value()) - modalSum;
    const auto expected = staticShapes (plate, solvePlateModes (plate, 200), model.surface.grid.value());
    CHECK (largest (modalSum + residual - expected) < 1e-3 * largest (expected));
    CHECK (largest (modalSum - expected) > 3e-3 * largest (expected)); // What the residual is there for.
}

TEST_CASE ("On a ceramic itself the modal sum alone misses much of the curvature", "[structure][plate]")
{
    // alpha' alpha / omega^2: the angle work of a ceramic on itself, of which 50 modes have less than half.
    const auto plate = patchedPlate();
    const auto collocated = [&] (int modes)
    {
        const auto model = solved (plate, modes);
        return (model.participation.array().square().colwise() / model.angularFrequencies.array().square())
            .colwise()
            .sum()
            .minCoeff();
    };
    CHECK (collocated (50) < 0.75 * collocated (200));
}

TEST_CASE ("A free plate bends under static voltages without moving as a whole", "[structure][plate]")
{
    auto plate = barePlate ("FFFF", 0.1, 0.08);
    plate.common.ceramics = { plateCeramic (0.01, 0.02, 0.03, 0.02) };
    const auto solution = solvePlateModes (plate, 60);
    const auto model = makeModel (plate, solution);
    const auto shapes = staticShapes (plate, solution, model.surface.grid.value());
    const Eigen::VectorXd weighted = model.surface.masses.cwiseProduct (shapes.col (0));
    const auto scale = largest (shapes) * model.surface.masses.sum();
    CHECK (std::abs (weighted.sum()) < 1e-6 * scale);
    CHECK (std::abs (weighted.dot (model.surface.points.col (0))) < 1e-6 * scale * 0.1);

    // The part that each mode carries is alpha / omega^2.
    const Eigen::VectorXd carried = model.shapes.transpose() * weighted;
    const Eigen::VectorXd expected = model.participation.col (0).cwiseQuotient (model.angularFrequencies.cwiseAbs2());
    CHECK ((carried - expected).norm() < 1e-4 * expected.norm());
}
