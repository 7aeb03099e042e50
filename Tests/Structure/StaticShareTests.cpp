#include "PlateExamples.h"
#include "PlateStatics.h"

#include <antinode_structure/SolvedPlate.h>
#include <antinode_structure/StaticShare.h>

using namespace antinode;
using namespace antinode::examples;

TEST_CASE ("Modes with their static share deflect as a finer solution does, to 0.1 %", "[structure][plate]")
{
    const auto plate = patchedPlate();
    const auto solution = solvePlateModes (plate, 50);
    const auto model = makeModel (plate, withStaticShare (plate, solution));
    const auto ceramics = static_cast<Eigen::Index> (plate.common.ceramics.size());
    REQUIRE (model.modes() == 50 + ceramics);
    const Eigen::VectorXd squares = model.angularFrequencies.cwiseAbs2();
    const Eigen::MatrixXd modalSum = model.shapes * (squares.cwiseInverse().asDiagonal() * model.participation);
    const auto expected = staticShapes (plate, solvePlateModes (plate, 200), model.surface.grid.value());
    CHECK ((modalSum - expected).cwiseAbs().maxCoeff() < 1e-3 * expected.cwiseAbs().maxCoeff());

    // The shapes behind the modes are orthonormal in mass, among themselves and to the modes.
    const Eigen::MatrixXd gram = model.shapes.transpose() * model.surface.masses.asDiagonal() * model.shapes;
    CHECK ((gram - Eigen::MatrixXd::Identity (gram.rows(), gram.cols())).cwiseAbs().maxCoeff() < 1e-2);
    CHECK ((gram.topLeftCorner (50, 50) - Eigen::MatrixXd::Identity (50, 50)).cwiseAbs().maxCoeff() < 1e-3);
}
