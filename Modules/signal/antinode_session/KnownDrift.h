#pragma once

#include <Eigen/Core>
#include <antinode_learning/FollowWindow.h>

#include <memory>
#include <utility>
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

/** Relative changes of all frequencies, and their standard deviations: N_m each. */
struct FrequencyShift
{
    Eigen::VectorXd changes, deviations;
};

/** What designs know of a drift: the changes of all frequencies that they were made for. [session's thread] */
class DesignedDrift
{
public:
    /** Whether frequencies have moved by more than designs bear, and by more than is uncertain of them; by more where
        these are still being made. */
    bool isOutdated (const FrequencyShift& now, bool areMade) const
    {
        constexpr double smallest = 5e-5; // of a frequency: designs that are off by less stay
        constexpr double large = 5e-4;    // designs that are off by more are not finished before

        if (known.size() != now.changes.size() || known.size() == 0)
            return false;

        const Eigen::ArrayXd moved = (now.changes - known).array().abs();
        const auto most = (moved > now.deviations.array()).select (moved, 0).maxCoeff();
        return most > large || (most > smallest && areMade);
    }

    /** Designs are made for these. @return  whether they were made for others before */
    bool note (Eigen::VectorXd changes)
    {
        const auto isOther = known.size() > 0 && changes.size() > 0 && known != changes;
        known = std::move (changes);
        return isOther;
    }

private:
    Eigen::VectorXd known; ///< N_m; empty: nothing was designed yet.
};
} // namespace antinode
