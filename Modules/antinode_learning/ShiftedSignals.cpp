#include "ShiftedSignals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr Eigen::Index edge = 128; // samples beside the end of a signal that is shifted by a part of a sample
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

    const auto turn = 2 * std::numbers::pi * delay * rate / static_cast<double> (length);
    const Eigen::VectorXcd turns = Eigen::VectorXcd::NullaryExpr (
        length / 2 + 1, [turn] (Eigen::Index k) { return std::polar (1.0, turn * static_cast<double> (k)); });
    shifted.resize (samples, spectra.cols());
    shiftedBy = delay;

    for (Eigen::Index m = 0; m < shifted.cols(); ++m)
        shifted.col (m) = tables.inverse (spectra.col (m).cwiseProduct (turns), length).head (samples);

    return shifted;
}

Eigen::MatrixXd signalsEarlier (const PlayedRecording& recording, double delay, Eigen::Index samples)
{
    return ShiftedSignals (recording).earlier (delay, samples);
}

Eigen::MatrixXd slopesOf (const Eigen::MatrixXd& rows, double sampleRate)
{
    constexpr double silence = 256; // samples, before the signal comes round again
    const auto length = quickLength (static_cast<double> (rows.cols()) + silence);
    const auto turn = 2 * std::numbers::pi * sampleRate / static_cast<double> (length);
    Eigen::MatrixXd slopes (rows.cols(), rows.rows());
    FourierTables tables;

    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
        auto spectrum = tables.forward (rows.row (i).transpose(), length);

        for (Eigen::Index k = 0; k < spectrum.size(); ++k)
            spectrum[k] *= std::complex<double> (0, turn * static_cast<double> (k));

        spectrum[spectrum.size() - 1] = 0; // of the Nyquist frequency samples know no slope
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
