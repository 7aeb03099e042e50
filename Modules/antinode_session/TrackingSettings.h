#pragma once

#include <antinode_base/WordList.h>

namespace antinode
{
/** What listens to the device that plays, so that its drift is tracked. */
enum class TrackingSensor
{
    none,           ///< Nothing: the drift is not tracked.
    velocity,       ///< A sensor at a place: a laser vibrometer, or an accelerometer that is integrated.
    displacement,   ///< The same for displacements.
    ceramicCurrent, ///< The current of an idle ceramic.
    ceramicCharge   ///< Its charge, or its voltage without load.
};

/** What files and options call them. */
inline constexpr WordList<TrackingSensor, 4> trackingSensorWords {
    { { "velocity", TrackingSensor::velocity },
      { "displacement", TrackingSensor::displacement },
      { "ceramic_current", TrackingSensor::ceramicCurrent },
      { "ceramic_charge", TrackingSensor::ceramicCharge } }
};

/** How the drift of the device is tracked while it plays. */
struct TrackingSettings
{
    TrackingSensor sensor = TrackingSensor::none;
    double xMillimetres = 0, yMillimetres = 0; ///< Of a sensor at a place.
    int ceramic = 0;                           ///< That is idle, counted from 0; it is not driven.
    bool isFrozen = false;                     ///< Foci stay as they are, nothing is learnt.

    bool isOn() const { return sensor != TrackingSensor::none; }
    bool isCeramic() const
    {
        return sensor == TrackingSensor::ceramicCurrent || sensor == TrackingSensor::ceramicCharge;
    }

    bool operator== (const TrackingSettings&) const = default;
};
} // namespace antinode
