#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cmath>
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

/** The newest frames of a tap, without gaps. [worker] */
class RecentFrames
{
public:
    /** @param seconds  that are kept at least */
    RecentFrames (const SensorTap& tap, double seconds)
        : kept (static_cast<Eigen::Index> (std::ceil (seconds * tap.sampleRate()))),
          frames (tap.ceramics() + 1, 2 * kept + static_cast<Eigen::Index> (SensorTap::capacity * tap.sampleRate()))
    {
    }

    /** Takes what waits. @return  how many frames; after a gap, all from before are forgotten */
    Eigen::Index take (SensorTap& tap)
    {
        if (end > 2 * kept)
        {
            frames.leftCols (kept) = frames.middleCols (end - kept, kept).eval();
            end = kept;
        }

        const auto count = tap.read (frames, end);
        end = count < 0 ? 0 : end + count;
        return std::max<Eigen::Index> (0, count);
    }

    void forget() { end = 0; }
    bool isFull() const { return end >= kept; }

    /** The voltages, N_b x N, and the sensor, 1 x N; only where it is full. */
    auto voltages() const { return frames.block (0, end - kept, frames.rows() - 1, kept); }
    auto sensor() const { return frames.block (frames.rows() - 1, end - kept, 1, kept); }

private:
    Eigen::Index kept, end = 0;
    Eigen::MatrixXd frames;
};
} // namespace antinode
