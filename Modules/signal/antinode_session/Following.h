#pragma once

#include "KnownDrift.h"

#include <Eigen/Core>
#include <antinode_base/Reflection.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace antinode
{
/** What listens to the device that plays, so that its drift is followed. */
enum class FollowingSensor
{
    none,           ///< Nothing: the drift is not followed.
    velocity,       ///< A sensor at a place: a laser vibrometer, or an accelerometer that is integrated.
    displacement,   ///< The same for displacements.
    ceramicCurrent, ///< The current of an idle ceramic.
    ceramicCharge   ///< Its charge, or its voltage without load.
};

/** What files and options call them. */
inline constexpr WordList<FollowingSensor, 4> followingSensorWords {
    { { "velocity", FollowingSensor::velocity },
      { "displacement", FollowingSensor::displacement },
      { "ceramic_current", FollowingSensor::ceramicCurrent },
      { "ceramic_charge", FollowingSensor::ceramicCharge } }
};

/** How the drift of the device is followed while it plays. */
struct FollowingSettings
{
    FollowingSensor sensor = FollowingSensor::none;
    double xMillimetres = 0, yMillimetres = 0; ///< Of a sensor at a place.
    int ceramic = 0;                           ///< That is idle, counted from 0; it is not driven.
    bool isFrozen = false;                     ///< Foci stay as they are, nothing is learnt.

    bool isOn() const { return sensor != FollowingSensor::none; }
    bool isCeramic() const
    {
        return sensor == FollowingSensor::ceramicCurrent || sensor == FollowingSensor::ceramicCharge;
    }

    bool operator== (const FollowingSettings&) const = default;
};

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

/** What is new of following in a round of a session's thread. */
struct FollowingRound
{
    FollowingSettings settings;
    bool isDriftNew = false; ///< Whether it goes on from the next line; none: the model.
    std::shared_ptr<const KnownDrift> drift;
};

/** What a session's thread is asked of following, and what it answers, under one lock. */
class FollowingRequests
{
public:
    /** [any but the audio thread] */
    void setSettings (const FollowingSettings&);
    FollowingSettings settings() const;

    /** Goes on from another drift. @param known  of the device that plays; none: as the model [any but the audio
        thread] */
    void setDrift (std::shared_ptr<const KnownDrift> known);

    /** What is known of the drift; none: nothing. [any but the audio thread] */
    std::shared_ptr<const KnownDrift> drift() const;

    /** [any but the audio thread] */
    std::shared_ptr<const FollowingStatus> status() const;

    /** What was asked for since the last call. [session's thread] */
    FollowingRound take();

    /** What is followed so far. [session's thread] */
    void publish (std::shared_ptr<const FollowingStatus>, std::shared_ptr<const KnownDrift>);

private:
    mutable std::mutex mutex; ///< For all that follows.
    FollowingRound asked;
    std::shared_ptr<const FollowingStatus> statusNow = std::make_shared<const FollowingStatus>();
    std::shared_ptr<const KnownDrift> driftNow;
};
} // namespace antinode
