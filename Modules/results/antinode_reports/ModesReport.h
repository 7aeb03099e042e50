#pragma once

#include "Report.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** The report of a device's modes: the device from above, frequencies and ceramics in a table, pictures of the lowest
    shapes, participation.
    @param elastic  the parts of its boundary that rest on springs, m
    [worker] */
ReportPage modesReport (const ModalModel&, const std::vector<PathPiece>& elastic = {});
} // namespace antinode
