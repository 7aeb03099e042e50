#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace antinode
{
enum class FollowingState
{
    off,
    waiting,   ///< Nothing was heard yet that says how the sensor hears.
    following, ///< The newest window was explained, and taken in.
    silent,    ///< Too little is played to hear anything.
    lost,      ///< The newest window is not explained: nothing was learnt of it, and the reason is said.
    frozen,
    paused,    ///< What would be heard is of no use, and the reason is said.
    impossible ///< This device or sensor cannot be followed, and the reason is said.
};

/** One window of a followed drift. */
struct FollowedMoment
{
    double time = 0; ///< s of playing since following began.
    FollowingState state = FollowingState::silent;
    double common = 0;      ///< Relative change of all frequencies from the model: the mean by what is known of each.
    double deviation = 0;   ///< Of this, standard deviation.
    double unexplained = 0; ///< RMS share of the signal.
};

/** What following says of a device at the moment, for displays. Immutable. */
struct FollowingStatus
{
    FollowingState state = FollowingState::off;
    std::string reason;                ///< A sentence where it is lost or impossible, or of a jump; else empty.
    std::vector<FollowedMoment> trace; ///< The newest of them, the oldest first.
    Eigen::VectorXd changes;           ///< Relative, of the frequency of each followed mode.
    Eigen::VectorXd deviations;        ///< Of these, standard deviations.
    double delay = 0;                  ///< s, from the voltages to the sensor's signal.
    double longestWindow = 0;          ///< s of processor time that a window took at most.
    int redesigns = 0;                 ///< Times that the foci were designed again since following began.
};
} // namespace antinode
