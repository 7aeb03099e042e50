#include <antinode_documents/Inputs.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_render/RenderedFocus.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace antinode;

namespace
{
const ModalModel& glassPlate()
{
    static const auto model = solveStructure (loadDevice ("glass-148x210", {}));
    return model;
}

/** A bump of 25 mm and 20 mm/s, 25 ms after the trigger. */
FocusDescription bumpAt (double x, double y, AllocationMethod method)
{
    FocusDescription focus;
    focus.targets = { Target {} };
    focus.targets[0].shape = TargetShape::bump;
    focus.targets[0].x = x;
    focus.targets[0].y = y;
    focus.targets[0].width = 0.025;
    focus.targets[0].peakVelocity = 0.02;
    focus.focusTime = 0.025;
    focus.allocation.method = method;
    return focus;
}

/** The bound over all waveforms takes 3 s at 300 modes, ten times what all the rest does: only where it is looked at.
 */
RenderedFocus rendered (const FocusDescription& focus, DesignExtent extent = DesignExtent::playable)
{
    RenderOptions options;
    options.duration = 0.026;
    return renderFocus (glassPlate(), designFocus (glassPlate(), focus, options.playback, extent), options);
}
} // namespace

TEST_CASE ("A 25 mm focus at 25 random places of the glass plate, in the plate model at 192 kHz", "[render]")
{
    std::mt19937 random (7);
    const auto between = [&] (double low, double high)
    { return low + (high - low) * static_cast<double> (random()) / 4294967296.0; };
    REQUIRE (glassPlate().modes() == 300);
    REQUIRE (glassPlate().actuators() == 32);
    double worstPaperError = 0;

    for (int place = 0; place < 25; ++place)
    {
        const auto x = between (0.015, 0.195), y = between (0.015, 0.133);
        CAPTURE (x, y);
        const auto extent = place == 0 ? DesignExtent::complete : DesignExtent::playable;
        const auto exact = rendered (bumpAt (x, y, AllocationMethod::exact), extent);
        CHECK (exact.truncatedScore.vScore >= 0.999);
        CHECK (exact.truncatedScore.fieldError <= 0.02);
        CHECK (exact.truncatedScore.peakRatio == Approx (1).epsilon (0.01));
        CHECK (exact.design.captured >= 0.99);
        CHECK (exact.contrast > 20);
        CHECK (exact.render.voltages.cwiseAbs().maxCoeff() <= 100);

        if (extent == DesignExtent::complete)
        {
            CHECK (exact.design.lowerBoundGap <= 0.005);
            CHECK (exact.design.lowerBoundVoltage > 0);
            CHECK (exact.design.lowerBoundVoltage <= exact.render.voltages.cwiseAbs().maxCoeff());
        }

        if (place % 5 == 0)
            worstPaperError =
                std::max (worstPaperError, rendered (bumpAt (x, y, AllocationMethod::paper)).truncatedScore.fieldError);
    }

    // The paper's rows drop what modes do to each other: several per cent on a plate.
    CHECK (worstPaperError > 0.03);
}

TEST_CASE ("Two foci of opposite sign at once on the glass plate", "[render]")
{
    auto focus = bumpAt (0.06, 0.06, AllocationMethod::exact);
    focus.targets.push_back (focus.targets[0]);
    focus.targets[1].x = 0.15;
    focus.targets[1].y = 0.088;
    focus.targets[1].phase = -1;
    const auto result = rendered (focus);
    CHECK (result.truncatedScore.fieldError <= 0.02);
    const auto at = [&] (double x, double y)
    { return shapesAt (result.model, x, y).dot (result.render.focusVelocities); };
    CHECK (at (0.06, 0.06) == Approx (0.02).epsilon (0.15));
    CHECK (at (0.15, 0.088) == Approx (-0.02).epsilon (0.15));
}
