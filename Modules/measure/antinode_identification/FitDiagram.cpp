#include "FitDiagram.h"

#include <Eigen/SVD>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace antinode
{
namespace
{
std::complex<double> finiteOrZero (std::complex<double> value)
{
    return std::isfinite (value.real()) && std::isfinite (value.imag()) ? value : 0;
}

/** RMS over what is finite of a - b, at each line; b is 0 if it has no values. */
Eigen::VectorXd sizeOfDifference (const FrequencyResponses& a, const FrequencyResponses& b)
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero (a.frequencies.size());
    auto count = sum;

    for (std::size_t i = 0; i < a.values.size(); ++i)
        for (Eigen::Index p = 0; p < a.values[i].cols(); ++p)
            for (Eigen::Index f = 0; f < sum.size(); ++f)
            {
                const auto square = std::norm (a.values[i](f, p) - (b.values.empty() ? 0 : b.values[i](f, p)));
                sum[f] += std::isfinite (square) ? square : 0;
                count[f] += std::isfinite (square) ? 1 : 0;
            }

    return sum.cwiseQuotient (count.cwiseMax (1)).cwiseSqrt();
}
} // namespace

Eigen::VectorXd localNoise (const Eigen::VectorXcd& values)
{
    constexpr Eigen::Index reach = 12;
    constexpr double ofWhiteNoise = 6;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero (values.size()), noise = squares;

    for (Eigen::Index n = 1; n + 1 < values.size(); ++n)
        squares[n] = std::norm (values[n - 1] - 2.0 * values[n] + values[n + 1]) / ofWhiteNoise;

    for (Eigen::Index n = 0; n < values.size(); ++n)
    {
        const auto first = std::max<Eigen::Index> (n - reach, 0);
        const auto last = std::min (n + reach + 1, values.size());
        std::vector<double> near;

        for (auto k = first; k < last; ++k)
            if (std::isfinite (squares[k]))
                near.push_back (squares[k]);

        noise[n] = near.empty() ? 0 : std::sqrt (median (near) / std::numbers::ln2);
    }

    return noise;
}

Eigen::MatrixXd modeIndicator (const FrequencyResponses& responses)
{
    const auto points = responses.points.rows(), references = static_cast<Eigen::Index> (responses.values.size());
    Eigen::MatrixXd result (responses.frequencies.size(), std::min (points, references));
    Eigen::MatrixXcd table (points, references);

    for (Eigen::Index f = 0; f < result.rows(); ++f)
    {
        for (Eigen::Index i = 0; i < references; ++i)
            table.col (i) = responses.values[static_cast<std::size_t> (i)].row (f).unaryExpr (&finiteOrZero);

        result.row (f) = Eigen::JacobiSVD<Eigen::MatrixXcd> (table).singularValues();
    }

    return result;
}

FitDiagram fitDiagram (const FrequencyResponses& responses, const IdentifiedModes& modes, Eigen::Index largest)
{
    const auto used = usedLines (responses, modes);
    const auto valuesPerLine = responses.points.rows() * static_cast<Eigen::Index> (responses.values.size());
    const auto count = std::max<Eigen::Index> (2, largest / std::max<Eigen::Index> (valuesPerLine, 1));
    FitDiagram result;
    result.usedLines = static_cast<Eigen::Index> (used.size());
    result.measured = atLines (responses, thinnedLines (used, responses, modes, count));
    result.synthesised = synthesise (modes, result.measured.frequencies);
    result.indicator = modeIndicator (result.measured);
    result.measuredSize = sizeOfDifference (result.measured, {});
    result.errorSize = sizeOfDifference (result.measured, result.synthesised);
    return result;
}

namespace
{
/** How fast the responses may change at a frequency, 1/Hz: the slopes of the resonances' phases, none of which ever
   vanishes. */
double density (const IdentifiedModes& modes, double frequency)
{
    auto largest = 0.0;

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto resonance = modes.angularFrequencies[k] / (2 * std::numbers::pi);
        const auto halfWidth = std::max (modes.dampingRatios[k] * resonance, 1e-9 * resonance);
        largest = std::max (largest, halfWidth / (halfWidth * halfWidth + std::pow (frequency - resonance, 2)));
    }

    return largest;
}
} // namespace

std::vector<Eigen::Index> usedLines (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    constexpr double rounding = 1e-9; // The limits are lines, through rad/s and back.
    std::vector<Eigen::Index> lines;

    for (Eigen::Index f = 0; f < responses.frequencies.size(); ++f)
        if (responses.frequencies[f] >= modes.minimumFrequency * (1 - rounding)
            && responses.frequencies[f] <= modes.maximumFrequency * (1 + rounding))
            lines.push_back (f);

    return lines;
}

std::vector<Eigen::Index> thinnedLines (const std::vector<Eigen::Index>& lines, const FrequencyResponses& responses,
                                        const IdentifiedModes& modes, Eigen::Index count)
{
    const auto size = static_cast<Eigen::Index> (lines.size());

    if (size <= count)
        return lines;

    // What has passed since the first line: half by changes of phase, half evenly.
    Eigen::VectorXd passed (size);
    passed[0] = 0;

    for (Eigen::Index n = 1; n < size; ++n)
    {
        const auto from = responses.frequencies[lines[static_cast<std::size_t> (n - 1)]];
        const auto to = responses.frequencies[lines[static_cast<std::size_t> (n)]];
        passed[n] = passed[n - 1] + density (modes, (from + to) / 2) * (to - from);
    }

    passed += Eigen::VectorXd::LinSpaced (size, 0, std::max (passed[size - 1], 1.0));
    std::vector<Eigen::Index> result { lines.front() };
    const auto step = passed[size - 1] / static_cast<double> (count - 1);

    for (Eigen::Index n = 1; n + 1 < size; ++n)
        if (std::floor (passed[n] / step) > std::floor (passed[n - 1] / step))
            result.push_back (lines[static_cast<std::size_t> (n)]);

    result.push_back (lines.back());
    return result;
}

FrequencyResponses atLines (const FrequencyResponses& responses, const std::vector<Eigen::Index>& lines)
{
    auto result = FrequencyResponses {
        responses.frequencies (lines), responses.drive,           responses.references, responses.points, {}, {},
        responses.integrations,        responses.isQuantityStated
    };

    for (const auto& values : responses.values)
        result.values.emplace_back (values (lines, Eigen::all));

    for (const auto& variances : responses.variances)
        result.variances.emplace_back (variances (lines, Eigen::all));

    return result;
}
} // namespace antinode
