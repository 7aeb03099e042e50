#pragma once

#include "DriveAllocation.h"
#include "FocusDesign.h"

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

// designFocus in two steps, for designs of which several are tried and one is finished.

/** What is played until the focus: target, modes, transients, allocation. [worker] As designFocus. */
FocusDesign allocateFocus (const ModalModel&, const FocusDescription&, Playback, DesignExtent);

/** Adds the brake, what the extent asks to know, and remarks.
    @param model  the one that it was allocated for [worker] */
FocusDesign finishDesign (FocusDesign, const ModalModel& model, DesignExtent);

/** Gives a design its program: drives and their allocation, with the certificate. Where one drive per mode cannot meet
   the limit, exact rows get further drives before they are refused.
    @param design  with what is wanted, when, and of which modes
    @throws LimitError  when the limits cannot be kept; Cancelled, InputError as solveAllocation
    [worker] Docs/Theory.md, sections 3 and 4. */
void allocateProgram (FocusDesign& design, const ModalModel&);

/** The same as samples of any form.
    @throws InputError  where samples are no answer: on devices with slew limits; LimitError as above
    [worker] Docs/Theory.md, section 4.9. */
void sampleProgram (FocusDesign& design, const ModalModel&, DesignExtent);
} // namespace antinode
