#pragma once

#include <antinode_model/ModalModel.h>

namespace antinode
{
/** What slow modes still do in a recording from before its beginning, where nothing is known of the voltages: any sum
    of their free decays. It is taken out of what is compared. */
class RingingBefore
{
public:
    /** @param modes    as they are taken to be
        @param memory   s before the first sample that is compared: modes that have decayed by then are left out
        @param samples  that are compared
        [worker] Docs/Theory.md, section 7.7. */
    RingingBefore (const ModalModel& modes, double sampleRate, double memory, Eigen::Index samples);

    /** Takes it out of signals, N_s x any. [worker] */
    void takeOutOf (Eigen::Ref<Eigen::MatrixXd> signals) const;

private:
    Eigen::MatrixXd basis; // N_s x 2 for each slow mode, orthonormal
};
} // namespace antinode
