#include "PlaceDesigner.h"

#include <antinode_focus/DesignFocus.h>

namespace antinode
{
void PlaceDesigner::begin (const DesignRequest& request)
{
    guarded.reset();

    if (known != request.model)
        wide.reset();

    known = request.model;
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
            return designGuarding (*guarded, wide->known, focus, request.playback);
    }
    catch (const LimitError&)
    {
        // The limits may leave room for fewer guards.
    }

    auto design = designWithin (*wide, focus, request.playback, DesignExtent::playable);

    if (! guarded && design.spillOver)
        guarded = firstModes (wide->model, wide->known + design.spillOver->guardedBeyond);

    return design;
}
} // namespace antinode
