#include "FeltMotion.h"

#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double lowestRate = 8000;           // Hz: skin feels nothing above 2 kHz
constexpr double ringing = 0.3, fading = 0.1; // s after the last sample
constexpr double silence = 0.1;               // s, in which the weighting itself dies away
constexpr double integrationTime = 0.1;       // s, over which skin adds up a vibration
constexpr double leastAmount = 1e-6;          // -120 dB

/** The lengths of a motion before and after it is made slower. */
struct Lengths
{
    Eigen::Index recorded, ringing, fading; // samples
    Eigen::Index factor;                    // samples per slower one
    Eigen::Index slower, transformed;       // slower samples

    Eigen::Index all() const { return recorded + ringing + fading; }
};

Lengths lengthsOf (Eigen::Index recorded, double sampleRate)
{
    Lengths lengths {};
    lengths.recorded = recorded;
    lengths.ringing = std::llround (ringing * sampleRate);
    lengths.fading = std::llround (fading * sampleRate);
    lengths.factor = std::max<Eigen::Index> (1, static_cast<Eigen::Index> (sampleRate / lowestRate));
    lengths.slower = (lengths.all() - 1) / lengths.factor + 1;
    const auto rate = sampleRate / static_cast<double> (lengths.factor);
    lengths.transformed = quickLength (static_cast<double> (lengths.slower) + silence * rate);
    return lengths;
}

/** A modal velocity and its free decay, which two samples determine: v_n = 2 r cos (b T) v_(n-1) - r^2 v_(n-2). */
Eigen::VectorXd withDecay (const Eigen::RowVectorXd& recorded, const Lengths& lengths, std::complex<double> pole,
                           double sampleRate)
{
    Eigen::VectorXd all (lengths.all());
    all.head (lengths.recorded) = recorded.transpose();
    const auto radius = std::exp (pole.real() / sampleRate);
    const auto first = 2 * radius * std::cos (pole.imag() / sampleRate), second = -radius * radius;

    for (auto n = lengths.recorded; n < all.size(); ++n)
        all[n] = first * all[n - 1] + second * all[n - 2];

    for (Eigen::Index i = 0; i < lengths.fading; ++i)
        all[all.size() - 1 - i] *=
            0.5 - 0.5 * std::cos (std::numbers::pi * static_cast<double> (i) / static_cast<double> (lengths.fading));

    return all;
}

/** What is below the slower rate's Nyquist frequency, at that rate. */
Eigen::VectorXd slowed (const Eigen::VectorXd& samples, const Lengths& lengths, const Eigen::VectorXd& taps)
{
    const auto reach = (taps.size() - 1) / 2;
    Eigen::VectorXd slower (lengths.slower);

    for (Eigen::Index m = 0; m < slower.size(); ++m)
    {
        const auto centre = m * lengths.factor;
        const auto begin = std::max<Eigen::Index> (0, centre - reach);
        const auto end = std::min (samples.size(), centre + reach + 1);
        slower[m] = samples.segment (begin, end - begin).dot (taps.segment (begin - centre + reach, end - begin));
    }

    return slower;
}

Eigen::VectorXd slowingTaps (Eigen::Index factor)
{
    const auto reach = kaiserSincHalfWidth * factor;
    Eigen::VectorXd taps (2 * reach + 1);

    for (Eigen::Index n = 0; n < taps.size(); ++n)
        taps[n] =
            kaiserSinc (static_cast<double> (n - reach) / static_cast<double> (factor)) / static_cast<double> (factor);

    return taps;
}

/** From velocity to displacement over threshold, line by line: 1 / (j w threshold). What rests is not felt. */
Eigen::VectorXcd weights (const SkinThreshold& threshold, Eigen::Index length, double rate)
{
    Eigen::VectorXcd result = Eigen::VectorXcd::Zero (length / 2 + 1);

    for (Eigen::Index k = 1; k < result.size(); ++k)
    {
        const auto frequency = static_cast<double> (k) * rate / static_cast<double> (length);
        result[k] = 1.0 / std::complex (0.0, 2 * std::numbers::pi * frequency * thresholdAt (threshold, frequency));
    }

    return result;
}
} // namespace

FeltMotion feltMotion (const ModalModel& model, const Eigen::MatrixXd& modalVelocities, double sampleRate,
                       const SkinThreshold& threshold)
{
    const auto lengths = lengthsOf (modalVelocities.cols(), sampleRate);
    const auto rate = sampleRate / static_cast<double> (lengths.factor);
    const auto taps = slowingTaps (lengths.factor);
    const auto byLine = weights (threshold, lengths.transformed, rate);
    const Eigen::VectorXd decays = decayRates (model), frequencies = dampedFrequencies (model);
    FeltMotion felt { rate, Eigen::MatrixXd (modalVelocities.rows(), lengths.slower) };

    const auto weigh = [&] (std::size_t index)
    {
        const auto k = static_cast<Eigen::Index> (index);
        const auto mode = k % model.modes(); // both coordinates of a complex mode decay alike
        const auto slower =
            slowed (withDecay (modalVelocities.row (k), lengths, { -decays[mode], frequencies[mode] }, sampleRate),
                    lengths, taps);
        const Eigen::VectorXcd spectrum = forwardFourier (slower, lengths.transformed).cwiseProduct (byLine);
        felt.modal.row (k) = inverseFourier (spectrum, lengths.transformed).head (lengths.slower).transpose();
    };
    parallelFor (static_cast<std::size_t> (modalVelocities.rows()), weigh);
    return felt;
}

double feltAmount (const Eigen::Ref<const Eigen::RowVectorXd>& weighted, double sampleRate)
{
    const auto window = std::max<Eigen::Index> (1, std::llround (integrationTime * sampleRate));
    double sum = 0, largest = 0, peak = 0;

    for (Eigen::Index n = 0; n < weighted.size(); ++n)
    {
        peak = std::max (peak, std::abs (weighted[n]));
        sum += weighted[n] * weighted[n];

        if (n >= window)
            sum -= weighted[n - window] * weighted[n - window];

        largest = std::max (largest, sum);
    }

    return std::max (peak, std::sqrt (2 * largest / static_cast<double> (window)));
}

double sensationLevel (double amount)
{
    return 20 * std::log10 (std::max (amount, leastAmount));
}
} // namespace antinode
