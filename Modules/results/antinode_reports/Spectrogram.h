#pragma once

#include <Eigen/Core>

namespace antinode
{
/** The settings of a spectrogram. */
struct SpectrogramSettings
{
    double windowDuration = 4e-3; ///< s, of the Hann window: two tones 2 / windowDuration Hz apart are distinguished.
    int columns = 400;            ///< Instants, evenly over the signal: its first sample to its last, 1 or more.
    double maximumFrequency = 0;  ///< Hz; 0 for half of the sample rate.
    double reference = 0;         ///< Amplitude of 0 dB in the unit of the signal; 0 for the largest one found.
    double floorDecibels = -80;   ///< Nothing lies below; less than 0.
};

/** The level of a signal over time and frequency. */
struct Spectrogram
{
    Eigen::MatrixXd decibels;    ///< A row for each frequency from 0 up, a column for each instant; dB.
    Eigen::VectorXd times;       ///< s from the first sample: where the window's middle stands.
    Eigen::VectorXd frequencies; ///< Hz
};

/** The short-time Fourier transform of a signal as an amplitude spectrum: a sine of amplitude A reads A on its line, at
   most 0.4 dB less where the line lies between two frequencies. Before and after the signal there is silence.
    @param signal      any unit; samples that are not finite count as 0
    @param sampleRate  Hz, more than 0
    @throws InputError  where a setting is not usable
    [worker] Docs/Theory.md, section 5; paper, Fig. 15. */
Spectrogram spectrogram (const Eigen::Ref<const Eigen::VectorXd>& signal, double sampleRate,
                         const SpectrogramSettings& = {});
} // namespace antinode
