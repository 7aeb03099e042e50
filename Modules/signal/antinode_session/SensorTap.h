#pragma once

#include <Eigen/Core>

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

namespace antinode
{
/** What ceramics are given and what a sensor hears meanwhile, on its way from the audio thread to whoever tracks the
   device. One thread writes, one reads; neither waits for the other. */
class SensorTap
{
public:
    /** How much waits at most, s. */
    static constexpr double capacity = 2;

    /** @param ceramics  N_b [worker] */
    SensorTap (Eigen::Index ceramics, double sampleRate);

    Eigen::Index ceramics() const { return frameSize - 1; }
    double sampleRate() const { return rate; }

    /** Takes some frames, all of them or none: where there is no room for all, a gap is noted.
        @param volts   N_b channels
        @param sensor  share of full scale; none: it is not plugged in, which is silence
        [audio thread] */
    template <typename Sample>
    void write (const double* const* volts, const Sample* sensor, int count);

    /** The frames since the last call, the oldest first.
        @param frames  (N_b + 1) x N: what was read before, of which the last columns are replaced: the voltages, V, and
       the sensor
        @param begin   column of the first one that is read
        @return        how many were read; -1 where frames are missing before those that come next: what waited is
       thrown away [worker] */
    Eigen::Index read (Eigen::MatrixXd& frames, Eigen::Index begin);

private:
    double rate;
    Eigen::Index frameSize;
    std::size_t length; ///< Frames, a power of two: the counters may wrap.
    std::vector<float> frames;
    std::atomic<std::size_t> written { 0 }, taken { 0 };
    std::atomic<bool> hasGap { false };
};

/** What a path tells whoever tracks its device. */
struct Listening
{
    std::shared_ptr<SensorTap> tap; ///< None: nobody listens.
    unsigned long long idle = 0;    ///< Bit i: ceramic i + 1 listens, and is never driven.
};
} // namespace antinode
