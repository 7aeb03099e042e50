#include "PlaceOutcome.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_render/RenderedFocus.h>

#include <algorithm>
#include <limits>

namespace antinode
{
namespace
{
constexpr Playback playback { Reconstruction::bandLimited, 192000 };

/** A model of which nothing limits the drives. */
ModalModel unlimitedModel (const ModalModel& device)
{
    auto model = withoutVoltageLimits (device);

    for (auto& ceramic : model.ceramics)
        ceramic.slewLimit = 0;

    return model;
}

FocusDesign designUnlimited (const ModalModel& model, FocusDescription focus)
{
    focus.allocation.voltageLimit.reset();
    return designFocus (model, focus, playback, DesignExtent::playable);
}
} // namespace

std::vector<PlacementOutcome> placementOutcomes (const ModalModel& device, const std::vector<FocusDescription>& focuses)
{
    const auto model = unlimitedModel (device);
    std::vector<PlacementOutcome> outcomes;

    for (const auto& focus : focuses)
    {
        const auto rendered = renderFocus (model, designUnlimited (model, focus), { playback, {}, {} });
        outcomes.push_back ({ focus.name, rendered.render.voltages.cwiseAbs().maxCoeff(),
                              voltageLimits (device).maxCoeff(), rendered.score.fieldError, rendered.contrast });
    }

    return outcomes;
}

PlacementCost peakVoltageCost (const DeviceDescription& device, const std::vector<FocusDescription>& focuses)
{
    return [=] (const std::vector<CeramicDescription>& ceramics)
    {
        double highest = 0;

        try
        {
            const auto model = unlimitedModel (solveStructure (withCeramics (device, ceramics)));

            for (const auto& focus : focuses)
                highest = std::max (highest, peakVoltage (designUnlimited (model, focus)));
        }
        catch (const InputError&)
        {
            return std::numeric_limits<double>::infinity(); // these ceramics cannot reach it
        }

        return highest;
    };
}
} // namespace antinode
