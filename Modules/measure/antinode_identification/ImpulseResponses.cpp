#include "ImpulseResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
/** Lines as numbers of an even grid. */
struct LineGrid
{
    double spacing = 0;         ///< Hz
    Eigen::Index firstLine = 0; ///< Of the responses.
    std::vector<Eigen::Index> numbers;
};

std::optional<LineGrid> gridOf (const Eigen::VectorXd& frequencies, double minimum, double maximum)
{
    constexpr Eigen::Index fewest = 32;
    constexpr double uneven = 0.1, filled = 0.5;
    constexpr double longest = 1 << 22;
    const auto* const begin = frequencies.data();
    const auto* const end = begin + frequencies.size();
    const auto first = std::lower_bound (begin, end, minimum) - begin;
    const auto count = std::upper_bound (begin, end, maximum) - begin - first;

    if (count < fewest)
        return {};

    const Eigen::VectorXd lines = frequencies.segment (first, count);
    const Eigen::VectorXd steps = lines.tail (count - 1) - lines.head (count - 1);
    const auto range = lines[count - 1] - lines[0];
    LineGrid grid { range / std::round (range / median ({ steps.begin(), steps.end() })), first, {} };

    if (lines[count - 1] / grid.spacing > longest || static_cast<double> (count) < filled * range / grid.spacing)
        return {};

    const auto start = static_cast<Eigen::Index> (std::round (lines[0] / grid.spacing));

    for (const auto frequency : lines)
    {
        const auto number = (frequency - lines[0]) / grid.spacing;

        if (std::abs (number - std::round (number)) > uneven)
            return {};

        grid.numbers.push_back (start + static_cast<Eigen::Index> (std::round (number)));
    }

    return grid;
}

std::complex<double> orZero (std::complex<double> value)
{
    return std::isfinite (value.real()) && std::isfinite (value.imag()) ? value : 0;
}

/** A few columns, spread over all. Lines x columns, each of the same energy. */
Eigen::MatrixXcd sampledColumns (const FrequencyResponses& responses, Eigen::Index firstLine, Eigen::Index lines)
{
    constexpr Eigen::Index most = 16;
    const auto points = responses.points.rows();
    const auto columns = points * static_cast<Eigen::Index> (responses.references.size());
    const auto count = std::min (columns, most);
    Eigen::MatrixXcd result (lines, count);

    for (Eigen::Index n = 0; n < count; ++n)
    {
        const auto column = (2 * n + 1) * columns / (2 * count);
        const auto& values = responses.values[static_cast<std::size_t> (column / points)];
        result.col (n) = values.col (column % points).segment (firstLine, lines).unaryExpr (&orZero);
    }

    return result;
}

void makeEven (Eigen::MatrixXcd& columns)
{
    for (auto column : columns.colwise())
        column /= std::max (column.norm(), 1e-300);
}

/** How often to differentiate, so that the spectrum is as level as can be: by the slope of its logarithm. */
int levellingPower (const Eigen::MatrixXcd& columns, const std::vector<Eigen::Index>& numbers)
{
    double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0, count = 0;

    for (Eigen::Index f = 0; f < columns.rows(); ++f)
        if (const auto power = columns.row (f).squaredNorm(); power > 0 && numbers[static_cast<std::size_t> (f)] > 0)
        {
            const auto x = std::log (static_cast<double> (numbers[static_cast<std::size_t> (f)]));
            const auto y = std::log (power);
            sumX += x;
            sumY += y;
            sumXX += x * x;
            sumXY += x * y;
            ++count;
        }

    const auto spread = count * sumXX - sumX * sumX;
    return spread > 0 ? std::clamp (static_cast<int> (std::lround (-(count * sumXY - sumX * sumY) / spread / 2)), -2, 2)
                      : 0;
}

/** 1, falling to 0 over the upper quarter of the lines, and over the lower one where they begin far above 0 Hz. */
double taper (Eigen::Index number, Eigen::Index first, Eigen::Index last)
{
    constexpr double share = 0.25, low = 0.1;
    const auto width = share * static_cast<double> (last - first + 1);
    const auto fade = [width] (Eigen::Index distance)
    { return std::pow (std::sin (std::numbers::pi / 2 * std::min (1.0, static_cast<double> (distance) / width)), 2); };
    const auto isLow = static_cast<double> (first) < low * static_cast<double> (last);
    return fade (last + 1 - number) * (isLow ? 1 : fade (number - first + 1));
}

/** Of each line against the mean of its neighbours, over what independent lines have: medians. */
double roughnessOf (const Eigen::MatrixXcd& columns)
{
    std::vector<double> differences, powers;

    for (Eigen::Index f = 1; f + 1 < columns.rows(); ++f)
    {
        differences.push_back ((columns.row (f) - (columns.row (f - 1) + columns.row (f + 1)) / 2).squaredNorm() / 1.5);
        powers.push_back (columns.row (f).squaredNorm());
    }

    return median (differences) / std::max (median (powers), 1e-300);
}

Eigen::VectorXd cyclicMean (const Eigen::VectorXd& values, Eigen::Index width)
{
    const auto count = values.size();
    Eigen::VectorXd result (count);
    auto sum = values.head (width).sum();

    // The mean of a value and the following ones.
    for (Eigen::Index n = 0; n < count; ++n)
    {
        result[n] = sum / static_cast<double> (width);
        sum += values[(n + width) % count] - values[n];
    }

    return result.cwiseMax (0);
}
} // namespace

std::optional<ImpulseEnergy> impulseEnergy (const FrequencyResponses& responses, double minimumFrequency,
                                            double maximumFrequency)
{
    const auto grid = gridOf (responses.frequencies, minimumFrequency, maximumFrequency);

    if (! grid)
        return {};

    const auto& numbers = grid->numbers;
    auto columns = sampledColumns (responses, grid->firstLine, static_cast<Eigen::Index> (numbers.size()));
    makeEven (columns);
    const auto power = levellingPower (columns, numbers);
    const auto last = static_cast<double> (numbers.back());

    for (Eigen::Index f = 0; f < columns.rows(); ++f)
    {
        const auto number = static_cast<double> (std::max<Eigen::Index> (1, numbers[static_cast<std::size_t> (f)]));
        columns.row (f) *= std::pow (std::complex<double> (0, number / last), power);
    }

    ImpulseEnergy result;
    result.roughness = roughnessOf (columns);

    for (Eigen::Index f = 0; f < columns.rows(); ++f)
        columns.row (f) *= taper (numbers[static_cast<std::size_t> (f)], numbers.front(), numbers.back());

    makeEven (columns);
    const auto length = quickLength (2.0 * (last + 1));
    result.energy = Eigen::VectorXd::Zero (length);
    result.interval = 1 / (grid->spacing * static_cast<double> (length));
    result.bandwidth = grid->spacing * static_cast<double> (numbers.back() - numbers.front());
    FourierTables tables;
    Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero (length / 2 + 1);

    for (const auto& column : columns.colwise())
    {
        checkWatch();

        for (std::size_t f = 0; f < numbers.size(); ++f)
            spectrum[numbers[f]] = column[static_cast<Eigen::Index> (f)];

        result.energy += tables.inverse (spectrum, length).cwiseAbs2();
    }

    return result;
}

double onsetDelay (const ImpulseEnergy& impulse)
{
    constexpr double negative = 0.05;   // of the period
    constexpr double distinct = 20;     // times what is before
    constexpr double part = 0.01;       // of the peak
    constexpr double searchBand = 3750; // Hz: the widest in which poles are sought, with its margins
    const auto& energy = impulse.energy;
    const auto length = energy.size();
    const auto before = cyclicMean (energy, std::max<Eigen::Index> (4, length / 16));
    Eigen::Index quiet = 0, peak = 0;
    const auto floor = before.minCoeff (&quiet);
    const auto highest = energy.maxCoeff (&peak);

    if (! (highest > distinct * floor))
        return 0;

    const auto enough = std::max (part * highest, std::sqrt (floor * highest));
    auto onset = quiet;

    while (energy[onset % length] < enough)
        ++onset;

    auto end = quiet + length;

    while (energy[end % length] < enough)
        --end;

    // What grows until it ends has the other sign of time.
    if (const auto rise = (peak - onset + 2 * length) % length; 2 * rise > end - onset)
        return 0;

    auto delay = static_cast<double> (onset % length) * impulse.interval;
    const auto period = static_cast<double> (length) * impulse.interval;

    if (delay > (1 - negative) * period)
        delay -= period;

    constexpr double bearable = 1.5;
    return std::abs (delay) > bearable / std::min (impulse.bandwidth, searchBand) ? delay : 0;
}

bool seemsStationary (const ImpulseEnergy& impulse)
{
    constexpr double independent = 0.5, even = 6;
    const auto means = cyclicMean (impulse.energy, impulse.energy.size() / 8);
    return impulse.roughness > independent && means.maxCoeff() < even * means.minCoeff();
}

FrequencyResponses delayed (FrequencyResponses responses, double delay)
{
    Eigen::VectorXcd factors (responses.frequencies.size());

    for (Eigen::Index f = 0; f < factors.size(); ++f)
        factors[f] = std::polar (1.0, -2 * std::numbers::pi * responses.frequencies[f] * delay);

    for (auto& values : responses.values)
    {
        checkWatch();
        values.array().colwise() *= factors.array();
    }

    return responses;
}

namespace
{
void restoreResidues (IdentifiedModes& modes, Eigen::Index mode, double length)
{
    constexpr double doubtful = 0.01;
    const auto omega = modes.angularFrequencies[mode], ratio = modes.dampingRatios[mode];
    const std::complex<double> pole (-ratio * omega, omega * std::sqrt (1 - ratio * ratio));
    const auto cut = std::exp (pole * length);
    modes.participation.row (mode) /= (1.0 - cut).real();

    if (modes.complexParticipation.size() > 0)
        modes.complexParticipation.row (mode) /= 1.0 - cut;

    if (std::abs (cut) > doubtful && static_cast<std::size_t> (mode) < modes.quality.size())
        modes.quality[static_cast<std::size_t> (mode)].warnings.emplace_back (
            "its impulse response is truncated before it has decayed to 1 %; record for longer");
}

void removeWindow (IdentifiedModes& modes, Eigen::Index mode, double windowDecay)
{
    auto& omega = modes.angularFrequencies[mode];
    auto& ratio = modes.dampingRatios[mode];
    const auto damped = omega * std::sqrt (1 - ratio * ratio), decay = ratio * omega - windowDecay;

    if (! (decay > 0))
        throw InputError ("exponential window", "has a larger decay rate than mode " + std::to_string (mode + 1)
                                                    + "; allowed: below " + std::to_string (ratio * omega) + " 1/s");

    omega = std::hypot (damped, decay);
    ratio = decay / omega;
}
} // namespace

FrequencyResponses withModalNumerators (FrequencyResponses responses, const RecordEffects& effects)
{
    const Eigen::ArrayXcd derivative = std::complex<double> (0, 2 * std::numbers::pi) * responses.frequencies.array();
    const Eigen::ArrayXcd factors = effects.windowDecay > 0
                                        ? Eigen::ArrayXcd (derivative / (derivative + effects.windowDecay))
                                        : Eigen::ArrayXcd::Ones (derivative.size());

    for (auto& values : responses.values)
        values.array().colwise() *= factors;

    for (auto& variances : responses.variances)
        variances.array().colwise() *= factors.abs2();

    return responses;
}

IdentifiedModes withoutRecordEffects (IdentifiedModes modes, const RecordEffects& effects)
{
    for (Eigen::Index mode = 0; mode < modes.modes(); ++mode)
    {
        if (effects.length > 0)
            restoreResidues (modes, mode, effects.length);

        if (effects.windowDecay > 0)
            removeWindow (modes, mode, effects.windowDecay);
    }

    return modes;
}
} // namespace antinode
