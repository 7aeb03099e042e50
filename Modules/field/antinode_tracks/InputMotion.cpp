#include "InputMotion.h"

#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr double feltWindow = 0.1; // s, of the RMS that is felt

/** A filter of linear phase with a magnitude by frequency, as long as it may be, under a window of Hann's. */
Eigen::VectorXf symmetricTaps (double rate, Eigen::Index longest, const std::function<double (double)>& magnitude)
{
    const auto reach = (longest - 1) / 2;
    const auto length = quickLength (16 * static_cast<double> (longest));
    Eigen::VectorXcd lines (length / 2 + 1);

    for (Eigen::Index k = 0; k < lines.size(); ++k)
        lines[k] = magnitude (rate * static_cast<double> (k) / static_cast<double> (length));

    const auto response = inverseFourier (lines, length);
    Eigen::VectorXf taps (2 * reach + 1);

    for (Eigen::Index n = -reach; n <= reach; ++n)
    {
        const auto window =
            0.5 + 0.5 * std::cos (std::numbers::pi * static_cast<double> (n) / static_cast<double> (reach + 1));
        taps[n + reach] = static_cast<float> (window * response[(n + length) % length]);
    }

    return taps;
}

bool isWithin (TrackBand band, double frequency)
{
    return frequency >= band.lower && frequency <= band.upper;
}
} // namespace

InputMotion::InputMotion (double rate, TrackBand band, const SkinThreshold& threshold, Eigen::Index past,
                          Eigen::Index inputsToTake)
    : inBand (symmetricTaps (rate, past, [&] (double frequency) { return isWithin (band, frequency) ? 1.0 : 0.0; })),
      weighted (symmetricTaps (rate, past,
                               [&] (double frequency)
                               { return isWithin (band, frequency) ? 1 / thresholdAt (threshold, frequency) : 0.0; })),
      inputs (static_cast<std::size_t> (inputsToTake))
{
    for (auto& input : inputs)
        input.squares.resize (static_cast<std::size_t> (std::max (1.0, std::round (feltWindow * rate))));
}

void InputMotion::take (std::size_t index, const Eigen::Ref<const Eigen::RowVectorXf>& samples)
{
    auto& input = inputs[index];
    const auto past = samples.tail (inBand.size());
    const auto displacement = past.dot (inBand), amount = past.dot (weighted);
    const auto square = static_cast<double> (amount) * static_cast<double> (amount);
    input.energy = std::max (0.0, input.energy + square - std::exchange (input.squares[input.oldest], square));
    input.oldest = (input.oldest + 1) % input.squares.size();
    const auto mean = input.energy / static_cast<double> (input.squares.size());
    input.displacement = std::max (input.displacement, std::abs (displacement));

    if (input.recentCount < mostRecent)
        input.recent[input.recentCount++] = displacement;

    input.felt = std::max ({ input.felt, std::abs (amount), static_cast<float> (std::sqrt (2 * mean)) });
}

float InputMotion::takeDisplacement (std::size_t input)
{
    return std::exchange (inputs[input].displacement, 0.0F);
}

float InputMotion::takeFelt (std::size_t input)
{
    return std::exchange (inputs[input].felt, 0.0F);
}

std::span<const float> InputMotion::takeRecent (std::size_t index)
{
    auto& input = inputs[index];
    return { input.recent.data(), std::exchange (input.recentCount, 0) };
}

void InputMotion::reset()
{
    for (auto& input : inputs)
    {
        input.displacement = input.felt = 0;
        input.energy = 0;
        input.recentCount = 0;
        std::fill (input.squares.begin(), input.squares.end(), 0.0);
    }
}
} // namespace antinode
