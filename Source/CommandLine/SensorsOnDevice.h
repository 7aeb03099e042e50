#pragma once

#include "SensorsFiles.h"

#include <antinode_base/ShowProgress.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_structure/DeviceDescription.h>

#include <vector>

namespace antinode
{
/** How sensors are chosen. */
struct SensorRequest
{
    int count = 2;
    int candidates = 1000;                                   ///< About so many places, in square cells.
    double rate = 96000, duration = 250, signalToNoise = 40; ///< Hz, ms, dB at an average place.
    double frequency = 0.5, damping = 10, participation = 5; ///< Standard deviations of the device's modes, %.
    std::vector<int> idleCeramics; ///< That are not driven and may be among the sensors, counted from 1.
    bool usesCache = true;
};

/** Sensors, and the device that they listen to. */
struct SensorsOnDevice
{
    ModalModel model;
    SensorPlaces places;
};

/** Where sensors tell most of the modes that a focus plays on a device.
    @param progress  may be empty
    @throws InputError, LimitError  as designFocus, or where there are fewer candidates than sensors
    [worker] Docs/Theory.md, section 7.8. */
SensorsOnDevice sensorsOnDevice (const DeviceDescription&, const FocusDescription&, const SensorRequest&,
                                 const ShowProgress& progress);
} // namespace antinode
