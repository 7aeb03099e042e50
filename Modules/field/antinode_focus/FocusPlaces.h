#pragma once

#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/Surface.h>
#include <antinode_model/VoltageProgram.h>

#include <utility>
#include <vector>

namespace antinode
{
/** Places for the foci of a bank: along the centre line of a beam's surface from left to right, or row by row from the
   lower left corner over a plate, in a grid whose fields are about as high as wide.
    @param count   less than 1: none
    @param margin  m, kept from every edge; at most a third of the side is
    @return        x, y in m
    [any] */
std::vector<std::pair<double, double>> bankPlaces (const Surface&, int count, double margin);

/** A focus with its first target at another place, x, y in m; the others keep their distance to it. [any] */
FocusDescription movedTo (FocusDescription, double x, double y);

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
