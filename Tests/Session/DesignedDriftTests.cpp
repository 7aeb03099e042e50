#include <antinode_session/KnownDrift.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
/** Two modes, of which the first moves. */
FrequencyShift shiftOf (double change, double deviation)
{
    return { Eigen::Vector2d (change, 0), Eigen::Vector2d (deviation, 0) };
}
} // namespace

TEST_CASE ("Designs are made again for a mode that has moved by more than is uncertain of it", "[session][following]")
{
    DesignedDrift designed;
    CHECK_FALSE (designed.isOutdated (shiftOf (1e-2, 0), true)); // nothing was designed yet
    CHECK_FALSE (designed.note (Eigen::Vector2d (0, 0)));
    CHECK_FALSE (designed.isOutdated (shiftOf (4e-5, 0), true));
    CHECK (designed.isOutdated (shiftOf (6e-5, 1e-5), true));
    CHECK (designed.isOutdated (shiftOf (-6e-5, 1e-5), true));
    CHECK_FALSE (designed.isOutdated (shiftOf (8e-5, 1e-3), true));

    // What is being designed is not begun again for less than half a thousandth.
    CHECK_FALSE (designed.isOutdated (shiftOf (4e-4, 1e-5), false));
    CHECK (designed.isOutdated (shiftOf (6e-4, 1e-5), false));
    CHECK (designed.note (Eigen::Vector2d (6e-4, 0)));
    CHECK_FALSE (designed.isOutdated (shiftOf (6e-4, 1e-5), true));
    CHECK_FALSE (designed.isOutdated ({ Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() }, true)); // another device
}
