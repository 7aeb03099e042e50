#pragma once

#include <antinode_learning/TrackWindow.h>

namespace antinode
{
/** What is known of the drift of a device, with what it is known of. Immutable. */
struct KnownDrift
{
    Eigen::VectorXd nominal; ///< rad/s, of the modes that are tracked, as they are without drift.
    DriftLayout layout;
    TrackedDrift tracked;

    /** Whether it is that of a device. [any] */
    bool isOf (const ModalModel& model) const
    {
        return nominal.size() <= model.modes() && model.angularFrequencies.head (nominal.size()) == nominal;
    }
};
} // namespace antinode
