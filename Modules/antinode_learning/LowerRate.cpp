#include "LowerRate.h"

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
constexpr double transition = 0.25; // of the highest frequency, until nothing is left, or up to half the rate
constexpr double samplesPerPeriod = 2 * (1 + transition);

/** Rows of samples, filtered and thinned. */
Eigen::MatrixXd thinned (const Eigen::MatrixXd& rows, double sampleRate, double highest, Eigen::Index step)
{
    const auto ringing = 8 * sampleRate / (transition * highest); // samples, before the signal comes round again
    const auto few = quickLength ((static_cast<double> (rows.cols()) + ringing) / static_cast<double> (step));
    const auto length = few * step;
    const auto lineWidth = sampleRate / static_cast<double> (length);
    const auto fallWidth = std::min (transition * highest, sampleRate / 2 - highest);
    Eigen::MatrixXd result (rows.rows(), rows.cols() / step);
    FourierTables tables;

    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
        Eigen::VectorXcd spectrum = tables.forward (rows.row (i).transpose(), length).head (few / 2 + 1);

        for (Eigen::Index k = 0; k < spectrum.size(); ++k)
        {
            const auto beyond = (static_cast<double> (k) * lineWidth - highest) / fallWidth;
            const auto fall = beyond <= 0 ? 1.0 : beyond >= 1 ? 0.0 : (1 + std::cos (std::numbers::pi * beyond)) / 2;
            spectrum[k] *= fall / static_cast<double> (step);
        }

        result.row (i) = tables.inverse (spectrum, few).head (result.cols());
    }

    return result;
}
} // namespace

PlayedRecording atLowerRate (const PlayedRecording& recording, double highest)
{
    if (! (highest > 0))
        throw InputError ("recording", "needs a highest frequency above 0");

    if (recording.sampleRate <= 2 * highest)
        return recording;

    const auto step =
        static_cast<Eigen::Index> (std::max (1.0, std::floor (recording.sampleRate / (samplesPerPeriod * highest))));
    const auto thin = [&] (const Eigen::MatrixXd& rows) { return thinned (rows, recording.sampleRate, highest, step); };
    return { recording.sampleRate / static_cast<double> (step), thin (recording.voltages), thin (recording.signals),
             recording.noise / std::sqrt (static_cast<double> (step)), recording.delay };
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
} // namespace antinode
