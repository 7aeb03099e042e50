#pragma once

#include "Report.h"

#include <antinode_model/ModalModel.h>
#include <antinode_sweep/FocusMap.h>

namespace antinode
{
/** The report of a map: what a focus comes to everywhere on a surface, as heat maps or, on a line, as curves.
    @param model  whose ceramics are drawn [worker] */
ReportPage mapReport (const FocusMap&, const ModalModel& model);
} // namespace antinode
