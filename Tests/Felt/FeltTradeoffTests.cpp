#include "Support/SineBeam.h"

#include <antinode_documents/SkinThresholds.h>
#include <antinode_render/FeltTradeoff.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
FocusDescription weightedFocus()
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.04, 0.04, 1 } };
    focus.focusTime = 0.015;
    focus.modes.count = 5;
    focus.allocation.method = AllocationMethod::leastVoltage;
    focus.allocation.timesBound = upToLimits;
    focus.felt = FeltChoice { FeltAt::places, { { -0.06, 0 } }, 1, 0.01 };
    focus.threshold = findSkinThreshold ({});
    return focus;
}
} // namespace

TEST_CASE ("More weight on what is felt elsewhere needs more voltage and leaves less, on a plate with more modes",
           "[felt][freeWaveform]")
{
    const WideModel wide { test::sineBeam (16, 8), 10, "No more are known.", {} };
    RenderOptions options;
    options.playback.sampleRate = 48000;
    options.threshold = findSkinThreshold ({});
    std::size_t told = 0;
    const auto tradeoff = sweepFeltWeights (wide, weightedFocus(), options, {},
                                            [&] (const FeltTradeoff& now) { told = now.points.size(); });
    REQUIRE (tradeoff.points.size() > 3);
    CHECK (told == tradeoff.planned);
    CHECK (tradeoff.threshold == options.threshold->source);

    for (std::size_t i = 0; i < tradeoff.points.size(); ++i)
    {
        const auto& point = tradeoff.points[i];
        REQUIRE (point.failure.empty());
        CHECK (point.fieldError < 0.02);

        if (i > 0)
        {
            CHECK (point.weight > tradeoff.points[i - 1].weight);
            CHECK (point.bystanders.value() < tradeoff.points[i - 1].bystanders.value());
        }
    }

    const auto &plain = tradeoff.points.front(), &quiet = tradeoff.points.back();
    CHECK (quiet.peakVoltage > plain.peakVoltage);
    CHECK (quiet.target - quiet.bystanders.value() > plain.target - plain.bystanders.value() + 6);
}
