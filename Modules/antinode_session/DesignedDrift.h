#pragma once

#include <Eigen/Core>

#include <utility>

namespace antinode
{
/** What designs know of a drift: the relative changes of all frequencies that they were made for. [session's thread] */
class DesignedDrift
{
public:
    /** Whether frequencies have moved by more than designs bear; by more where these are still being made. */
    bool isOutdated (const Eigen::VectorXd& changes, bool areMade) const
    {
        constexpr double smallest = 5e-5; // of a frequency: designs that are off by less stay
        constexpr double large = 5e-4;    // designs that are off by more are not finished before

        if (known.size() != changes.size() || changes.size() == 0)
            return false;

        const auto most = (changes - known).cwiseAbs().maxCoeff();
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
