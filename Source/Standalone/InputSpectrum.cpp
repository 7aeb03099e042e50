#include "InputSpectrum.h"

#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double fadeTime = 0.4; // s: as long as peaks of single bursts are seen
constexpr double leastPower = 1e-20;

/** Hann's window, so scaled that a sine on a line has its amplitude there. */
Eigen::VectorXd scaledHann (Eigen::Index samples)
{
    return Eigen::VectorXd::NullaryExpr (samples,
                                         [samples] (Eigen::Index n)
                                         {
                                             const auto phase = 2 * std::numbers::pi * static_cast<double> (n)
                                                                / static_cast<double> (samples);
                                             return 2 * (1 - std::cos (phase)) / static_cast<double> (samples);
                                         });
}
} // namespace

void InputSpectrum::prepare (double sampleRate)
{
    rate = sampleRate;
    waiting.clear();
    powers.resize (0);
}

void InputSpectrum::add (const std::vector<float>& samples)
{
    static const auto window = scaledHann (block);
    waiting.insert (waiting.end(), samples.begin(), samples.end());

    while (static_cast<Eigen::Index> (waiting.size()) >= block)
    {
        const Eigen::VectorXd signal = Eigen::VectorXd::NullaryExpr (
            block, [this] (Eigen::Index n) { return waiting[static_cast<std::size_t> (n)] * window[n]; });
        const Eigen::VectorXd next = forwardFourier (signal).cwiseAbs2();
        const auto kept = std::exp (-static_cast<double> (block) / 2 / rate / fadeTime);
        powers = powers.size() == next.size() ? Eigen::VectorXd (kept * powers + (1 - kept) * next) : next;
        waiting.erase (waiting.begin(), waiting.begin() + block / 2);
    }
}

Eigen::VectorXd InputSpectrum::levels() const
{
    return 10 * powers.array().max (leastPower).log10();
}

double InputSpectrum::lineFrequency (Eigen::Index line) const
{
    return static_cast<double> (line) * rate / static_cast<double> (block);
}
} // namespace antinode
