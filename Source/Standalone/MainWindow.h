#pragma once

#include "MainComponent.h"

#include <functional>
#include <memory>

namespace antinode
{
/** Shows the window until it is closed or the user interrupts the program.
    @param makeContent  called where there is a display
    @throws InputError  where there is no display
    [message thread] runs the message loop */
void runWithWindow (const std::function<std::unique_ptr<MainComponent>()>& makeContent);
} // namespace antinode
