#include "EstimatedResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

namespace antinode
{
Eigen::MatrixXd averagedOverNeighbours (const Eigen::MatrixXd& variances)
{
    constexpr Eigen::Index neighbours = 4;
    Eigen::MatrixXd result (variances.rows(), variances.cols());

    for (Eigen::Index line = 0; line < variances.rows(); ++line)
    {
        const auto first = std::max<Eigen::Index> (0, line - neighbours);
        const auto count = std::min (variances.rows(), line + neighbours + 1) - first;
        result.row (line) = variances.middleRows (first, count).colwise().mean();
    }

    return result;
}

namespace
{
Eigen::VectorXcd response (ResponseEstimator estimator, const Eigen::ArrayXd& xx, const Eigen::ArrayXd& yy,
                           const Eigen::ArrayXcd& yx)
{
    const Eigen::ArrayXcd h1 = yx / xx.cast<std::complex<double>>();

    if (estimator == ResponseEstimator::h1)
        return h1;

    // |H2| / |H1| = S_xx S_yy / |S_yx|^2, 1 over the coherence.
    const Eigen::ArrayXd overH1 = xx * yy / yx.abs2().max (1e-300);
    return h1 * (estimator == ResponseEstimator::h2 ? overH1 : overH1.sqrt()).cast<std::complex<double>>();
}
} // namespace

AveragedSpectra::AveragedSpectra (Eigen::MatrixXcd input)
    : spectra (std::move (input)), powers (spectra.cwiseAbs2().rowwise().sum().array())
{
}

void AveragedSpectra::estimate (const Eigen::MatrixXcd& output, ResponseEstimator estimator, double averages,
                                Eigen::Index column, EstimatedResponses& result) const
{
    const Eigen::ArrayXd yy = output.cwiseAbs2().rowwise().sum().array();
    const Eigen::ArrayXcd yx = output.cwiseProduct (spectra.conjugate()).rowwise().sum().array();
    const Eigen::ArrayXd coherence = (yx.abs2() / (powers * yy).max (1e-300)).min (1.0);
    result.values.col (column) = response (estimator, powers, yy, yx);
    result.coherence.col (column) = coherence;
    result.variances.col (column) =
        (yx / powers.cast<std::complex<double>>()).abs2() * (1 - coherence) / (coherence.max (1e-12) * averages);
}

namespace
{
/** 1 + 2 rho^2: rho = 1/6 is the correlation of neighbours' Hann windows that overlap by half. */
constexpr double overlapLoss = 1 + 2.0 / 36;

Eigen::VectorXd hann (Eigen::Index length)
{
    return Eigen::VectorXd::NullaryExpr (
        length,
        [&] (Eigen::Index n) {
            return 0.5 - 0.5 * std::cos (2 * std::numbers::pi * static_cast<double> (n) / static_cast<double> (length));
        });
}

/** The lines of all windowed blocks of a signal: blocks in columns. */
Eigen::MatrixXcd blockSpectra (const Eigen::VectorXd& signal, const Eigen::VectorXd& window,
                               const std::vector<Eigen::Index>& lines)
{
    const auto block = window.size(), step = block / 2;
    Eigen::MatrixXcd spectra (static_cast<Eigen::Index> (lines.size()), (signal.size() - block) / step + 1);

    for (Eigen::Index r = 0; r < spectra.cols(); ++r)
        spectra.col (r) = forwardFourier (signal.segment (r * step, block).cwiseProduct (window)) (lines);

    return spectra;
}
} // namespace

EstimatedResponses estimateByWelch (Eigen::Index block, const std::vector<Eigen::Index>& lines,
                                    ResponseEstimator estimator, const Eigen::VectorXd& input,
                                    const Eigen::MatrixXd& outputs)
{
    if (input.size() < block || outputs.cols() != input.size())
        throw InputError ("recording", "has " + std::to_string (outputs.cols())
                                           + " samples; allowed: at least those of a block, " + std::to_string (block));

    const auto window = hann (block);
    const AveragedSpectra spectra (blockSpectra (input, window, lines));

    if (! spectra.drivesAllLines())
        throw InputError ("recording", "has no input signal on a line to be measured");

    const auto blocks = (input.size() - block) / (block / 2) + 1, count = static_cast<Eigen::Index> (lines.size());
    const auto averages = std::max (1.0, static_cast<double> (blocks) / overlapLoss);
    EstimatedResponses result;
    result.values.resize (count, outputs.rows());
    result.coherence.resize (count, outputs.rows());
    result.variances.resize (count, outputs.rows());

    for (Eigen::Index sensor = 0; sensor < outputs.rows(); ++sensor)
        spectra.estimate (blockSpectra (outputs.row (sensor), window, lines), estimator, averages, sensor, result);

    // One block fits itself: it looks perfectly coherent and gives no information about its error.
    if (blocks < 2)
        result.coherence = result.variances = {};

    return result;
}

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

namespace
{
constexpr int highestHarmonic = 5;

double cosineStep (double place)
{
    return 0.5 - 0.5 * std::cos (std::numbers::pi * std::clamp (place, 0.0, 1.0));
}

/** 1 within the band, 0 beyond the sweep, and a fade between them. */
double bandGain (const RepeatedSweep& played, double frequency)
{
    const auto start = played.sweep.startFrequency, end = played.sweep.endFrequency;
    return cosineStep ((frequency - start) / (played.lowest - start))
           * cosineStep ((end - frequency) / (end - played.highest));
}

Eigen::VectorXd meanBlock (const Eigen::VectorXd& signal, Eigen::Index block)
{
    return Eigen::Map<const Eigen::MatrixXd> (signal.data(), block, signal.size() / block).rowwise().mean();
}

/** 1/X within the band. */
Eigen::VectorXcd invertSpectrum (const RepeatedSweep& played, const Eigen::VectorXd& input, Eigen::Index length)
{
    auto inverse = forwardFourier (meanBlock (input, played.block), length);

    for (Eigen::Index k = 0; k < inverse.size(); ++k)
    {
        const auto gain = bandGain (played, static_cast<double> (k) * played.sampleRate / static_cast<double> (length));

        if (gain > 0 && ! (std::abs (inverse[k]) > 0))
            throw InputError ("recording", "has no input signal on a line to be measured");

        inverse[k] = gain > 0 ? gain / inverse[k] : 0.0;
    }

    return inverse;
}

/** So many samples from a place on, which may lie before the beginning: the signal is a ring. */
Eigen::VectorXd around (const Eigen::VectorXd& ring, Eigen::Index first, Eigen::Index count)
{
    return Eigen::VectorXd::NullaryExpr (count, [&] (Eigen::Index n)
                                         { return ring[(first + n + 2 * ring.size()) % ring.size()]; });
}

/** The impulse response from before its lag 0 on, faded at its begin and end, with lag 0 on sample 0. What stands
   before it is folded to the end: on the lines of this length that changes nothing. */
Eigen::VectorXd cutOut (const Eigen::VectorXd& ring, Eigen::Index lead, Eigen::Index length)
{
    auto part = around (ring, -lead, lead + length);
    const auto fade = std::max<Eigen::Index> (1, lead / 2);

    for (Eigen::Index n = 0; n < fade; ++n)
    {
        const auto gain = cosineStep ((static_cast<double> (n) + 0.5) / static_cast<double> (fade));
        part[n] *= gain;
        part[part.size() - 1 - n] *= gain;
    }

    Eigen::VectorXd folded = part.tail (length);
    folded.tail (lead) += part.head (lead);
    return folded;
}

/** Where harmonic m stands before the linear response, samples. */
Eigen::Index harmonicLead (const RepeatedSweep& played, int harmonic)
{
    return static_cast<Eigen::Index> (
        std::lround (played.sweep.rise * std::log (static_cast<double> (harmonic)) * played.sampleRate));
}

/** What is kept before an impulse response begins, where its band's edges ring, and no harmonic. */
Eigen::Index leadSamples (const RepeatedSweep& played)
{
    return std::min (harmonicLead (played, 2) / 2, played.responseLength / 4);
}

/** Effective values of the harmonics over that of the linear response, each within the room that the closest two of
    them leave. */
std::vector<double> harmonicLevels (const RepeatedSweep& played, const Eigen::VectorXd& ring)
{
    const auto room = harmonicLead (played, highestHarmonic + 1) - harmonicLead (played, highestHarmonic);
    const auto lead = std::min (leadSamples (played), room / 4);
    const auto linear = around (ring, -lead, room).norm();
    std::vector<double> levels;

    for (int m = 2; m <= highestHarmonic && linear > 0; ++m)
        levels.push_back (around (ring, -harmonicLead (played, m) - lead, room).norm() / linear);

    return levels;
}

/** The linear responses of all repetitions (columns) to an input, and the harmonics of their mean. */
struct Deconvolution
{
    Eigen::MatrixXcd responses;
    NonlinearDistortion distortion;
};

Deconvolution deconvolve (const RepeatedSweep& played, const Eigen::VectorXcd& inverse, Eigen::Index length,
                          const Eigen::VectorXd& output)
{
    Deconvolution result;
    result.responses.resize (static_cast<Eigen::Index> (played.lines.size()), output.size() / played.block);
    Eigen::VectorXd mean = Eigen::VectorXd::Zero (length);

    for (Eigen::Index r = 0; r < result.responses.cols(); ++r)
    {
        const Eigen::VectorXd block = output.segment (r * played.block, played.block);
        const auto ring = inverseFourier (forwardFourier (block, length).cwiseProduct (inverse), length);
        result.responses.col (r) =
            forwardFourier (cutOut (ring, leadSamples (played), played.responseLength)) (played.lines);
        mean += ring;
    }

    result.distortion.harmonics = harmonicLevels (played, mean);
    return result;
}

void requireWholeBlocks (const RepeatedSweep& played, const Eigen::VectorXd& input, const Eigen::MatrixXd& outputs)
{
    if (outputs.cols() != input.size() || input.size() < played.block || input.size() % played.block != 0)
        throw InputError ("recording", "has " + std::to_string (outputs.cols())
                                           + " samples; allowed: a whole number of blocks of "
                                           + std::to_string (played.block));
}
} // namespace

EstimatedResponses deconvolveSweep (const RepeatedSweep& played, const Eigen::VectorXd& input,
                                    const Eigen::MatrixXd& outputs)
{
    requireWholeBlocks (played, input, outputs);
    // Harmonics, which stand before the linear response, must not fold onto its end.
    const auto length = quickLength (static_cast<double> (2 * played.block));
    const auto inverse = invertSpectrum (played, input, length);
    const auto lines = static_cast<Eigen::Index> (played.lines.size()), repetitions = input.size() / played.block;
    EstimatedResponses result;
    result.values.resize (lines, outputs.rows());
    Eigen::MatrixXd variances (lines, outputs.rows());

    for (Eigen::Index sensor = 0; sensor < outputs.rows(); ++sensor)
    {
        auto [responses, distortion] = deconvolve (played, inverse, length, outputs.row (sensor));
        result.distortion.push_back (std::move (distortion));
        result.values.col (sensor) = responses.rowwise().mean();
        responses.colwise() -= result.values.col (sensor);
        variances.col (sensor) = responses.rowwise().squaredNorm()
                                 / static_cast<double> (repetitions * std::max<Eigen::Index> (1, repetitions - 1));
    }

    if (repetitions > 1)
    {
        result.variances = averagedOverNeighbours (variances);
        const Eigen::ArrayXXd power = result.values.cwiseAbs2();
        result.coherence = power / (power + static_cast<double> (repetitions) * result.variances.array()).max (1e-300);
    }

    return result;
}
} // namespace antinode
