#include "PlateExamples.h"
#include "PlateStatics.h"

#include <antinode_structure/DeviceDescription.h>
#include <antinode_structure/MeasuredModel.h>
#include <antinode_structure/SolvedPlate.h>
#include <antinode_structure/StaticShare.h>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** What shapes behind some modes bend the surface by, each ceramic at 1 V. N_p x N_b, m */
Eigen::MatrixXd shareBehind (const ModalModel& model, Eigen::Index modes)
{
    const auto count = model.modes() - modes;
    const Eigen::VectorXd squares = model.angularFrequencies.tail (count).cwiseAbs2();
    return model.shapes.rightCols (count)
           * (squares.cwiseInverse().asDiagonal() * model.participation.bottomRows (count));
}
} // namespace

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

TEST_CASE ("A measured static share stands behind the modes as it was measured", "[structure][plate]")
{
    DeviceDescription device { "measured", {}, solveStructure ({ "drawn", {}, patchedPlate() }, 12) };
    auto& model = std::get<ModalModel> (device.body);
    CHECK_FALSE (hasStaticShare (device));
    const auto expected = staticShapes (patchedPlate(), solvePlateModes (patchedPlate(), 200), *model.surface.grid);
    model.staticShare = expected;
    CHECK (hasStaticShare (device));
    const auto whole = solveWithStaticShare (device, {});
    CHECK (whole.modes() == 12 + model.actuators());
    CHECK (whole.angularFrequencies[12] > model.angularFrequencies[11]);
    CHECK ((shareBehind (whole, 12) - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE ("A retuned plate has the static share of its drawing, by the gains of its ceramics", "[structure][plate]")
{
    const DeviceDescription drawing { "drawn", {}, patchedPlate() };
    const auto before = solveStructure (drawing);
    auto now = before;
    now.participation.col (0) *= 1.25;
    const DeviceDescription retuned { "retuned", {}, measuredChanges (drawing, before, now).value() };
    REQUIRE (hasStaticShare (retuned));
    const auto modes = before.modes();
    const auto expected = shareBehind (solveWithStaticShare (drawing, {}), modes);
    const auto found = shareBehind (solveWithStaticShare (retuned, {}), modes);
    CHECK ((found.col (0) - 1.25 * expected.col (0)).norm() < 1e-9 * expected.norm());
    CHECK ((found.rightCols (found.cols() - 1) - expected.rightCols (found.cols() - 1)).norm()
           < 1e-9 * expected.norm());
}
