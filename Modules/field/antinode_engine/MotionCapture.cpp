#include "MotionCapture.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double smallest = 1e-30;         // of a sum of squares: below, a surface is still
constexpr double minimumPowerShare = 0.25; // of the largest sum of squares of late: below, a window is not worth a look
} // namespace

MotionCapture::MotionCapture (int modesToKeep, int framesOfWindow, double memory)
    : modes (static_cast<std::uint64_t> (modesToKeep)), frames (static_cast<std::uint64_t> (framesOfWindow)),
      ring (windows * modes * frames), keep (std::exp (-1 / memory))
{
}

void MotionCapture::write (std::span<const double> velocities)
{
    const auto frame = written.load (std::memory_order_relaxed);
    auto* const to = ring.data() + frame % (windows * frames) * modes;
    double energy = 0;

    for (std::uint64_t k = 0; k < modes; ++k)
    {
        // Whoever reads this value reads at least the present count afterwards: take() sees what was overwritten.
        to[k].store (static_cast<float> (velocities[k]), std::memory_order_release);
        energy += velocities[k] * velocities[k];
    }

    written.store (frame + 1, std::memory_order_release);
    findPeak (energy);
}

void MotionCapture::findPeak (double energy)
{
    const auto now = written.load (std::memory_order_relaxed);
    recent = std::max (recent * keep, energy);

    // One that nobody takes is replaced before it is overwritten.
    if (const auto found = ready.load (std::memory_order_relaxed); found != 0 && now - found < windows / 2 * frames)
    {
        peak = 0;
        return;
    }

    if (energy > peak)
    {
        peak = energy;
        peakAt = now;
    }

    if (peak > smallest && now - peakAt >= frames / 2)
    {
        if (peak >= minimumPowerShare * recent && now >= frames)
            ready.store (now, std::memory_order_release);

        peak = 0;
    }
}

bool MotionCapture::take (Eigen::MatrixXd& window)
{
    auto end = ready.load (std::memory_order_acquire);

    if (end == 0)
        return false;

    const auto first = end - frames;
    Eigen::MatrixXd copied (static_cast<Eigen::Index> (modes), static_cast<Eigen::Index> (frames));

    for (std::uint64_t f = 0; f < frames; ++f)
        for (std::uint64_t k = 0; k < modes; ++k)
            copied (static_cast<Eigen::Index> (k), static_cast<Eigen::Index> (f)) = static_cast<double> (
                ring[(first + f) % (windows * frames) * modes + k].load (std::memory_order_acquire));

    const auto isWhole = written.load (std::memory_order_relaxed) < first + windows * frames;
    ready.compare_exchange_strong (end, 0, std::memory_order_relaxed);

    if (isWhole)
        window = std::move (copied);

    return isWhole;
}
} // namespace antinode
