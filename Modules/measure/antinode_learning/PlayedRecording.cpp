#include "PlayedRecording.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double transition = 0.25;      // of the highest frequency, until nothing is left, or up to half the rate
constexpr double sharpTransition = 0.05; // the same where unknown modes follow at once
constexpr double samplesPerPeriod = 2 * (1 + transition);

/** What a filter passes. */
struct Passband
{
    double highest = 0; ///< Hz
    double transition = 0.25;

    /** Hz: above the highest frequency, until nothing is left. */
    double fallWidth (double sampleRate) const { return std::min (transition * highest, sampleRate / 2 - highest); }

    /** Samples in which a voltage that is filtered rings, before and after it. */
    double ringing (double sampleRate) const { return 8 * sampleRate / (transition * highest); }
};

/** Samples of a rate for one of the lowest rate that holds a frequency. */
Eigen::Index stepFor (double sampleRate, double highest)
{
    return static_cast<Eigen::Index> (std::max (1.0, std::floor (sampleRate / (samplesPerPeriod * highest))));
}

/** Rows of samples, filtered and thinned. */
Eigen::MatrixXd thinned (const Eigen::MatrixXd& rows, double sampleRate, const Passband& band, Eigen::Index step)
{
    const auto beforeItComesRound = static_cast<double> (rows.cols()) + band.ringing (sampleRate);
    const auto few = quickLength (beforeItComesRound / static_cast<double> (step));
    const auto length = few * step;
    const auto lineWidth = sampleRate / static_cast<double> (length);
    const auto width = band.fallWidth (sampleRate);
    Eigen::MatrixXd result (rows.rows(), rows.cols() / step);
    FourierTables tables;

    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
        Eigen::VectorXcd spectrum = tables.forward (rows.row (i).transpose(), length).head (few / 2 + 1);

        for (Eigen::Index k = 0; k < spectrum.size(); ++k)
        {
            const auto beyond = (static_cast<double> (k) * lineWidth - band.highest) / width;
            const auto fall = beyond <= 0 ? 1.0 : beyond >= 1 ? 0.0 : (1 + std::cos (std::numbers::pi * beyond)) / 2;
            spectrum[k] *= fall / static_cast<double> (step);
        }

        result.row (i) = tables.inverse (spectrum, few).head (result.cols());
    }

    return result;
}

/** What of a recording lies below a frequency, every so many samples. */
PlayedRecording filtered (const PlayedRecording& recording, const Passband& passed, Eigen::Index step)
{
    const auto thin = [&] (const Eigen::MatrixXd& rows) { return thinned (rows, recording.sampleRate, passed, step); };
    const auto rate = recording.sampleRate / static_cast<double> (step);
    constexpr double powerOfFall = 3.0 / 8; // of what a raised cosine falls through
    const auto band = passed.highest + powerOfFall * passed.fallWidth (recording.sampleRate);
    return { rate,
             thin (recording.voltages),
             thin (recording.signals),
             recording.noise / std::sqrt (static_cast<double> (step)),
             recording.delay,
             recording.delaySpan,
             recording.bandShare * std::min (1.0, 2 * band / rate),
             thin (recording.cubes) };
}

Eigen::MatrixXd afterSilence (const Eigen::MatrixXd& rows, Eigen::Index silence)
{
    Eigen::MatrixXd later = Eigen::MatrixXd::Zero (rows.rows(), rows.cols() + silence);
    later.rightCols (rows.cols()) = rows;
    return later;
}

/** Filtered voltages ring for ever; they end where that is 1e-5 of the largest one. */
void endWhereInaudible (Eigen::MatrixXd& voltages)
{
    constexpr double inaudible = 1e-5;
    const auto least = inaudible * voltages.cwiseAbs().maxCoeff();

    for (auto end = voltages.cols(); end > 0 && voltages.col (end - 1).cwiseAbs().maxCoeff() < least; --end)
        voltages.col (end - 1).setZero();
}
} // namespace

PlayedRecording atLowerRate (const PlayedRecording& recording, double highest)
{
    if (! (highest > 0))
        throw InputError ("recording", "needs a highest frequency above 0");

    if (recording.sampleRate <= 2 * highest)
        return recording;

    return filtered (recording, { highest }, stepFor (recording.sampleRate, highest));
}

PlayedRecording withinModel (PlayedRecording recording, const WideModel& model)
{
    constexpr double aboveKnown = 1.05; // of the highest known frequency, which can be off by some percents
    constexpr double nothingBeyond = 1 / (1 + transition);
    constexpr Eigen::Index leastSamples = 50 * 128; // so that the 128 that are lost at the end are few
    const auto known = aboveKnown * model.model.frequencyHz (model.known - 1);
    const auto rate = recording.sampleRate;

    if (rate < samplesPerPeriod * known)
        return recording;

    const auto step = std::clamp<Eigen::Index> (recording.voltages.cols() / leastSamples, 1, stepFor (rate, known));
    const auto held = rate / (samplesPerPeriod * static_cast<double> (step));
    // A surface has modes right above those that were measured.
    const auto passed = model.model.modes() > model.known
                            ? Passband { std::max (known, std::min (nothingBeyond * model.highestFrequency(), held)) }
                            : Passband { known / aboveKnown, sharpTransition };
    const auto silence = static_cast<Eigen::Index> (std::ceil (passed.ringing (rate)));
    recording.voltages = afterSilence (recording.voltages, silence);
    recording.signals = afterSilence (recording.signals, silence);
    recording.cubes = afterSilence (recording.cubes, silence);
    recording = filtered (recording, passed, step);
    endWhereInaudible (recording.voltages);
    return recording;
}

double highestModelled (const ModalModel& model)
{
    constexpr double share = 0.95;
    return share * model.frequencyHz (model.modes() - 1);
}

ModalModel modesWithin (const ModalModel& model, double sampleRate)
{
    constexpr double share = 0.45;
    Eigen::Index count = 0;

    while (count < model.modes() && model.frequencyHz (count) < share * sampleRate)
        ++count;

    if (count == 0)
        throw InputError ("recording", "has a sample rate below that of the lowest mode of '" + model.name + "'");

    return firstModes (model, count);
}

double usualFeedthrough (const ModalModel& model, const std::vector<Sensor>& sensors)
{
    const auto upper = (model.modes() + 1) / 2;
    const Eigen::VectorXd compliances = model.angularFrequencies.tail (upper).cwiseAbs2().cwiseInverse();
    double largest = 0;

    for (const auto& sensor : sensors)
        largest = std::max (largest, (sensor.shapes.tail (upper).transpose().cwiseProduct (compliances).transpose()
                                      * model.participation.bottomRows (upper))
                                         .cwiseAbs()
                                         .maxCoeff());

    return largest;
}

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
