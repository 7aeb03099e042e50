#pragma once

#include <antinode_focus/FocusDesign.h>

#include <optional>

namespace antinode
{
/** A design that keeps what it plays and gets small drives beside it, one for each mode, which add what its field
   lacks. All modes that it hardly drives stay so, however little is known of them. Its brake, if any, stays as it is.
    @param learnt   the device, of N_m modes
    @param missing  N_m: velocities of the modes at the focus that the design lacks, m/s kg^1/2; what modes above .4 of
                    the playback's sample rate lack stays
    @return         none for trains and for programs of samples, and where the limits leave no room
    @throws InputError, Cancelled  as designModes
    [worker] Docs/Theory.md, section 7.6. */
std::optional<FocusDesign> correctedDesign (const FocusDesign&, const ModalModel& learnt,
                                            const Eigen::VectorXd& missing);
} // namespace antinode
