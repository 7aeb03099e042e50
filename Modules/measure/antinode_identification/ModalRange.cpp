#include "ModalRange.h"

#include "PreparedResponses.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
/** What each line holds, summed over all columns, each of which counts alike: velocities squared. */
struct LinePowers
{
    Eigen::VectorXd frequencies; ///< Hz
    Eigen::VectorXd power;       ///< Means over three lines, further up over 4 % of the frequency.
    Eigen::VectorXd noise;       ///< From second differences, means over nine lines.
    Eigen::VectorXd wide;        ///< As noise, of the power.
};

Eigen::VectorXd movingMean (const Eigen::VectorXd& values, Eigen::Index reach, double share = 0)
{
    Eigen::VectorXd result (values.size());

    for (Eigen::Index f = 0; f < values.size(); ++f)
    {
        const auto around = std::max (reach, static_cast<Eigen::Index> (share * static_cast<double> (f)));
        const auto first = std::max<Eigen::Index> (0, f - around);
        result[f] = values.segment (first, std::min (values.size() - 1, f + around) - first + 1).mean();
    }

    return result;
}

double medianPower (const Eigen::VectorXd& power)
{
    return median ({ power.begin(), power.end() });
}

LinePowers linePowers (const PreparedResponses& data)
{
    const auto lines = data.lines();
    const auto values = dataBlock (data, 0, Eigen::VectorXcd::Ones (lines));
    Eigen::VectorXd power = Eigen::VectorXd::Zero (lines), noise = power;

    for (Eigen::Index c = 0; c < data.columns(); ++c)
    {
        checkWatch();
        const Eigen::VectorXcd column = values.real.col (c) + std::complex<double> (0, 1) * values.imaginary.col (c);
        const Eigen::VectorXd powers = column.cwiseAbs2();
        const auto typical = data.columnWeights[c] > 0 ? medianPower (powers) : 0;

        if (typical <= 0)
            continue;

        power += powers / typical;
        // White noise has six times its variance in these differences; resonances that lines resolve have little.
        noise.segment (1, lines - 2) +=
            (column.head (lines - 2) - 2 * column.segment (1, lines - 2) + column.tail (lines - 2)).cwiseAbs2()
            / (6 * typical);
    }

    noise[0] = noise[1];
    noise[lines - 1] = noise[lines - 2];
    return { data.omega / (2 * std::numbers::pi), movingMean (power, 1, 0.02), movingMean (noise, 4),
             movingMean (power, 4) };
}

double peakOf (const Eigen::VectorXd& power, Eigen::Index first, Eigen::Index last)
{
    return power.segment (first, last - first + 1).maxCoeff();
}

/** Valleys in the lower part of the range from which the power rises to four times and more on both sides. */
std::vector<Eigen::Index> valleys (const LinePowers& lines)
{
    constexpr double lowerPart = 0.35, rise = 4;
    const auto highest = lowerPart * lines.frequencies[lines.frequencies.size() - 1];
    std::vector<Eigen::Index> result;
    Eigen::Index lowest = 0;
    auto peak = lines.power[0];

    for (Eigen::Index f = 1; f < lines.power.size() && lines.frequencies[lowest] < highest; ++f)
    {
        if (lines.power[f] < lines.power[lowest])
            lowest = f;
        else if (lines.power[f] > rise * lines.power[lowest])
        {
            // Now up to the next peak, and down from it.
            if (peak > rise * lines.power[lowest])
                result.push_back (lowest);

            while (f + 1 < lines.power.size() && lines.power[f + 1] * rise > peakOf (lines.power, lowest, f + 1))
                ++f;

            peak = peakOf (lines.power, lowest, f);
            lowest = f;
        }
    }

    return result;
}

/** The last line before nothing but noise follows. */
Eigen::Index lastAboveNoise (const LinePowers& lines)
{
    constexpr double enough = 2.5;
    auto last = lines.power.size() - 1;

    while (last > 0 && lines.wide[last] < enough * lines.noise[last])
        --last;

    return last;
}
/** Lines of peaks that stand out of both valleys beside them, and of noise. */
std::vector<Eigen::Index> prominentPeaks (const LinePowers& lines)
{
    constexpr double prominence = 10;
    std::vector<Eigen::Index> peaks;
    Eigen::Index lowest = 0, highest = 0;
    auto isRising = false;

    for (Eigen::Index f = 1; f < lines.power.size(); ++f)
    {
        if (lines.power[f] > lines.power[highest])
            highest = f;

        if (lines.power[f] < lines.power[lowest])
            lowest = f;

        if (! isRising && lines.power[f] > prominence * lines.power[lowest])
        {
            isRising = true;
            highest = f;
        }
        else if (isRising && lines.power[f] * prominence < lines.power[highest])
        {
            if (lines.power[highest] > prominence * lines.noise[highest])
                peaks.push_back (highest);

            isRising = false;
            lowest = f;
        }
    }

    return peaks;
}
} // namespace

std::vector<double> resonancesOutside (const FrequencyBand& band, const FrequencyResponses& responses,
                                       const IdentificationOptions& options)
{
    const auto lines = linePowers (prepare (responses, options.minimumFrequency, options.maximumFrequency));
    std::vector<double> frequencies;

    for (const auto peak : prominentPeaks (lines))
        if (const auto frequency = lines.frequencies[peak]; frequency < band.minimum || frequency > band.maximum)
            frequencies.push_back (frequency);

    return frequencies;
}

std::vector<FrequencyBand> candidateRanges (const FrequencyResponses& responses, const IdentificationOptions& options)
{
    constexpr Eigen::Index fewest = 64;
    constexpr std::size_t most = 6;
    const auto data = prepare (responses, options.minimumFrequency, options.maximumFrequency);

    if (data.lines() < 2 * fewest)
        return {};

    const auto lines = linePowers (data);
    const auto lastLine = lastAboveNoise (lines);
    const auto end =
        lastLine + 1 < data.lines() && lastLine > fewest ? lines.frequencies[lastLine] : options.maximumFrequency;
    std::vector<FrequencyBand> result;
    const auto add = [&] (Eigen::Index first)
    {
        if (lastLine - first >= fewest && (result.empty() || lines.frequencies[first] > result.back().minimum))
            result.push_back ({ lines.frequencies[first], end });
    };

    if (end < options.maximumFrequency)
        add (0);

    for (const auto valley : valleys (lines))
        if (result.size() < most)
            add (valley);

    return result;
}
} // namespace antinode
