#pragma once

#include "DriveAllocation.h"
#include "FocusDesign.h"
#include "LimitError.h"

namespace antinode
{
/** The purpose of a design. */
enum class DesignExtent
{
    complete, ///< For inspection: with the lower bound over all waveforms, which takes longer than everything else.
    compared, ///< As one of many: without the bound and the shortest period.
    playable  ///< For immediate playback: as compared, without the peak between the samples of a free waveform.
};

/** Designs a focus: projects the wanted field, chooses modes and transients, allocates.
    @param playback  what the exact terminal rows are computed for
    @throws LimitError  when the voltage limit cannot be met (proven); Cancelled when a watch of this thread says no;
   InputError for all else that cannot be done [worker] Docs/Theory.md, sections 2 to 4. */
FocusDesign designFocus (const ModalModel&, const FocusDescription&, Playback,
                         DesignExtent extent = DesignExtent::complete);

/** The second half: modal velocities prescribed instead of projected, for example for tests of single modes.
    @param modes   ascending mode indices
    @param wanted  their modal velocities at t_f, m/s kg^1/2
    @throws        as designFocus
    [worker] Docs/Theory.md, sections 3 and 4. */
FocusDesign designModes (const ModalModel&, const FocusDescription&, const std::vector<int>& modes,
                         const Eigen::VectorXd& wanted, Playback, DesignExtent extent = DesignExtent::complete);

/** The largest voltage of any ceramic that the drives of a design and their release ask for, before any limiter. V.
    [any] */
double peakVoltage (const FocusDesign&);
} // namespace antinode
