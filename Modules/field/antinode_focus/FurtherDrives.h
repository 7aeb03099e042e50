#pragma once

#include "DriveAllocation.h"

namespace antinode
{
/** Drives in addition to those that driveModes chose: one per mode that rises three times as fast, so that a mode's
   velocity can be made from two envelopes whose errors cancel. None if growths are given.
    @throws InputError  as driveModes
    [any] Docs/Theory.md, section 7.5. */
DriveList fasterDrives (const ModalModel&, const std::vector<int>& modes, double focusTime, const TransientChoice&);

/** The faster drives, and each of all these drives once more, begun a quarter period later, or earlier where it lasts
   no more than that: for voltage limits that one drive per mode cannot meet.
    @param choice  with offset-free drives
    @throws InputError  as driveModes
    [any] Docs/Theory.md, section 4.7. */
DriveList furtherDrives (const ModalModel&, const std::vector<int>& modes, double focusTime,
                         const TransientChoice& choice);
} // namespace antinode
