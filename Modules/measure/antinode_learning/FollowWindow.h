#pragma once

#include "FollowDrift.h"

#include <string>
#include <vector>

namespace antinode
{
/** What a sensor's samples stand for. */
enum class SensorQuantity
{
    rate,  ///< A velocity, or the current of an idle ceramic.
    amount ///< The charge of an idle ceramic or its voltage: signals are differentiated.
};

/** A device and the sensor that it is followed by. */
struct DriftSensor
{
    Eigen::RowVectorXd shapes; ///< N_m, as Sensor; up to a factor, which is found.
    SensorQuantity quantity = SensorQuantity::rate;
    bool hearsVoltages = false; ///< An idle ceramic: what it hears of its neighbours without any motion is removed.
};

/** All that is known of a followed device from one window to the next. */
struct SensedDrift
{
    DriftEstimate estimate;
    double delay = 0;    ///< s, from voltages to signal.
    double scale = 0;    ///< Of the sensor, as AcquiredSensor; 0: not known yet.
    double quietest = 0; ///< RMS of the signal in the quietest window so far; 0: none was quiet.
    int lost = 0;        ///< Windows in a row that were not explained.
};

/** Nothing was heard yet. [any] */
SensedDrift startOfFollowing (const DriftLayout&, const DriftSpread&);

/** What one more window of a followed device says. */
struct FollowedWindow
{
    SensedDrift drift;
    FollowedDrift followed; ///< Its estimate is that of `drift`.
};

/** The lowest modes of a device that are followed: a window costs with their square. The others follow what all
   frequencies share.
    @throws InputError  where the rate is below that of the lowest mode; for complex modes
    [any] */
ModalModel followedModes (const ModalModel&, double sampleRate);

/** What is compared at once, s. */
inline constexpr double followedWindow = 0.5;

/** How much of what was played a window takes before its sensor is known, s: with what the modes remember, and the
    longest delay. [any] */
double followedLength (const DriftSettings&);

/** For how long before a window the modes remember, s: until the slowest has decayed to 3 %, .1 to .5 s. [any] */
double followingMemory (const ModalModel&);

/** Follows one window of what was played. Where nothing is known of the sensor yet, or windows were lost for a while,
    its delay, scale and sign are searched for first. Then the window is followed as followDrift does, with the delay as
    a parameter. Signals that are broken, or that the model does not explain, change nothing, and the reason is said.
    @param nominal    followedModes()
    @param before     at the time of the window: afterTime()
    @param recording  of the voltages that were played and the signal, followedLength() or more; full scale is 1; its
                      noise and delay are not looked at
    @throws InputError  as followDrift; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 7.10. */
FollowedWindow followWindow (const ModalModel& nominal, const DriftSensor&, const SensedDrift& before,
                             PlayedRecording recording, const DriftSettings&);

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
