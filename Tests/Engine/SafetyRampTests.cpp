#include "EngineFixtures.h"
#include "Support/AllocationCount.h"

#include <antinode_engine/VoltageLimiter.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** What ones become, in blocks. */
template <typename Sample>
std::vector<Sample> rampInBlocks (SafetyRamp& ramp, int samples, int blockSize)
{
    std::vector<Sample> ones (static_cast<std::size_t> (samples), Sample (1));

    for (int done = 0; done < samples; done += blockSize)
    {
        Sample* channel = ones.data() + done;
        ramp.process (&channel, 1, std::min (blockSize, samples - done));
    }

    return ones;
}
} // namespace

TEST_CASE ("a ramp is a straight line whose last sample has the target")
{
    SafetyRamp ramp (0);
    CHECK (rampInBlocks<double> (ramp, 3, 3) == std::vector<double> { 0, 0, 0 });
    ramp.setTarget (1, 4);
    CHECK (ramp.isMoving());
    CHECK (rampInBlocks<double> (ramp, 6, 6) == std::vector<double> { 0.25, 0.5, 0.75, 1, 1, 1 });
    CHECK_FALSE (ramp.isMoving());
    ramp.setTarget (0, 0);
    CHECK (rampInBlocks<double> (ramp, 2, 2) == std::vector<double> { 0, 0 });
}

TEST_CASE ("a ramp that is turned round goes on from where it is")
{
    SafetyRamp ramp (1);
    ramp.setTarget (0, 8);
    rampInBlocks<double> (ramp, 4, 4);
    CHECK (ramp.gain() == 0.5);
    ramp.setTarget (1, 2);
    CHECK (rampInBlocks<double> (ramp, 3, 3) == std::vector<double> { 0.75, 1, 1 });
}

TEST_CASE ("a ramp does not depend on the block size, to the bit")
{
    SafetyRamp ramp (1);
    ramp.setTarget (0.1, 5000);
    const auto whole = rampInBlocks<double> (ramp, 9000, 9000);
    ramp = SafetyRamp (1);
    ramp.setTarget (0.1, 5000);
    const auto wholeFloat = rampInBlocks<float> (ramp, 9000, 9000);

    for (const auto blockSize : blockSizes)
    {
        ramp = SafetyRamp (1);
        ramp.setTarget (0.1, 5000);
        CHECK (rampInBlocks<double> (ramp, 9000, blockSize) == whole);
        ramp = SafetyRamp (1);
        ramp.setTarget (0.1, 5000);
        CHECK (rampInBlocks<float> (ramp, 9000, blockSize) == wholeFloat);
    }
}

TEST_CASE ("a gain that is not between 0 and 1 means silence")
{
    for (const auto gain :
         { -0.5, 1.5, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
    {
        CHECK (SafetyRamp (gain).gain() == 0);
        SafetyRamp ramp (1);
        ramp.setTarget (gain, 2);
        CHECK (rampInBlocks<double> (ramp, 3, 3) == std::vector<double> { 0.5, 0, 0 });
    }
}

TEST_CASE ("a ramp allocates nothing")
{
    SafetyRamp ramp (1);
    float samples[200] = {};
    float* channels[2] = { samples, samples + 100 };
    const auto before = mallocCalls();
    ramp.setTarget (0, 50);
    ramp.process (channels, 2, 100);
    CHECK (mallocCalls() == before);
    CHECK ((! mallocIsCounted() || before > 0));
}
