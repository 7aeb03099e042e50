#include "PlaceSearch.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_structure/Placing.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <variant>

namespace antinode
{
namespace
{
constexpr int modesOfCost = 30;

const std::vector<CeramicDescription>& ceramicsIn (const DeviceDescription& device)
{
    static const std::vector<CeramicDescription> none;
    return std::visit (
        [] (const auto& body) -> const std::vector<CeramicDescription>&
        {
            if constexpr (requires { body.common; })
                return body.common.ceramics;
            else
                return none;
        },
        device.body);
}

bool areAlike (const std::vector<CeramicDescription>& ceramics)
{
    const auto& first = ceramics.front();
    return std::all_of (ceramics.begin(), ceramics.end(),
                        [&] (const CeramicDescription& each)
                        {
                            return each.shape == first.shape && std::abs (each.sizeX - first.sizeX) < 1e-9
                                   && std::abs (each.sizeY - first.sizeY) < 1e-9 && each.angle == first.angle;
                        });
}

/** The voltage of the focus on coarse modes, whatever the limits; infinite where it cannot be reached. */
std::function<double (const std::vector<CeramicDescription>&)> voltageCost (const PlaceQuestion& question)
{
    auto focus = question.focus;
    focus.modes = {};
    focus.fingers.clear();
    focus.allocation.voltageLimit.reset();
    return [device = question.device, focus,
            playback = question.playback] (const std::vector<CeramicDescription>& ceramics)
    {
        try
        {
            const auto model = solveCoarsely (withCeramics (device->description, ceramics), modesOfCost);
            return peakVoltage (designFocus (withoutVoltageLimits (model), focus, playback, DesignExtent::playable));
        }
        catch (const InputError&)
        {
            return std::numeric_limits<double>::infinity();
        }
    };
}
} // namespace

void PlaceSearch::ask (PlaceQuestion question)
{
    const std::lock_guard lock (mutex);
    known = {};
    known.device = question.device;
    known.isRunning = true;
    questions.ask (std::move (question));
}

void PlaceSearch::stop()
{
    const std::lock_guard lock (mutex);
    questions.giveUp();
    known = {};
}

PlaceProgress PlaceSearch::progress() const
{
    const std::lock_guard lock (mutex);
    return known;
}

/** Of a search that was not given up. */
void PlaceSearch::set (const std::function<void (PlaceProgress&)>& change)
{
    const std::lock_guard lock (mutex);

    if (! questions.isOutdated())
        change (known);
}

void PlaceSearch::run()
{
    const WatchScope scope ([this] { return ! questions.isOutdated(); });

    while (const auto question = questions.take())
    {
        try
        {
            search (*question);
        }
        catch (const Cancelled&)
        {
            // Nobody wants it any more.
        }
        catch (const std::exception& failure)
        {
            set ([&] (PlaceProgress& now) { now.error = failure.what(); });
        }

        set ([] (PlaceProgress& now) { now.isRunning = false; });
    }
}

void PlaceSearch::search (const PlaceQuestion& question)
{
    const auto& device = question.device->description;
    const auto& ceramics = ceramicsIn (device);

    if (ceramics.empty() || ! areAlike (ceramics))
        throw InputError ("device", "has no ceramics, or different ones; allowed: one or more of one size and shape");

    const auto cost = voltageCost (question);
    const auto& like = ceramics.front();
    PlacingOptions options;
    options.count = static_cast<Eigen::Index> (ceramics.size());
    options.grid.step = std::min (like.sizeX, like.sizeY) / 2;
    options.grid.freeEdgeMargin = 2e-3;
    options.grid.modes = modesOfCost;
    options.costOf = [&cost] (const PlacementCandidates& candidates) -> PlacementCost
    {
        return [&cost, &candidates] (const std::vector<Eigen::Index>& chosen)
        { return cost (chosenCeramics (candidates, chosen)); };
    };
    options.isResolved = false;
    const auto found = placeCeramics (
        device, like, options, [this] (double share) { set ([share] (PlaceProgress& now) { now.share = share; }); });
    const auto now = cost (ceramics), there = cost (found.ceramics);
    set (
        [&] (PlaceProgress& known)
        {
            known.voltsNow = now;
            known.voltsThere = there;

            if (there < now)
                known.ceramics = found.ceramics;
            else
                known.error = "No better places were found; the ceramics lie well where they are";
        });
}
} // namespace antinode
