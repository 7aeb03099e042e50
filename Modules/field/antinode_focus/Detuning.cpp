#include "Detuning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace antinode
{
namespace
{
/** Standard normal numbers by Box and Muller: std::normal_distribution differs between libraries. */
class NormalNumbers
{
public:
    explicit NormalNumbers (std::uint64_t seed) : engine (seed) {}

    double next()
    {
        const auto radius = std::sqrt (-2 * std::log (uniform()));
        return radius * std::cos (2 * std::numbers::pi * uniform());
    }

private:
    double uniform() { return (static_cast<double> (engine() >> 11) + 0.5) * 0x1p-53; }

    std::mt19937_64 engine;
};
} // namespace

ModalModel detuned (const ModalModel& model, const DetuningSpread& spread, std::uint64_t seed)
{
    NormalNumbers numbers (seed);
    auto result = model;
    const auto factor = [&] (double deviation) { return std::max (0.01, 1 + deviation * numbers.next()); };

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        result.angularFrequencies[k] *= factor (spread.frequency);
        result.dampingRatios[k] = std::min (result.dampingRatios[k] * factor (spread.damping), 0.999);

        for (Eigen::Index i = 0; i < model.actuators(); ++i)
            result.participation (k, i) *= factor (spread.participation);
    }

    // Drawn last, so that devices without drift are those that they were before there was any.
    result.angularFrequencies *= factor (spread.drift);
    return result;
}

// SplitMix64, Steele et al. 2014.
std::uint64_t drawSeed (std::uint64_t seed, std::uint64_t number)
{
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15, first = 0xbf58476d1ce4e5b9, second = 0x94d049bb133111eb;
    const auto mix = [] (std::uint64_t z)
    {
        z = (z ^ (z >> 30)) * first;
        z = (z ^ (z >> 27)) * second;
        return z ^ (z >> 31);
    };
    return mix (mix (seed + odd) + odd * number);
}

ModalModel withoutShapes (const ModalModel& model)
{
    ModalModel modes;
    modes.angularFrequencies = model.angularFrequencies;
    modes.dampingRatios = model.dampingRatios;
    modes.participation = model.participation;
    return modes;
}
} // namespace antinode
