#pragma once

#include "Design.h"
#include "RenderFiles.h"

#include <antinode_render/RenderedFocus.h>

#include <optional>
#include <utility>

namespace antinode
{
inline constexpr TaskText renderText { "render",
                                       "Renders a focus: voltages, velocities, scores and a report with figures",
                                       "Docs/Theory.md, sections 5 and 6" };

/** What is played on the plate model, and what is recorded of it. */
struct RenderRequest
{
    FocusRequest design;
    std::shared_ptr<const DesignedFocus> made;     ///< Played as it is, in place of a new design.
    std::vector<std::pair<double, double>> probes; ///< x, y, m; empty: those of the focus, or its targets.
    std::optional<double> duration;                ///< s from the trigger; none: until the surface has calmed down.
    int blockSize = 512;
};

/** [any] */
std::vector<Field> fields (RenderRequest&);

/** A focus as the plate model played it. */
struct RenderedDesign
{
    std::shared_ptr<const DesignedFocus> design;
    RenderedFocus focus;
    FocusOutcome outcome;
};

/** How a design is played. @throws InputError  for a threshold that cannot be read [worker] */
RenderOptions renderOptions (const RenderRequest&, const DesignedFocus&);

/** Designs a focus where there is no design, and plays it on the plate model.
    @throws InputError, LimitError  as design and renderFocus [worker] */
RenderedDesign render (const RenderRequest&, const ShowProgress&);
} // namespace antinode
