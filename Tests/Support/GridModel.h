#pragma once

#include <antinode_model/ModalModel.h>

namespace antinode::test
{
/** Shapes of a simply supported rectangular plate, sin ((k + 1) pi x / a) sin (pi y / b) or, every second, sin (2 pi y
   / b), on a grid of three by two segments of Gauss places, as a computed plate has it. The frequencies only ascend. */
ModalModel gridModel (int modesAlongX, int ceramics, int placesASegment = 8);
} // namespace antinode::test
