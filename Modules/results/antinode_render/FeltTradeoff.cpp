#include "FeltTradeoff.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/DesignFocus.h>

#include <algorithm>
#include <array>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::array triedWeights { 0.0, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0 };

bool isFelter (const FeltPlace& a, const FeltPlace& b)
{
    return a.level < b.level;
}

void lookAt (FeltTradeoffPoint& point, const RenderedFocus& played)
{
    const auto& felt = played.felt.value();
    point.peakVoltage = peakVoltage (played.design);
    point.fieldError = played.truncatedScore.fieldError;
    point.target = std::min_element (felt.targets.begin(), felt.targets.end(), isFelter)->level;

    if (felt.elsewhere)
        point.elsewhere = felt.elsewhere->level;

    if (! felt.bystanders.empty())
        point.bystanders = std::max_element (felt.bystanders.begin(), felt.bystanders.end(), isFelter)->level;
}
} // namespace

FeltTradeoff sweepFeltWeights (const WideModel& wide, const FocusDescription& focus, const RenderOptions& options,
                               const WidenModel& widen, const std::function<void (const FeltTradeoff&)>& progress)
{
    FeltTradeoff tradeoff { {}, options.threshold.value().source, triedWeights.size() };

    for (const auto weight : triedWeights)
    {
        auto weighted = focus;
        weighted.felt.value().weight = weight;
        FeltTradeoffPoint point;
        point.weight = weight;

        try
        {
            auto made = designWide (wide, weighted, options.playback, widen);
            lookAt (point, renderFocus (std::move (made.wide), std::move (made.design), options));
        }
        catch (const InputError& error)
        {
            if (tradeoff.points.empty())
                throw;

            point.failure = error.what();
        }

        tradeoff.points.push_back (point);

        if (progress)
            progress (tradeoff);
    }

    return tradeoff;
}
} // namespace antinode
