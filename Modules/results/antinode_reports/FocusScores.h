#pragma once

#include "Report.h"

#include <antinode_render/FocusOutcome.h>

#include <vector>

namespace antinode
{
/** The scores of a focus, each with a sentence that explains it, for the report and the editor: first what was wanted
   and what is reached, then what limits it, then the internal scores. [any] */
std::vector<ReportScore> focusScores (const RenderedFocus&, const FocusOutcome&);
} // namespace antinode
