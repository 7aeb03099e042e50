#pragma once

#include "SensorTap.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
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
