#pragma once

#include "Report.h"

#include <antinode_focus/DesignTolerance.h>

namespace antinode
{
/** The report on devices that differ from the model: scores, histogram, percentiles, what hurts most. The last design is the one
    reported on, the others are shown beside it.
    @param focus  its name
    [worker] */
ReportPage toleranceReport (const ModalModel&, const std::string& focus, const std::vector<DesignTolerance>&);
} // namespace antinode
