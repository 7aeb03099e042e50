#include "PreparedResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
using Column = Eigen::Ref<const Eigen::VectorXcd>;

bool isMeasured (const std::complex<double>& value)
{
    return std::isfinite (value.real()) && std::isfinite (value.imag());
}

Column responseColumn (const PreparedResponses& data, Eigen::Index column)
{
    const auto& values = data.responses->values[static_cast<std::size_t> (column / data.points())];
    return values.col (column % data.points()).segment (data.firstLine, data.lines());
}

/** The substitute for a missing value: the straight line between its measured neighbours, or the nearest one. */
std::complex<double> interpolated (const Column& values, const Eigen::VectorXd& omega, Eigen::Index line)
{
    auto before = line, after = line;

    while (before >= 0 && ! isMeasured (values[before]))
        --before;

    while (after < values.size() && ! isMeasured (values[after]))
        ++after;

    if (before < 0)
        return values[after];

    if (after >= values.size())
        return values[before];

    const auto share = (omega[line] - omega[before]) / (omega[after] - omega[before]);
    return values[before] + share * (values[after] - values[before]);
}

void findMissing (PreparedResponses& data)
{
    for (Eigen::Index c = 0; c < data.columns(); ++c)
    {
        checkWatch();
        const auto values = responseColumn (data, c);
        std::vector<MissingValue> found;

        for (Eigen::Index f = 0; f < values.size(); ++f)
            if (! isMeasured (values[f]))
                found.push_back ({ f, c, {} });

        if (2 * static_cast<Eigen::Index> (found.size()) > values.size())
        {
            data.columnWeights[c] = 0;
            continue;
        }

        for (auto& value : found)
            value.value = interpolated (values, data.omega, value.line);

        data.missing.insert (data.missing.end(), found.begin(), found.end());
    }

    std::stable_sort (data.missing.begin(), data.missing.end(),
                      [] (const auto& a, const auto& b) { return a.line < b.line; });
}

/** Of lines or columns: the medians of the variances, each times a weight. A median, so that zeros and outliers do not
    rule. */
void weighByVariances (PreparedResponses& data)
{
    const auto usable = [] (double variance) { return std::isfinite (variance) && variance > 0; };
    const auto variance = [&data] (Eigen::Index line, Eigen::Index column)
    {
        return data.responses->variances[static_cast<std::size_t> (column / data.points())](data.firstLine + line,
                                                                                            column % data.points());
    };
    std::vector<double> found;

    for (Eigen::Index c = 0; c < data.columns(); ++c)
    {
        checkWatch();
        found.clear();

        for (Eigen::Index f = 0; f < data.lines(); ++f)
            if (usable (variance (f, c)))
                found.push_back (variance (f, c));

        if (! found.empty() && data.columnWeights[c] > 0)
            data.columnWeights[c] = 1 / median (found);
    }

    for (Eigen::Index f = 0; f < data.lines(); ++f)
    {
        found.clear();

        for (Eigen::Index c = 0; c < data.columns(); ++c)
            if (data.columnWeights[c] > 0 && usable (variance (f, c)))
                found.push_back (variance (f, c) * data.columnWeights[c]);

        if (! found.empty())
            data.lineWeights[f] = 1 / median (found);
    }
}
} // namespace

PreparedResponses prepare (const FrequencyResponses& responses, double minimumFrequency, double maximumFrequency)
{
    const auto& frequencies = responses.frequencies;
    const auto* const begin = frequencies.data();
    // A velocity at frequency 0 says nothing about modes, and the inertia of a rigid body is infinite there.
    const auto lowest = std::max (minimumFrequency, 1e-9 * frequencies[frequencies.size() - 1]);
    const auto first = std::lower_bound (begin, begin + frequencies.size(), lowest) - begin;
    const auto last = std::upper_bound (begin, begin + frequencies.size(), maximumFrequency) - begin;

    if (last - first < 8)
        throw InputError ("frequency responses", "have " + std::to_string (std::max<std::ptrdiff_t> (0, last - first))
                                                     + " lines in the frequency range; allowed: 8 or more");

    PreparedResponses data;
    data.responses = &responses;
    data.firstLine = first;
    data.omega = 2 * std::numbers::pi * frequencies.segment (first, last - first);
    data.lineScale = (data.omega / std::sqrt (data.omega[0] * data.omega[data.lines() - 1]))
                         .array()
                         .pow (responses.integrations)
                         .matrix();
    data.lineWeights = data.lineScale.cwiseAbs2();
    data.columnWeights.setOnes (data.columns());
    findMissing (data);

    if (data.columnWeights.maxCoeff() <= 0)
        throw InputError ("frequency responses",
                          "have no pair of point and reference with at least half of the values measured");

    if (! responses.variances.empty())
        weighByVariances (data);

    return data;
}

DataBlock dataBlock (const PreparedResponses& data, Eigen::Index first, const Eigen::VectorXcd& factors)
{
    const auto count = factors.size();
    DataBlock result { Eigen::MatrixXd (count, data.columns()), Eigen::MatrixXd (count, data.columns()) };

    for (Eigen::Index c = 0; c < data.columns(); ++c)
    {
        if (data.columnWeights[c] <= 0)
        {
            result.real.col (c).setZero();
            result.imaginary.col (c).setZero();
            continue;
        }

        const auto values = responseColumn (data, c).segment (first, count);

        // Written out: the compiler's own product looks for infinities.
        for (Eigen::Index f = 0; f < count; ++f)
        {
            result.real (f, c) = values[f].real() * factors[f].real() - values[f].imag() * factors[f].imag();
            result.imaginary (f, c) = values[f].real() * factors[f].imag() + values[f].imag() * factors[f].real();
        }
    }

    const auto before = [] (const MissingValue& value, Eigen::Index line) { return value.line < line; };

    for (auto missing = std::lower_bound (data.missing.begin(), data.missing.end(), first, before);
         missing != data.missing.end() && missing->line < first + count; ++missing)
    {
        const auto value = missing->value * factors[missing->line - first];
        result.real (missing->line - first, missing->column) = value.real();
        result.imaginary (missing->line - first, missing->column) = value.imag();
    }

    return result;
}

Eigen::VectorXcd advances (const PreparedResponses& data, Eigen::Index first, Eigen::Index count, double delay)
{
    Eigen::VectorXcd result (count);

    for (Eigen::Index f = 0; f < count; ++f)
        result[f] = std::polar (1.0, data.omega[first + f] * delay);

    return result;
}
} // namespace antinode
