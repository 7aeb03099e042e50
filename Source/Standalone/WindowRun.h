#pragma once

#include "StandaloneHost.h"

namespace antinode
{
/** Shows the window until it is closed or the user interrupts the program.
    @throws InputError  where there is no display
    [message thread] runs the message loop */
void runWithWindow (StandaloneHost&);
} // namespace antinode
