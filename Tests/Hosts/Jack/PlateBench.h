#pragma once

#include <antinode_engine/RealtimePlate.h>
#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <string>
#include <vector>

namespace antinode::test
{
/** What lies on a bench. */
struct BenchSetup
{
    std::string device, focus; ///< Embedded names or files.
    Eigen::Index idle = 0;     ///< The ceramic whose current is heard, counted from 0.
    double drift = 0;          ///< Of all frequencies, relative, from the start on.
    double jump = 0;           ///< The same, on top of it, from a time on.
    double jumpTime = 0;       ///< s, from the first voltage.
    double latency = 0;        ///< s, of the sensor.
    double seconds = 0;        ///< How long it is played.
};

/** A device as it is for a while, and the motion that a focus would have that was designed for it. */
struct BenchDevice
{
    ModalModel model;
    Eigen::VectorXd wanted;                   ///< N_m: modal velocities at the focus, m/s kg^1/2.
    std::int64_t focusSample = 0;             ///< After the trigger.
    double heardPeak = 0, heardDeviation = 0; ///< Of the idle ceramic's current, A; the latter: RMS.
};

/** One focus that was played. */
struct PlayedFocus
{
    double time = 0;  ///< s, from the first voltage.
    double error = 0; ///< Of the modal velocities, relative, at the moment at which it is least.
};

/** A device in time, in a state that its model does not know: half as many modes again as programs play, frequencies
   off by a drift and each by .1 %, damping by 5 %, participations by 3 %; an idle ceramic listens, with noise 40 dB
   below, 1 % of cubic distortion, late. */
class PlateBench
{
public:
    /** Solves the device and designs the focus. [worker] */
    PlateBench (const BenchSetup&, double sampleRate);

    std::size_t ceramics() const { return voltages.size(); }

    /** Takes what the ceramics are given and gives what is heard; it begins with the first voltage.
        @param played  for each ceramic, 1.0 is its full scale
        @param sensor  count samples
        @return        whether it goes on [audio thread] allocates nothing, locks nothing */
    bool process (const float* const* played, float* sensor, std::size_t count);

    /** All that was played, once it is over. Each focus is looked at alone, from rest. [worker] */
    std::vector<PlayedFocus> foci() const;

    /** The largest sample of all, 1.0 is full scale. [worker] */
    double peak() const;

private:
    void move (std::size_t begin, std::size_t end);
    void hear (std::size_t begin, std::size_t end);
    std::vector<std::size_t> triggers() const;
    PlayedFocus evaluate (std::size_t trigger) const;

    BenchSetup setup;
    double rate;
    std::size_t jumpSample, delay, position = 0;
    BenchDevice before, after;
    std::vector<std::vector<double>> voltages; ///< By ceramic, as all that follows from the first voltage on.
    std::vector<double> heard, noise;
    std::vector<const double*> sources;
    RealtimePlate plate, jumped;
};
} // namespace antinode::test
