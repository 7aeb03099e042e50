#pragma once

#include "FollowDrift.h"

namespace antinode
{
/** How a sensor hears a device: what is not known where it is plugged in. */
struct AcquiredSensor
{
    double delay = 0;     ///< s, from the voltages to the signal.
    double scale = 0;     ///< Signal per what the sensor's shapes give; negative where its wires are swapped.
    double jump = 0;      ///< Logarithm of the factor of all frequencies.
    double explained = 0; ///< Share of the signal, RMS, 0 to 1: the correlation at this delay.
};

/** The delay, scale and common drift by which the lowest modes explain most of a signal: of every drift the model's
    answer is compared with the signal at all delays at once, by their correlation.
    @param nominal    the device; more modes than modesForSearch() are left out
    @param shapes     of one sensor, of all modes
    @param recording  with the signal of this sensor alone; its delay is not looked at
    @param longest    delay that is searched, s
    @throws InputError  as atLowerRate; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 7.10. */
AcquiredSensor acquireSensor (const ModalModel& nominal, const Eigen::RowVectorXd& shapes, const PlayedRecording&,
                              const DriftSettings&, double longest);
} // namespace antinode
