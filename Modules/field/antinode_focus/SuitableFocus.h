#pragma once

#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/Playback.h>

namespace antinode
{
/** The place of a surface that is farthest from edges, holes and ceramics, of equal ones the one next to its centre. m
    [worker] */
Eigen::Vector2d middleOfFreeArea (const ModalModel&);

/** How far a place is from the nearest edge or hole of a surface, m; on a line from the nearest end. [any] */
double distanceToEdge (const Surface&, double x, double y);

/** A focus to begin with on a device: in the middle of its largest free area, as narrow as its modes represent well, as
    quick as its limits let it be, but not quicker than a finger needs. Modes, drives and allocation are the default.
    @throws Cancelled  when a watch of this thread says no [worker] */
FocusDescription suitableFocus (const ModalModel&, Playback);
} // namespace antinode
