#pragma once

#include <antinode_focus/Tolerance.h>

#include <filesystem>
#include <functional>

namespace antinode
{
/** evaluateTolerance whose draws are kept in parts, as those of a sweep: after a kill at any moment the same call
    computes what is missing. The result is the same to the bit.
    @param folder    made where it is missing; studies that differ in anything have different parts in it
    @param progress  0 to 1 of what was missing, from any thread, one at a time
    @throws InputError  as evaluateTolerance, and when the folder cannot be written
    @throws Cancelled   when a watch of this thread says no; parts that are finished stay
    [worker], on all cores. Docs/Design/sweeps.md. */
Tolerance resumableTolerance (const std::filesystem::path& folder, const ModalModel&, const FocusDesign&,
                              const ToleranceOptions&, const std::function<void (double)>& progress);
} // namespace antinode
