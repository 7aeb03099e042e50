#include "SensorTap.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace antinode
{
SensorTap::SensorTap (Eigen::Index ceramicsOfDevice, double sampleRateOfPath)
    : rate (sampleRateOfPath), frameSize (ceramicsOfDevice + 1),
      length (std::bit_ceil (static_cast<std::size_t> (std::ceil (capacity * rate)))),
      frames (length * static_cast<std::size_t> (frameSize))
{
}

template <typename Sample>
void SensorTap::write (const double* const* volts, const Sample* sensor, int count)
{
    const auto begin = written.load (std::memory_order_relaxed);
    const auto size = static_cast<std::size_t> (frameSize);

    if (begin - taken.load (std::memory_order_acquire) + static_cast<std::size_t> (count) > length)
    {
        hasGap.store (true, std::memory_order_release);
        return;
    }

    for (std::size_t n = 0; n < static_cast<std::size_t> (count); ++n)
    {
        auto* const frame = frames.data() + ((begin + n) & (length - 1)) * size;

        for (std::size_t i = 0; i + 1 < size; ++i)
            frame[i] = static_cast<float> (volts[i][n]);

        frame[size - 1] = sensor != nullptr ? static_cast<float> (sensor[n]) : 0.0F;
    }

    written.store (begin + static_cast<std::size_t> (count), std::memory_order_release);
}

Eigen::Index SensorTap::read (Eigen::MatrixXd& into, Eigen::Index begin)
{
    const auto first = taken.load (std::memory_order_relaxed);
    const auto end = written.load (std::memory_order_acquire);

    // Asked after the end is known, so that no gap lies before it; what is thrown away reaches beyond each gap so far.
    if (hasGap.exchange (false, std::memory_order_acquire))
    {
        taken.store (written.load (std::memory_order_acquire), std::memory_order_release);
        return -1;
    }

    const auto count = std::min (static_cast<Eigen::Index> (end - first), into.cols() - begin);

    for (Eigen::Index n = 0; n < count; ++n)
    {
        const auto frame = (first + static_cast<std::size_t> (n)) & (length - 1);
        into.col (begin + n) =
            Eigen::Map<const Eigen::VectorXf> (frames.data() + frame * static_cast<std::size_t> (frameSize), frameSize)
                .cast<double>();
    }

    taken.store (first + static_cast<std::size_t> (count), std::memory_order_release);
    return count;
}

template void SensorTap::write (const double* const*, const float*, int);
template void SensorTap::write (const double* const*, const double*, int);
} // namespace antinode
