#include <antinode_session/SensorTap.h>

#include <catch2/catch.hpp>

#include <array>
#include <vector>

using namespace antinode;

namespace
{
constexpr double tapRate = 1000;

/** Writes frames whose numbers are 1, 2, ... from the one that is next. */
void writeNext (SensorTap& tap, int count, int& next)
{
    std::vector<double> volts (static_cast<std::size_t> (count));
    std::vector<float> sensor;

    for (auto& volt : volts)
    {
        volt = next++;
        sensor.push_back (static_cast<float> (-volt));
    }

    const std::array<const double*, 1> channels { volts.data() };
    tap.write (channels.data(), sensor.data(), count);
}
} // namespace

TEST_CASE ("Frames come out of a tap as they went in, and a gap is told", "[session][following]")
{
    SensorTap tap (1, tapRate);
    Eigen::MatrixXd frames (2, 4000);
    int next = 1;
    writeNext (tap, 300, next);
    writeNext (tap, 200, next);
    REQUIRE (tap.read (frames, 0) == 500);
    CHECK (frames (0, 499) == 500);
    CHECK (frames (1, 499) == -500);
    CHECK (tap.read (frames, 500) == 0);

    // More than it holds: the block is left out as a whole, and what waited before is thrown away.
    for (int i = 0; i < 12; ++i)
        writeNext (tap, 300, next);

    CHECK (tap.read (frames, 0) == -1);
    writeNext (tap, 10, next);
    REQUIRE (tap.read (frames, 0) == 10);
    CHECK (frames (0, 0) == 500 + 12 * 300 + 1);
}

TEST_CASE ("The newest frames are kept without gaps", "[session][following]")
{
    SensorTap tap (1, tapRate);
    RecentFrames recent (tap, 0.8);
    int next = 1;

    for (int i = 0; i < 40; ++i)
    {
        writeNext (tap, 130, next);
        recent.take (tap);

        if (! recent.isFull())
            continue;

        const Eigen::MatrixXd volts = recent.voltages(), sensor = recent.sensor();
        REQUIRE (volts.cols() == 800);
        CHECK (volts (0, 799) == next - 1);
        CHECK (volts (0, 0) == next - 800);
        CHECK (sensor (0, 0) == -volts (0, 0));
    }

    // A gap: all of it is forgotten.
    for (int i = 0; i < 20; ++i)
        writeNext (tap, 300, next);

    recent.take (tap);
    CHECK_FALSE (recent.isFull());
}
