#include "Sensation.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
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
constexpr double slopeBeyond = 4; // of the logarithms: 24 dB an octave
}

double thresholdAt (const SkinThreshold& threshold, double frequency)
{
    const auto& frequencies = threshold.frequencies;
    const auto& displacements = threshold.displacements;
    const auto last = frequencies.size() - 1;

    if (frequency <= frequencies[0])
        return displacements[0] * std::pow (frequencies[0] / frequency, slopeBeyond);

    if (frequency >= frequencies[last])
        return displacements[last] * std::pow (frequency / frequencies[last], slopeBeyond);

    const auto upper = std::upper_bound (frequencies.begin(), frequencies.end(), frequency) - frequencies.begin();
    const auto share =
        std::log (frequency / frequencies[upper - 1]) / std::log (frequencies[upper] / frequencies[upper - 1]);
    return displacements[upper - 1] * std::pow (displacements[upper] / displacements[upper - 1], share);
}

void validate (const SkinThreshold& threshold)
{
    const auto& frequencies = threshold.frequencies;

    if (frequencies.size() < 2 || frequencies.size() != threshold.displacements.size())
        throw InputError (threshold.source, "needs at least two lines of a frequency in Hz and a displacement in um");

    for (Eigen::Index i = 0; i < frequencies.size(); ++i)
    {
        const auto isAscending = frequencies[i] > (i > 0 ? frequencies[i - 1] : 0.0);

        if (! isAscending || ! std::isfinite (frequencies[i]))
            throw InputError (threshold.source, "has the frequency " + inWords (frequencies[i]) + " Hz in row "
                                                    + std::to_string (i + 1) + "; allowed: above 0 and ascending");

        if (! (threshold.displacements[i] > 0) || ! std::isfinite (threshold.displacements[i]))
            throw InputError (threshold.source, "has a displacement that is not above 0 at " + inWords (frequencies[i])
                                                    + " Hz; allowed: um above 0");
    }
}

Eigen::RowVectorXd feltDisplacement (const Eigen::VectorXd& displacement, double sampleRate,
                                     const SkinThreshold& threshold)
{
    constexpr double dyingAway = 0.1; // s, of the weighting itself
    const auto length = quickLength (static_cast<double> (displacement.size()) + dyingAway * sampleRate);
    auto spectrum = forwardFourier (displacement, length);
    spectrum[0] = 0;

    for (Eigen::Index k = 1; k < spectrum.size(); ++k)
        spectrum[k] /= thresholdAt (threshold, static_cast<double> (k) * sampleRate / static_cast<double> (length));

    return inverseFourier (spectrum, length).head (displacement.size()).transpose();
}

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
    Eigen::Index recorded;                    // samples
    Eigen::Index factor;                      // samples per slower one
    Eigen::Index slower, fading, transformed; // slower samples
    Eigen::Index summed;                      // slower samples that are sums over samples; the others decay freely
    Eigen::Index continued;                   // samples that these sums need
};

Lengths lengthsOf (Eigen::Index recorded, double sampleRate)
{
    Lengths lengths {};
    lengths.recorded = recorded;
    lengths.factor = std::max<Eigen::Index> (1, static_cast<Eigen::Index> (sampleRate / lowestRate));
    const auto all = recorded + std::llround (ringing * sampleRate) + std::llround (fading * sampleRate);
    const auto rate = sampleRate / static_cast<double> (lengths.factor);
    const auto reach = kaiserSincHalfWidth * lengths.factor;
    lengths.slower = (all - 1) / lengths.factor + 1;
    lengths.fading = std::llround (fading * rate);
    lengths.transformed = quickLength (static_cast<double> (lengths.slower) + silence * rate);
    // Sums over nothing but free decay decay alike: two of them determine all others. The last two samples are free.
    lengths.summed = std::min (lengths.slower, (recorded - 2 + reach - 1) / lengths.factor + 3);
    lengths.continued = (lengths.summed - 1) * lengths.factor + reach + 1;
    return lengths;
}

/** Appends free decay, which two values determine: v_n = 2 r cos (b T) v_(n-1) - r^2 v_(n-2).
    @param known  values that are there; the others are computed
    @param interval  between two values, s */
void appendDecay (Eigen::VectorXd& values, Eigen::Index known, std::complex<double> pole, double interval)
{
    const auto radius = std::exp (pole.real() * interval);
    const auto first = 2 * radius * std::cos (pole.imag() * interval), second = -radius * radius;

    for (auto n = known; n < values.size(); ++n)
        values[n] = first * values[n - 1] + second * values[n - 2];
}

/** What of a modal velocity and its free decay is below the slower rate's Nyquist frequency, at that rate, faded out.
 */
Eigen::VectorXd slowed (const Eigen::RowVectorXd& recorded, const Lengths& lengths, std::complex<double> pole,
                        double sampleRate, const Eigen::VectorXd& taps)
{
    Eigen::VectorXd samples (std::max (lengths.continued, lengths.recorded));
    samples.head (lengths.recorded) = recorded.transpose();
    appendDecay (samples, lengths.recorded, pole, 1 / sampleRate);
    const auto reach = (taps.size() - 1) / 2;
    Eigen::VectorXd slower (lengths.slower);

    for (Eigen::Index m = 0; m < lengths.summed; ++m)
    {
        const auto centre = m * lengths.factor;
        const auto begin = std::max<Eigen::Index> (0, centre - reach);
        const auto end = std::min (samples.size(), centre + reach + 1);
        slower[m] = samples.segment (begin, end - begin).dot (taps.segment (begin - centre + reach, end - begin));
    }

    appendDecay (slower, lengths.summed, pole, static_cast<double> (lengths.factor) / sampleRate);

    for (Eigen::Index i = 0; i < lengths.fading; ++i)
        slower[slower.size() - 1 - i] *=
            0.5 - 0.5 * std::cos (std::numbers::pi * static_cast<double> (i) / static_cast<double> (lengths.fading));

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
        const std::complex pole { -decays[mode], frequencies[mode] };
        const auto slower = slowed (modalVelocities.row (k), lengths, pole, sampleRate, taps);
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
