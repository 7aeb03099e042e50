#pragma once

#include "Report.h"

#include <antinode_render/RenderedFocus.h>

namespace antinode
{
/** Current, energy and power of a focus and of its repetition: per ceramic, in all, and of amplifiers. The focus has
   them. [worker] Docs/Theory.md, section 6.8. */
ReportSection powerSection (const RenderedFocus&);
} // namespace antinode
