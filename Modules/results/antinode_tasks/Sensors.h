#pragma once

#include "Field.h"
#include "SensorsFiles.h"

#include <antinode_base/ShowProgress.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_structure/DeviceDescription.h>

#include <vector>

namespace antinode
{
inline constexpr TaskText sensorsText {
    "sensors", "Chooses the places where sensors give most information on the modes of a focus",
    "Docs/Theory.md, section 7.8"
};

/** How sensors are chosen. */
struct SensorRequest
{
    FocusDescription focus;
    DeviceDescription device;
    int count = 2;
    int candidates = 1000;                                          ///< About so many places, in square cells.
    double sampleRate = 96000, duration = 0.25, signalToNoise = 40; ///< Hz, s, dB at an average place.
    double frequency = 0.005, damping = 0.1, participation = 0.05;  ///< Standard deviations of the device's modes.
    std::vector<int> idleCeramics; ///< That are not driven and may be among the sensors, counted from 1.
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (SensorRequest&);

/** Sensors, and the device that they listen to. */
struct SensorsOnDevice
{
    ModalModel model;
    SensorPlaces places;
};

/** Where sensors tell most of the modes that a focus plays on a device.
    @param progress  may be empty
    @throws InputError, LimitError  as designFocus, or where there are fewer candidates than sensors
    [worker] */
SensorsOnDevice sensors (const SensorRequest&, const ShowProgress& progress);
} // namespace antinode
