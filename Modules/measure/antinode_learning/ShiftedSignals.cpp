#include "ShiftedSignals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr Eigen::Index edge = 128; // samples beside the end of a signal that is shifted by a part of a sample

/** The lines of a signal to those of its slope, of signals of a length. */
void takeSlope (Eigen::VectorXcd& lines, double sampleRate, Eigen::Index length)
{
    const auto step = 2 * std::numbers::pi * sampleRate / static_cast<double> (length); // rad/s from line to line

    for (Eigen::Index k = 0; k < lines.size(); ++k)
        lines[k] *= std::complex<double> (0, step * static_cast<double> (k));

    lines[lines.size() - 1] = 0; // of the Nyquist frequency samples know no slope
}
} // namespace

ShiftedSignals::ShiftedSignals (const PlayedRecording& recording)
    : rate (recording.sampleRate),
      length (quickLength (static_cast<double> (recording.signals.cols() + 2 * edge) + recording.delay * rate)),
      spectra (length / 2 + 1, recording.signals.rows())
{
    for (Eigen::Index m = 0; m < spectra.cols(); ++m)
        spectra.col (m) = tables.forward (recording.signals.row (m).transpose(), length);
}

const Eigen::MatrixXd& ShiftedSignals::earlier (double delay, Eigen::Index samples)
{
    if (delay == shiftedBy && samples == shifted.rows())
        return shifted;

    shifted = filtered (turnsOf (delay), samples);
    shiftedBy = delay;
    return shifted;
}

Eigen::MatrixXd ShiftedSignals::slopesEarlier (double delay, Eigen::Index samples)
{
    Eigen::VectorXcd factors = turnsOf (delay);
    takeSlope (factors, rate, length);
    return filtered (factors, samples);
}

Eigen::VectorXcd ShiftedSignals::turnsOf (double delay) const
{
    const auto turn = 2 * std::numbers::pi * delay * rate / static_cast<double> (length);
    return Eigen::VectorXcd::NullaryExpr (length / 2 + 1, [turn] (Eigen::Index k)
                                          { return std::polar (1.0, turn * static_cast<double> (k)); });
}

Eigen::MatrixXd ShiftedSignals::filtered (const Eigen::VectorXcd& factors, Eigen::Index samples)
{
    Eigen::MatrixXd signals (samples, spectra.cols());

    for (Eigen::Index m = 0; m < signals.cols(); ++m)
        signals.col (m) = tables.inverse (spectra.col (m).cwiseProduct (factors), length).head (samples);

    return signals;
}

Eigen::MatrixXd signalsEarlier (const PlayedRecording& recording, double delay, Eigen::Index samples)
{
    return ShiftedSignals (recording).earlier (delay, samples);
}

Eigen::MatrixXd slopesOf (const Eigen::MatrixXd& rows, double sampleRate)
{
    constexpr double silence = 256; // samples, before the signal comes round again
    const auto length = quickLength (static_cast<double> (rows.cols()) + silence);
    Eigen::MatrixXd slopes (rows.cols(), rows.rows());
    FourierTables tables;

    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
        auto spectrum = tables.forward (rows.row (i).transpose(), length);
        takeSlope (spectrum, sampleRate, length);
        slopes.col (i) = tables.inverse (spectrum, length).head (rows.cols());
    }

    return slopes;
}

Eigen::Index comparableSamples (const PlayedRecording& recording)
{
    const auto late = static_cast<Eigen::Index> (std::ceil (recording.delay * recording.sampleRate)) + edge;
    return std::max<Eigen::Index> (1, recording.voltages.cols() - late);
}
} // namespace antinode
