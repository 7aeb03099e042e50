#include "Support/SineBeam.h"

#include <antinode_focus/DesignFocus.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace antinode;

namespace
{
/** Narrow enough for a third of the modes, on a beam with so few ceramics that guards cost volts. */
FocusDescription openFocus (double limit)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::gaussian, 0.02, 0, 0.04, 0.04, 1 } };
    focus.focusTime = 0.025;
    focus.allocation.voltageLimit = limit;
    return focus;
}

FocusDesign withModes (const ModalModel& model, FocusDescription focus, int count)
{
    focus.modes.count = count;
    return designFocus (model, focus, {}, DesignExtent::playable);
}

bool mentions (const FocusDesign& design, const std::string& text)
{
    return std::any_of (design.choices.begin(), design.choices.end(),
                        [&] (const auto& choice) { return choice.find (text) != std::string::npos; });
}
} // namespace

TEST_CASE ("Modes that need little of the limit are the fewest that capture 0.99, to the bit", "[focus]")
{
    const auto model = test::sineBeam (40, 4);
    const auto open = designFocus (model, openFocus (1e4), {}, DesignExtent::playable);
    auto captured = openFocus (1e4);
    captured.modes.captured = 0.99;
    const auto stated = designFocus (model, captured, {}, DesignExtent::playable);
    CHECK (open.controlledModes == stated.controlledModes);
    CHECK (open.program.allocation == stated.program.allocation);
    CHECK (mentions (open, "at most a quarter of the limit"));
    CHECK_FALSE (mentions (stated, "weighed"));
}

TEST_CASE ("Near the limit the number of modes is the fewest that need hardly more than the least", "[focus]")
{
    auto model = test::sineBeam (40, 4);
    auto captured = openFocus (1e4);
    captured.modes.captured = 0.99;
    const auto stated = designFocus (model, captured, {}, DesignExtent::playable);
    const auto fewest = static_cast<int> (stated.controlledModes.size());

    for (auto& ceramic : model.ceramics)
        ceramic.voltageLimit = 1e4;

    model.fullScaleVoltage = 1e4;
    const auto limit = 2 * peakVoltage (stated); // far enough that no design touches it, near enough to be weighed
    const auto open = designFocus (model, openFocus (limit), {}, DesignExtent::playable);
    std::vector<double> peaks;
    std::vector<int> counts;

    for (const auto multiple : { 1.0, 1.25, 1.5, 2.0, 3.0 })
    {
        counts.push_back (std::min (static_cast<int> (std::ceil (multiple * fewest)), 40));
        peaks.push_back (peakVoltage (withModes (model, openFocus (limit), counts.back())));
    }

    const auto least = *std::min_element (peaks.begin(), peaks.end());
    const auto best = std::find_if (peaks.begin(), peaks.end(), [least] (double peak) { return peak <= 1.05 * least; });
    CHECK (static_cast<int> (open.controlledModes.size()) == counts[static_cast<std::size_t> (best - peaks.begin())]);
    CHECK (peakVoltage (open) == *best);
    CHECK (open.captured >= stated.captured);
    CHECK (mentions (open, "Numbers of modes that were weighed: " + std::to_string (fewest) + " capture "));
}

TEST_CASE ("A focus that the fewest modes cannot reach is reached with more of them, or refused as theirs", "[focus]")
{
    const auto model = test::sineBeam (40, 4);
    auto stated = openFocus (150);
    stated.modes.captured = 0.99;
    auto limit = 150.0;
    std::string refusal;

    while (refusal.empty())
    {
        limit *= 0.8;
        stated.allocation.voltageLimit = limit;

        try
        {
            designFocus (model, stated, {}, DesignExtent::playable);
        }
        catch (const LimitError& error)
        {
            refusal = error.what();
        }
    }

    try
    {
        const auto open = designFocus (model, openFocus (limit), {}, DesignExtent::playable);
        CHECK (peakVoltage (open) <= limit);
        CHECK (mentions (open, " cannot keep the limits; "));
    }
    catch (const LimitError& error)
    {
        CHECK (error.what() == refusal);
    }
}
