#pragma once

#include <array>

namespace antinode
{
/** The input of the audio device that each finger of Antinode Touch feels, counted from 0. Several may feel one. Where
    foci are played, the first finger stands for the sensor. */
struct FingerInputs
{
    static constexpr int none = -1, firstOpen = -2, fingers = 8;

    std::array<int, fingers> inputs { 0, 1, 2, 3, 4, 5, 6, 7 }; ///< Of each finger, or one of the two above.
    int sensor = none;                                          ///< Of what tracks the device.

    bool operator== (const FingerInputs&) const = default;
};

/** The sensor hears the first input that is open, fingers feel nothing. [any] */
inline FingerInputs sensorAlone()
{
    FingerInputs sensor;
    sensor.inputs.fill (FingerInputs::none);
    sensor.inputs.front() = FingerInputs::firstOpen;
    return sensor;
}
} // namespace antinode
