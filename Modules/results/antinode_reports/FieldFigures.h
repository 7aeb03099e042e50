#pragma once

#include "Report.h"

#include <antinode_render/RenderedFocus.h>

namespace antinode
{
/** Pictures of the field at the focus and around it: curves of a line; maps and cross sections of a plate. [worker] */
std::vector<ReportFigure> fieldFigures (const RenderedFocus&);

/** Of a train, a picture of the field at each focus after the first. [worker] */
std::vector<ReportFigure> laterFieldFigures (const RenderedFocus&);

/** What skin feels of a whole event: a map of sensation levels, the contrast in words. The focus has it.
    [worker] Docs/Theory.md, section 5.1. */
ReportSection feltSection (const RenderedFocus&);

/** The sensation level everywhere: a map, or a curve on a line. [worker] */
ReportFigure feltFigure (const ModalModel&, const FeltOutcome&);
} // namespace antinode
