#pragma once

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusDesign.h>

#include <stdexcept>

namespace antinode::test
{
/** V: the least peak that one drive per mode needs, to 0.1 %, as the refusal of a limit far below it says. */
inline double leastPeakVoltage (const ModalModel& model, FocusDescription focus)
{
    focus.allocation.voltageLimit = 1e-3;

    try
    {
        designFocus (model, focus, {}, DesignExtent::compared);
    }
    catch (const LimitError& error)
    {
        return error.minimumPeakVoltage;
    }

    throw std::logic_error ("the limit was not refused");
}
} // namespace antinode::test
