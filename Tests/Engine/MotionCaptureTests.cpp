#include <antinode_engine/MotionCapture.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

namespace
{
constexpr int modes = 3, frames = 20;

/** Writes bell-shaped bursts: the largest at the given frame. */
void writeBurst (MotionCapture& capture, int length, int peakAt, double size)
{
    for (int n = 0; n < length; ++n)
    {
        const auto value = size * std::exp (-0.05 * (n - peakAt) * (n - peakAt));
        const double velocities[] { value, -value / 2, 0.1 * value };
        capture.write (velocities);
    }
}
} // namespace

TEST_CASE ("A captured window has the largest motion in its middle", "[engine][capture]")
{
    MotionCapture capture (modes, frames, 1000);
    Eigen::MatrixXd window;
    CHECK_FALSE (capture.take (window));
    writeBurst (capture, 100, 50, 2);
    REQUIRE (capture.take (window));
    REQUIRE (window.cols() == frames);
    REQUIRE (window.rows() == modes);
    Eigen::Index peak = 0;
    window.row (0).maxCoeff (&peak);
    CHECK (std::abs (peak - frames / 2) <= 1);
    CHECK (window (0, peak) == Approx (2));
    CHECK (window (1, peak) == Approx (-1));
    CHECK_FALSE (capture.take (window));
}

TEST_CASE ("Small motion after a large one is not captured until the large one is forgotten", "[engine][capture]")
{
    MotionCapture capture (modes, frames, 500);
    Eigen::MatrixXd window;
    writeBurst (capture, 60, 30, 10);
    REQUIRE (capture.take (window));
    writeBurst (capture, 60, 30, 0.1);
    CHECK_FALSE (capture.take (window));
    writeBurst (capture, 60, 30, 8);
    REQUIRE (capture.take (window));
    CHECK (window.row (0).maxCoeff() == Approx (8));

    auto bursts = 0;

    do
        writeBurst (capture, 60, 30, 0.1);
    while (! capture.take (window) && ++bursts < 1000);

    CHECK (bursts > 10);
    CHECK (window.row (0).maxCoeff() == Approx (0.1));
}

TEST_CASE ("A surface at rest gives no window, and one that nobody took in time is not given half overwritten",
           "[engine][capture]")
{
    MotionCapture capture (modes, frames, 1000);
    Eigen::MatrixXd window;
    writeBurst (capture, 200, 30, 0);
    CHECK_FALSE (capture.take (window));
    writeBurst (capture, 60, 30, 1);
    writeBurst (capture, 500, -1000, 0);
    CHECK_FALSE (capture.take (window));
    writeBurst (capture, 60, 30, 1);
    CHECK (capture.take (window));
}

TEST_CASE ("A window that nobody took in time makes way for a later one, which waits after the last motion",
           "[engine][capture]")
{
    MotionCapture capture (modes, frames, 1000);
    Eigen::MatrixXd window;

    for (int burst = 0; burst < 10; ++burst)
        writeBurst (capture, 60, 30, 1 + 0.1 * burst);

    REQUIRE (capture.take (window));
    CHECK (window.row (0).maxCoeff() > 1.5);
}
