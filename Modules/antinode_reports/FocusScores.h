#pragma once

#include "Report.h"

#include <antinode_render/RenderedFocus.h>

#include <vector>

namespace antinode
{
/** The scores of a focus, each with a sentence that explains it, for the report and the editor. [any] */
std::vector<ReportScore> focusScores (const RenderedFocus&);
} // namespace antinode
