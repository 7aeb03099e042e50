#include "Sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double below = 0.8, above = 1.15, nearNyquist = 0.49;

/** Half a period of a cosine from 0 to 1. */
double fade (double place)
{
    return 0.5 - 0.5 * std::cos (std::numbers::pi * std::clamp (place, 0.0, 1.0));
}
} // namespace

Sweep makeSweep (double lowestFrequency, double highestFrequency, double duration, double sampleRate)
{
    Sweep sweep;
    sweep.startFrequency = below * lowestFrequency;
    sweep.endFrequency = std::min (above * highestFrequency, nearNyquist * sampleRate);
    const auto octaves = std::log (sweep.endFrequency / sweep.startFrequency);
    const auto turns = std::max (1.0, std::round (sweep.startFrequency * duration / octaves)); // f_1 L
    sweep.rise = turns / sweep.startFrequency;

    const auto fadeIn = sweep.rise * std::log (1 / below);
    const auto fadeOut = sweep.rise * std::log (sweep.endFrequency / highestFrequency);
    const auto length = sweep.rise * octaves;
    sweep.samples.resize (static_cast<Eigen::Index> (length * sampleRate) + 1);

    for (Eigen::Index n = 0; n < sweep.samples.size(); ++n)
    {
        const auto t = static_cast<double> (n) / sampleRate;
        const auto phase = turns * std::expm1 (t / sweep.rise); // in turns
        sweep.samples[n] = std::sin (2 * std::numbers::pi * std::remainder (phase, 1.0)) * fade (t / fadeIn)
                           * fade ((length - t) / fadeOut);
    }

    return sweep;
}
} // namespace antinode
