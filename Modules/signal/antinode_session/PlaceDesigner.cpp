#include "PlaceDesigner.h"

#include <antinode_documents/FocusFile.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/LimitError.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
namespace
{
/** Where more of a field than this is in modes beyond, a place guards all that are known of. */
constexpr double mostSpillOver = 1.5 * allowedSpillOver;

/** A request without its limits. */
std::string textWithoutLimits (FocusDescription focus, Playback playback)
{
    focus.allocation.voltageLimit.reset();
    return focusToJson (focus).dump() + std::to_string (playback.sampleRate);
}
} // namespace

void PlaceDesigner::begin (const DesignRequest& request)
{
    auto text = textWithoutLimits (request.focus, request.playback);

    if (known != request.model)
        wide.reset();

    if (known != request.model || guardedFocus != text)
        guarded.reset();

    known = request.model;
    guardedFocus = std::move (text);
    areGuardsSure = false;
}

FocusDesign PlaceDesigner::design (const DesignRequest& request, const FocusDescription& focus)
{
    const auto isSampled = methodTraits (focus.allocation.method).waveforms == AllocatedWaveforms::samples;

    if (isSampled && request.widen)
        return designSamples (request, focus);

    return designFocus (*request.model, focus, request.playback, DesignExtent::playable);
}

FocusDesign PlaceDesigner::designSamples (const DesignRequest& request, const FocusDescription& focus)
{
    if (! wide)
        wide = request.widen();

    try
    {
        if (guarded)
            return designKeepingGuards (focus, request.playback);
    }
    catch (const LimitError&)
    {
        // The limits may leave room for fewer guards.
    }

    auto design = designWithin (*wide, focus, request.playback, DesignExtent::playable);

    if (! guarded && design.spillOver)
    {
        guarded = firstModes (wide->model, wide->known + design.spillOver->guardedBeyond);
        areGuardsSure = true;
    }

    return design;
}

/** The first place after limits moved says whether its guards still do; where not, the next one looks for others. A
   place that needs more than the first one has them for itself. */
FocusDesign PlaceDesigner::designKeepingGuards (const FocusDescription& focus, Playback playback)
{
    auto design = designGuarding (*guarded, wide->known, focus, playback);
    const auto share = spillOverShare (*wide, design);
    const auto mayGuardMore = guarded->modes() < wide->model.modes();

    if (! std::exchange (areGuardsSure, true) && share > allowedSpillOver)
        guarded.reset();

    if (share > mostSpillOver && mayGuardMore)
        return withAllGuards (std::move (design), share, focus, playback);

    return design;
}

/** Guards all modes that are known of where that leaves less in them and no more elsewhere, and limits allow it. */
FocusDesign PlaceDesigner::withAllGuards (FocusDesign design, double share, const FocusDescription& focus,
                                          Playback playback) const
{
    try
    {
        auto more = designGuarding (wide->model, wide->known, focus, playback);
        const auto isBetter = spillOverShare (*wide, more) < share
                              && largestFieldError (wide->model, more) <= largestFieldError (wide->model, design);
        return isBetter ? std::move (more) : std::move (design);
    }
    catch (const LimitError&)
    {
        return design;
    }
}
} // namespace antinode
