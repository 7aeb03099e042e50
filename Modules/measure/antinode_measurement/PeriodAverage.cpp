#include "PeriodAverage.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace antinode
{
namespace
{
/** The lines of all periods of a signal: periods in columns. */
Eigen::MatrixXcd periodSpectra (FourierTables& tables, const Eigen::VectorXd& signal, Eigen::Index period)
{
    Eigen::MatrixXcd spectra (period / 2 + 1, signal.size() / period);

    for (Eigen::Index r = 0; r < spectra.cols(); ++r)
        spectra.col (r) = tables.forward (signal.segment (r * period, period));

    return spectra;
}

struct Averages
{
    Eigen::VectorXcd mean;
    Eigen::MatrixXcd deviations; ///< Lines x periods.

    explicit Averages (const Eigen::MatrixXcd& spectra)
        : mean (spectra.rowwise().mean()), deviations (spectra.colwise() - mean)
    {
    }
};

/** Sum over periods of a conj (b) over R (R - 1): the covariance of the means. */
Eigen::ArrayXcd covarianceOfMeans (const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b)
{
    const auto periods = static_cast<double> (a.cols());
    return a.cwiseProduct (b.conjugate()).rowwise().sum().array() / (periods * (periods - 1));
}

/** The effective value on lines of a kind between the excited ones, noise taken out. */
struct UnexcitedPower
{
    double power = 0, count = 0;

    void add (double linePower, double noise)
    {
        power += linePower - noise;
        count += 1;
    }

    double effectivePerLine() const { return count > 0 ? std::max (0.0, power / count) : 0; }
};

NonlinearDistortion computeDistortion (const PeriodicLines& lines, const Averages& output)
{
    const Eigen::ArrayXd noise = output.deviations.cols() > 1
                                     ? Eigen::ArrayXd (covarianceOfMeans (output.deviations, output.deviations).real())
                                     : Eigen::ArrayXd::Zero (output.mean.size());
    UnexcitedPower linear, even, odd;

    for (auto line = lines.excited.front(); line <= lines.excited.back(); ++line)
    {
        const auto isExcited = std::binary_search (lines.excited.begin(), lines.excited.end(), line);
        auto& kind = isExcited ? linear : line % 2 == 0 ? even : odd;
        kind.add (std::norm (output.mean[line]), noise[line]);
    }

    const auto reference = linear.effectivePerLine();
    return reference > 0 ? NonlinearDistortion { std::sqrt (even.effectivePerLine() / reference),
                                                 std::sqrt (odd.effectivePerLine() / reference),
                                                 {} }
                         : NonlinearDistortion {};
}

void requireWholePeriods (const PeriodicLines& lines, const Eigen::VectorXd& input, const Eigen::MatrixXd& outputs)
{
    if (input.size() < lines.period || input.size() % lines.period != 0 || outputs.cols() != input.size())
        throw InputError ("recording", "has " + std::to_string (outputs.cols())
                                           + " samples; allowed: a whole number of periods of "
                                           + std::to_string (lines.period));
}
} // namespace

EstimatedResponses averagePeriods (const PeriodicLines& lines, const Eigen::VectorXd& input,
                                   const Eigen::MatrixXd& outputs)
{
    requireWholePeriods (lines, input, outputs);
    const auto& excited = lines.excited;
    const auto count = static_cast<Eigen::Index> (excited.size());
    const auto periods = input.size() / lines.period;
    FourierTables tables;
    const Averages whole (periodSpectra (tables, input, lines.period));
    const Eigen::VectorXcd x = whole.mean (excited);
    const Eigen::MatrixXcd dx = whole.deviations (excited, Eigen::all);

    if (! (x.cwiseAbs().minCoeff() > 0))
        throw InputError ("recording", "has no input signal on a line to be measured");

    EstimatedResponses result;
    result.values.resize (count, outputs.rows());

    if (periods > 1)
        result.variances = result.coherence = Eigen::MatrixXd (count, outputs.rows());

    if (lines.showsDistortion)
        result.distortion.resize (static_cast<std::size_t> (outputs.rows()));

    const auto estimateSensor = [&] (Eigen::Index sensor, FourierTables& own)
    {
        const Averages output (periodSpectra (own, outputs.row (sensor), lines.period));
        const Eigen::VectorXcd y = output.mean (excited);
        result.values.col (sensor) = y.cwiseQuotient (x);

        if (lines.showsDistortion)
            result.distortion[static_cast<std::size_t> (sensor)] = computeDistortion (lines, output);

        if (periods < 2)
            return;

        const Eigen::MatrixXcd dy = output.deviations (excited, Eigen::all);
        // The errors of Y - h X over X, without a division by Y, which may be 0.
        const Eigen::MatrixXcd residual = dy - result.values.col (sensor).asDiagonal() * dx;
        result.variances.col (sensor) = covarianceOfMeans (residual, residual).real() / x.array().abs2();
        const Eigen::ArrayXd single = covarianceOfMeans (dy, dy).real() * static_cast<double> (periods);
        const Eigen::ArrayXd power = y.array().abs2();
        result.coherence.col (sensor) = power / (power + single).max (1e-300);
    };
    const auto parts = std::min<Eigen::Index> (outputs.rows(), static_cast<Eigen::Index> (processorThreads()));
    parallelFor (static_cast<std::size_t> (parts),
                 [&] (std::size_t part)
                 {
                     FourierTables own;

                     for (auto sensor = static_cast<Eigen::Index> (part); sensor < outputs.rows(); sensor += parts)
                     {
                         checkWatch();
                         estimateSensor (sensor, own);
                     }
                 });
    result.variances = averagedOverNeighbours (result.variances);
    return result;
}
} // namespace antinode
