#pragma once

#include "Report.h"

#include <antinode_render/RenderedFocus.h>

#include <vector>

namespace antinode
{
/** The numbers that tell how good a focus is, each with a sentence of what it means: for the report and the editor. [any] */
std::vector<ReportScore> focusScores (const RenderedFocus&);
} // namespace antinode
