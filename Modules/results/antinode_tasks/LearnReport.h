#pragma once

#include <antinode_learning/LearningPasses.h>
#include <antinode_reports/Report.h>

namespace antinode
{
/** The report of passes of learning: the field error of each, what was learnt of each mode with the deviations before
   and after, and what the data could not tell.
    @param nominal  as it was before
    @param before   what was known then [any] */
ReportPage learningReport (const LearntFocus&, const WideModel& nominal, const ModeSpread& before);
} // namespace antinode
