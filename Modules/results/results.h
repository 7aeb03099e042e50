#pragma once

// What users get: renders and their scores, sweeps, reports and figures, and the tasks that commands and Python share.
// Rooms and their headers: Docs/Architecture.md.

#include <antinode_render/RenderedFocus.h>
#include <antinode_reports/Report.h>
#include <antinode_sweep/SweepPlan.h>
#include <antinode_tasks/Identify.h>
#include <antinode_tasks/Render.h>
