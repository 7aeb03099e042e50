#pragma once

#include "FollowDrift.h"

#include <vector>

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

/** The delays, scales and common drifts by which the lowest modes may explain a signal, the best first: of every drift
   the model's answer is compared with the signal at all delays at once, by their correlation. Half a period later, with
   another drift, a mode looks almost the same: what explains nearly as much at another delay is likely, too.
    @param nominal    the device; more modes than modesForSearch() are left out
    @param shapes     of one sensor, of all modes
    @param recording  with the signal of this sensor alone; its delay is not looked at
    @param longest    delay that is searched, s
    @return  at most 4; none where nothing was played or heard
    @throws InputError  as atLowerRate; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 7.10. */
std::vector<AcquiredSensor> likelySensors (const ModalModel& nominal, const Eigen::RowVectorXd& shapes,
                                           const PlayedRecording&, const DriftSettings&, double longest);
} // namespace antinode
