#include "Spectrogram.h"

#include "Numbers.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace antinode
{
namespace
{
void requireUsable (double sampleRate, const SpectrogramSettings& settings)
{
    const auto require = [] (bool isUsable, const std::string& what, double value, const std::string& allowed)
    {
        if (! isUsable)
            throw InputError ("spectrogram", what + " is " + formatNumber (value) + "; allowed: " + allowed);
    };
    require (std::isfinite (sampleRate) && sampleRate > 0, "the sample rate", sampleRate, "above 0 Hz");
    const auto samples = settings.windowDuration * sampleRate;
    require (samples >= 4 && samples <= 1e7, "the window's length", samples, "4 to 10 000 000 samples");
    require (settings.columns >= 1 && settings.columns <= 100000, "the number of instants", settings.columns,
             "1 to 100 000");
    require (settings.floorDecibels < 0, "the floor", settings.floorDecibels, "below 0 dB");
    require (settings.reference >= 0, "the reference", settings.reference, "0 or more");
    require (settings.maximumFrequency >= 0, "the highest frequency", settings.maximumFrequency, "0 Hz or more");
}

// Hann, scaled so that a sine of amplitude 1 has a line of height 1.
Eigen::VectorXd amplitudeWindow (Eigen::Index length)
{
    const Eigen::ArrayXd place =
        (Eigen::ArrayXd::LinSpaced (length, 0, static_cast<double> (length - 1)) + 0.5) / static_cast<double> (length);
    const Eigen::VectorXd window = (1 - (2 * std::numbers::pi * place).cos()).matrix();
    return window * (2 / window.sum());
}

// Twice the window or more: zero padding, so that lines between two frequencies lose little.
Eigen::Index transformLength (Eigen::Index window)
{
    Eigen::Index length = 1;
    while (length < 2 * window)
        length *= 2;
    return length;
}

std::vector<double> windowed (const Eigen::Ref<const Eigen::VectorXd>& signal, const Eigen::VectorXd& window,
                              Eigen::Index middle, Eigen::Index length)
{
    std::vector<double> frame (static_cast<std::size_t> (length), 0.0);
    for (Eigen::Index k = 0; k < window.size(); ++k)
    {
        const auto sample = middle - window.size() / 2 + k;
        if (sample >= 0 && sample < signal.size() && std::isfinite (signal[sample]))
            frame[static_cast<std::size_t> (k)] = signal[sample] * window[k];
    }
    return frame;
}

Eigen::MatrixXd toDecibels (const Eigen::MatrixXd& amplitudes, const SpectrogramSettings& settings)
{
    const auto largest = amplitudes.maxCoeff();
    const auto reference = settings.reference > 0 ? settings.reference : largest;
    if (! (reference > 0))
        return Eigen::MatrixXd::Constant (amplitudes.rows(), amplitudes.cols(), settings.floorDecibels);
    const auto minimum = std::pow (10.0, settings.floorDecibels / 20);
    return (20 * (amplitudes.array() / reference).max (minimum).log10()).matrix();
}
} // namespace

Spectrogram spectrogram (const Eigen::Ref<const Eigen::VectorXd>& signal, double sampleRate,
                         const SpectrogramSettings& settings)
{
    requireUsable (sampleRate, settings);
    const auto window = amplitudeWindow (std::lround (settings.windowDuration * sampleRate));
    const auto length = transformLength (window.size());
    const auto spacing = sampleRate / static_cast<double> (length);
    const auto highest = settings.maximumFrequency > 0 ? settings.maximumFrequency : sampleRate / 2;
    const auto rows = std::min (length / 2, static_cast<Eigen::Index> (std::min (highest / spacing, 1e9))) + 1;

    Spectrogram result;
    const auto lastSample = static_cast<double> (std::max<Eigen::Index> (0, signal.size() - 1));
    const Eigen::VectorXd middles = Eigen::VectorXd::LinSpaced (settings.columns, 0, lastSample).array().round();
    result.times = middles / sampleRate;
    result.frequencies = Eigen::VectorXd::LinSpaced (rows, 0, static_cast<double> (rows - 1) * spacing);

    Eigen::FFT<double> transform (Eigen::FFT<double>::impl_type(), Eigen::FFT<double>::HalfSpectrum);
    Eigen::MatrixXd amplitudes (rows, settings.columns);
    std::vector<std::complex<double>> spectrum;
    for (Eigen::Index column = 0; column < amplitudes.cols(); ++column)
    {
        checkWatch();
        transform.fwd (spectrum, windowed (signal, window, static_cast<Eigen::Index> (middles[column]), length));
        for (Eigen::Index row = 0; row < rows; ++row)
            amplitudes (row, column) = std::abs (spectrum[static_cast<std::size_t> (row)]);
    }
    // A constant has one line where a sine has two.
    amplitudes.row (0) /= 2;
    result.decibels = toDecibels (amplitudes, settings);
    return result;
}
} // namespace antinode
