#include <antinode_documents/Inputs.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_structure/OutlinedModel.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
/** The embedded aluminium cantilever with 30 modes, as it is. */
DeviceDescription rectangle()
{
    return loadDevice ("aluminium-200x120", { "device.modes.count=30" });
}

/** The same plate by the solver of outlined ones. */
DeviceDescription outlined()
{
    auto device = rectangle();
    device.body = outlinedPlate (std::get<PlateDescription> (device.body));
    return device;
}
} // namespace

TEST_CASE ("Modes beyond of an outlined plate are those of another solver of the same plate", "[library][wide]")
{
    const auto aligned = rectangle(), cut = outlined();
    const auto known = solveDevice (cut, {}, false), reference = solveDevice (aligned, {}, false);
    const auto frequency = 2 * known.frequencyHz (known.modes() - 1);
    const auto wide = solveWide (cut, known, frequency, false);
    const auto expected = solveWide (aligned, reference, frequency, false);
    CHECK (wide.obstacle.empty());
    REQUIRE (wide.known == 30);
    REQUIRE (wide.model.modes() == expected.model.modes());
    CHECK (wide.model.modes() > 55);
    CHECK (wide.model.shapes.leftCols (30) == known.shapes);

    for (Eigen::Index k = 0; k < wide.model.modes(); ++k)
    {
        CAPTURE (k);
        CHECK (wide.model.frequencyHz (k) == Approx (expected.model.frequencyHz (k)).epsilon (1e-3));
        CHECK (wide.model.participation.row (k).norm()
               == Approx (expected.model.participation.row (k).norm()).epsilon (0.02).margin (1e-3));
    }
}

TEST_CASE ("Modes beyond of a plate with a hole stand on the points of the known ones, at right angles to them",
           "[library][wide]")
{
    const auto device = loadDevice ("phone", { "device.modes.count=20" });
    const auto known = solveDevice (device, {}, false);
    const auto wide = solveWide (device, known, 2 * known.frequencyHz (19), false);
    REQUIRE (wide.model.modes() > 35);
    REQUIRE (wide.model.shapes.rows() == known.points());
    const Eigen::MatrixXd gram =
        wide.model.shapes.transpose() * wide.model.surface.masses.asDiagonal() * wide.model.shapes;
    const auto beyond = wide.model.modes() - 20;
    // The points are as many as the known modes need, at half the frequency.
    CHECK ((gram - Eigen::MatrixXd::Identity (gram.rows(), gram.cols())).cwiseAbs().maxCoeff() < 0.03);
    CHECK (gram.topRightCorner (20, beyond).cwiseAbs().maxCoeff() < 1e-3);
}
