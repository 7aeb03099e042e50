#pragma once

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** The modes that skin may feel, those below 3 kHz and at least 24, on a grid with half as many places in each
   direction.
    @throws nothing
    [worker] Docs/Design/sweeps.md. */
ModalModel feltModes (const ModalModel&);
} // namespace antinode
