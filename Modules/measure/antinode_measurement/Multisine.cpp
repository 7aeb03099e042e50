#include "Multisine.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/RandomNumbers.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
constexpr int clippings = 40;
constexpr double firstClip = 0.7, lastClip = 0.9; // of the peak
constexpr Eigen::Index oversampling = 2;          // Clipped samples alone leave the peaks between them.

Eigen::VectorXcd schroederSpectrum (const std::vector<Eigen::Index>& lines, Eigen::Index length)
{
    Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero (length / 2 + 1);
    const auto count = static_cast<double> (lines.size());
    double n = 0;

    for (const auto line : lines)
    {
        n += 1;
        spectrum[line] = std::polar (1.0, -std::numbers::pi * std::fmod (n * (n - 1) / count, 2.0));
    }

    return spectrum;
}

/** The waveform between the samples, too: oversampled. */
Eigen::VectorXd oversampledWaveform (const Eigen::VectorXcd& spectrum, Eigen::Index length)
{
    Eigen::VectorXcd wide = Eigen::VectorXcd::Zero (oversampling * length / 2 + 1);
    wide.head (spectrum.size()) = spectrum;
    return inverseFourier (wide, oversampling * length);
}

/** The same lines with equal amplitudes and the phases of a waveform. */
Eigen::VectorXcd withPhasesFrom (const Eigen::VectorXd& waveform, const std::vector<Eigen::Index>& lines,
                                 Eigen::Index count)
{
    const auto phases = forwardFourier (waveform);
    Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero (count);

    for (const auto line : lines)
        spectrum[line] = std::polar (1.0, std::arg (phases[line]));

    return spectrum;
}
} // namespace

std::vector<Eigen::Index> everyLine (Eigen::Index lowest, Eigen::Index highest)
{
    std::vector<Eigen::Index> lines;

    for (auto line = lowest; line <= highest; ++line)
        lines.push_back (line);

    return lines;
}

std::vector<Eigen::Index> oddRandomLines (Eigen::Index lowest, Eigen::Index highest, std::uint64_t seed)
{
    constexpr Eigen::Index group = 4;
    RandomNumbers random (seed);
    std::vector<Eigen::Index> lines;
    Eigen::Index place = 0, leftOut = 0;

    for (auto line = lowest | 1; line <= highest; line += 2, place = (place + 1) % group)
    {
        if (place == 0)
            leftOut = static_cast<Eigen::Index> (static_cast<double> (group) * random.uniform());

        if (place != leftOut)
            lines.push_back (line);
    }

    if (lines.empty())
        throw InputError ("excitation", "has no odd line in its band; choose a wider band or a finer resolution");

    return lines;
}

Eigen::VectorXd multisinePeriod (const std::vector<Eigen::Index>& lines, Eigen::Index length)
{
    auto spectrum = schroederSpectrum (lines, length);
    auto best = spectrum;
    auto waveform = oversampledWaveform (spectrum, length);
    auto lowest = waveform.cwiseAbs().maxCoeff();

    for (int i = 0; i < clippings; ++i)
    {
        const auto share = firstClip + (lastClip - firstClip) * i / (clippings - 1);
        const auto clip = share * waveform.cwiseAbs().maxCoeff();
        spectrum = withPhasesFrom (waveform.cwiseMax (-clip).cwiseMin (clip), lines, spectrum.size());
        waveform = oversampledWaveform (spectrum, length);

        // All have the same effective value, so the lowest peak has the lowest crest factor.
        if (const auto peak = waveform.cwiseAbs().maxCoeff(); peak < lowest)
        {
            lowest = peak;
            best = spectrum;
        }
    }

    const auto signal = inverseFourier (best, length);
    return signal / signal.cwiseAbs().maxCoeff();
}
} // namespace antinode
