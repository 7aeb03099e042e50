#include "LearningBench.h"

#include <antinode_learning/LearnModes.h>
#include <antinode_learning/RecordingDelays.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("A delay that leaves far more than another one is left after a few steps, a right one goes on", "[learning]")
{
    constexpr auto never = std::numeric_limits<double>::infinity();
    const Bench bench (0.02, 3);
    const auto heard = bench (bench.exactVoltages(), 0);
    const auto spread = sameSpread (allModes, 0.02, 0.1, 0.05);
    const auto misfits = [&] (double delay, double hopeless)
    {
        return misfitsOfBeginning (bench.nominal.model, bench.sensors(), spread, withDelay (heard, delay), 0,
                                   { hopeless, hopeless });
    };
    const auto right = misfits (bench.delay, never), wrong = misfits (bench.delay + 2e-3, never);
    CHECK (wrong[0] > 5 * right[0]);

    const auto hopeless = misfits (bench.delay + 2e-3, right[0]);
    CHECK (hopeless[0] > wrong[0]); // It was still falling.
    CHECK (hopeless[1] == never);
    CHECK (misfits (bench.delay, wrong[0]) == right);
}
