#pragma once

#include "DriveAllocation.h"
#include "FocusDesign.h"
#include "LimitError.h"

namespace antinode
{
/** What a design is made for. */
enum class DesignExtent
{
    complete, ///< To be looked at: with the bound that no waveform beats, which takes longer than all the rest.
    playable  ///< To be played at once: without it.
};

/** From what is wanted to what is played: project, choose modes, transients, allocate.
    @param playback  what the exact terminal rows are computed for
    @param watch     looked at by the allocation's solver before every step
    @throws LimitError  when the voltage limit cannot be met (proven); AllocationCancelled when the watch says no; InputError for all
                        else that cannot be done
    [worker] Docs/Theory.md, sections 2 to 4. */
FocusDesign designFocus (const ModalModel&, const FocusDescription&, Playback,
                         DesignExtent extent = DesignExtent::complete, const AllocationWatch& watch = {});

/** The second half: modal velocities prescribed instead of projected, for example for tests of single modes.
    @param modes   ascending mode indices
    @param wanted  their modal velocities at t_f, m/s kg^1/2
    @throws        as designFocus
    [worker] Docs/Theory.md, sections 3 and 4. */
FocusDesign designModes (const ModalModel&, const FocusDescription&, const std::vector<int>& modes,
                         const Eigen::VectorXd& wanted, Playback);

/** The largest voltage of any ceramic that the drives of a design and their release ask for, before any limiter. V. [any] */
double peakVoltage (const FocusDesign&);
} // namespace antinode
