#pragma once

#include <antinode_learning/FollowWindow.h>

#include <memory>
#include <vector>

namespace antinode
{
/** What is known of the drift of a device, with what it is known of. Immutable. */
struct KnownDrift
{
    Eigen::VectorXd nominal; ///< rad/s, of the modes that are followed, as they are without drift.
    DriftLayout layout;
    SensedDrift sensed;

    /** Whether it is that of a device. [any] */
    bool isOf (const ModalModel& model) const
    {
        return nominal.size() <= model.modes() && model.angularFrequencies.head (nominal.size()) == nominal;
    }
};

/** What a device that is followed differs in from its description. Immutable. */
struct DriftedDevice
{
    std::shared_ptr<const KnownDrift> drift; ///< None: as described.
    std::vector<int> idle;                   ///< Ceramics that listen and are not driven, from 1.

    /** A model of it as designs know it. @param model  as described [worker] */
    ModalModel asDriven (ModalModel model) const;

    /** The same; the model itself where nothing differs. [worker] */
    std::shared_ptr<const ModalModel> asDriven (const std::shared_ptr<const ModalModel>& model) const;
};
} // namespace antinode
