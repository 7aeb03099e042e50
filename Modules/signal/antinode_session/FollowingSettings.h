#pragma once

#include <antinode_base/WordList.h>

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
} // namespace antinode
