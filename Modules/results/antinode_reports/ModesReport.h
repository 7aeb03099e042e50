#pragma once

#include "Chart.h"
#include "Report.h"

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** The report of a device's modes: the device from above, frequencies and ceramics in a table, pictures of the lowest
    shapes, participation.
    @param elastic  the parts of its boundary that rest on springs, m
    [worker] */
ReportPage modesReport (const ModalModel&, const std::vector<PathPiece>& elastic = {});

/** Whether its shapes are maps of a plate; else they are curves over a line. [any] */
bool isPlate (const ModalModel&);

/** A device from above: its surface and where the ceramics lie.
    @param elastic  the parts of its boundary that rest on springs, m
    [any] */
PlanView deviceChart (const ModalModel&, const std::vector<PathPiece>& elastic = {});

/** The shapes of the lowest modes, each scaled to its own largest value and named with its number and frequency: small
   maps with nodal lines of a plate, curves of a line.
    @param count  how many at most
    [worker] */
ChartGrid modeGallery (const ModalModel&, int count);

/** A height at which the gallery's pictures are well shaped, in pixels at scale 1. [any] */
int comfortableGalleryHeight (const ModalModel&, int count, int width);

/** How strongly each ceramic drives each mode, relative to the mode's strongest: a table in colours, one column per
   mode. The model has ceramics. [any] */
HeatMap participationChart (const ModalModel&);
} // namespace antinode
