#include "PlayedTracks.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_tracks/TouchedNodes.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>

namespace antinode
{
PlayedTracks playTracks (const ModalModel& model, const WaveformsDescription& description,
                         const SampledVoltages& voltages, double ringing)
{
    constexpr double enoughForSkin = 12000; // Hz
    const auto paths = pathShapes (model, description);
    auto pointShapes = touchedShapes (model, description);
    PlateModel plate (model, voltages.playback, pointShapes);
    const auto rate = voltages.playback.sampleRate;
    const auto count = voltages.values.cols() + static_cast<Eigen::Index> (std::ceil (ringing * rate));
    const auto stride = std::max<Eigen::Index> (1, static_cast<Eigen::Index> (rate / enoughForSkin));
    PlayedTracks played {
        rate, std::llround (-voltages.firstTime * rate), {}, rate / static_cast<double> (stride), {}
    };
    played.displacements.resize (pointShapes.rows(), count);
    played.modalVelocities.resize (model.coordinates(), (count - 1) / stride + 1);
    const Eigen::VectorXd silence = Eigen::VectorXd::Zero (voltages.values.rows());
    Eigen::VectorXd velocities (pointShapes.rows());

    for (Eigen::Index n = 0; n < count + plate.latencySamples(); ++n)
    {
        checkWatch();

        if (n < voltages.values.cols())
            plate.process (voltages.values.col (n), velocities);
        else
            plate.process (silence, velocities);

        if (const auto at = n - plate.latencySamples(); at >= 0)
        {
            for (std::size_t p = 0; p < paths.size(); ++p)
                if (paths[p].moves())
                    pointShapes.row (static_cast<Eigen::Index> (p)) =
                        paths[p].at (static_cast<double> (at) / rate + voltages.firstTime).transpose();

            played.displacements.col (at) = pointShapes * plate.modalDisplacements();

            if (at % stride == 0)
                played.modalVelocities.col (at / stride) = plate.modalVelocities();
        }
    }

    return played;
}

namespace
{
constexpr double leastRatio = 1e-10; // -200 dB

double toDecibels (double ratio)
{
    return 20 * std::log10 (std::max (ratio, leastRatio));
}

/** The root of the mean square of what a signal has between two frequencies. */
double rmsWithin (const Eigen::VectorXd& signal, double sampleRate, TrackBand band)
{
    const auto length = quickLength (2 * static_cast<double> (signal.size()));
    const auto spectrum = forwardFourier (signal, length);
    double energy = 0;

    for (Eigen::Index k = 1; k < spectrum.size(); ++k)
        if (const auto frequency = static_cast<double> (k) * sampleRate / static_cast<double> (length);
            frequency >= band.lower && frequency <= band.upper)
            energy += 2 * std::norm (spectrum[k]);

    return std::sqrt (energy / static_cast<double> (length) / static_cast<double> (signal.size()));
}
} // namespace

double TrackScores::suppression (std::size_t finger) const
{
    return toDecibels (fingers[finger].errorRms / strongestRms);
}

double TrackScores::wideSuppression (std::size_t finger) const
{
    return toDecibels (fingers[finger].wideErrorRms / strongestRms);
}

double TrackScores::normalisedError (std::size_t finger) const
{
    return std::pow (fingers[finger].errorRms / fingers[finger].wantedRms, 2);
}

TrackScores scoreTracks (const PlayedTracks& played, const Eigen::MatrixXd& wanted, TrackBand band)
{
    TrackScores scores;

    for (Eigen::Index p = 0; p < wanted.cols(); ++p)
    {
        const Eigen::VectorXd reached = played.displacements.row (p).transpose();
        Eigen::VectorXd asked = Eigen::VectorXd::Zero (reached.size());
        const auto begin = std::min<Eigen::Index> (played.trigger, asked.size());
        const auto count = std::min (wanted.rows(), asked.size() - begin);
        asked.segment (begin, count) = wanted.col (p).head (count);
        const Eigen::VectorXd error = reached - asked;
        FingerScore score;
        score.wantedPeak = asked.cwiseAbs().maxCoeff();
        score.reachedPeak = reached.cwiseAbs().maxCoeff();
        score.wantedRms = rmsWithin (asked, played.sampleRate, band);
        score.errorRms = rmsWithin (error, played.sampleRate, band);
        score.wideErrorRms = error.norm() / std::sqrt (static_cast<double> (error.size()));
        scores.strongestRms = std::max (scores.strongestRms, score.wantedRms);
        scores.fingers.push_back (score);
    }

    return scores;
}

TrackAlignment alignTracks (const Eigen::MatrixXd& reached, const Eigen::MatrixXd& wanted)
{
    // As long as both: no end of a signal meets the beginning of the other.
    const auto length = quickLength (static_cast<double> (reached.cols() + wanted.rows()));
    Eigen::VectorXcd products = Eigen::VectorXcd::Zero (length / 2 + 1);

    for (Eigen::Index p = 0; p < wanted.cols(); ++p)
    {
        checkWatch();
        const Eigen::VectorXd motion = reached.row (p).transpose(), asked = wanted.col (p);
        products += forwardFourier (motion, length).cwiseProduct (forwardFourier (asked, length).conjugate());
    }

    const Eigen::VectorXd correlation = inverseFourier (products, length).head (reached.cols());
    TrackAlignment found;
    const auto largest = correlation.maxCoeff (&found.begin);
    found.likeness = largest / (reached.norm() * wanted.norm() + std::numeric_limits<double>::min());
    return found;
}

namespace
{
constexpr double untilSilence = 2.2; // s: what ends before the model has rung out could not be designed
constexpr double largestError = 20;  // dB: beyond, a recording is not one of the pass

void requirePass (const RecordedPass& pass, std::size_t number, const ModalModel& known, std::size_t points,
                  double sampleRate)
{
    const auto where = "recorded pass " + std::to_string (number);

    if (static_cast<std::size_t> (pass.displacements.rows()) != points)
        throw InputError (where, "has " + std::to_string (pass.displacements.rows()) + " channels; allowed: "
                                     + std::to_string (points) + ", one per finger, those with tracks first");

    if (pass.voltages.values.rows() != known.actuators())
        throw InputError (where, "was played on " + std::to_string (pass.voltages.values.rows())
                                     + " ceramics, the device has " + std::to_string (known.actuators()));

    if (pass.voltages.playback.sampleRate != sampleRate)
        throw InputError (where, "was played at " + inWords (pass.voltages.playback.sampleRate)
                                     + " Hz; allowed: the rate of the design, " + inWords (sampleRate) + " Hz");

    if (! pass.displacements.allFinite() || ! pass.voltages.values.allFinite())
        throw InputError (where, "has samples that are not finite; allowed: numbers");

    if (pass.displacements.cols() < pass.voltages.values.cols())
        throw InputError (where, "has " + std::to_string (pass.displacements.cols())
                                     + " samples; allowed: " + std::to_string (pass.voltages.values.cols())
                                     + " or more, as many as its voltages.wav");
}

/** The fingers that the design knows of. */
std::vector<Finger> knownFingers (const WaveformsDescription& description)
{
    std::vector<Finger> fingers;

    for (const auto& point : touchedPoints (description))
        if (point.finger && point.finger->isKnown)
            fingers.push_back (*point.finger);

    return fingers;
}

PlayedTracks asPlayed (const RecordedPass& pass)
{
    PlayedTracks played;
    played.sampleRate = pass.voltages.playback.sampleRate;
    played.trigger = std::llround (-pass.voltages.firstTime * played.sampleRate);
    played.displacements = pass.displacements;
    return played;
}

/** The error of the worst finger, dB. */
double worstError (const TrackScores& scores)
{
    auto worst = scores.suppression (0);

    for (std::size_t p = 1; p < scores.fingers.size(); ++p)
        worst = std::max (worst, scores.suppression (p));

    return worst;
}
} // namespace

void requirePasses (const std::vector<RecordedPass>& passes, const ModalModel& known,
                    const WaveformsDescription& description, double sampleRate)
{
    for (std::size_t i = 0; i < passes.size(); ++i)
        requirePass (passes[i], i + 1, known, touchedPoints (description).size(), sampleRate);
}

Eigen::MatrixXd predictedDisplacements (const ModalModel& known, const WaveformsDescription& description,
                                        const SampledVoltages& voltages, double ringing)
{
    const auto fingers = knownFingers (description);
    const auto loaded = fingers.empty() ? known : loadedModel (known, fingers);
    return playTracks (loaded, description, voltages, ringing).displacements;
}

TrackCorrection correctionFrom (const ModalModel& known, const WaveformsDescription& description,
                                const TrackSettings& settings, const std::vector<RecordedPass>& passes)
{
    const auto wanted = wantedAsPlayed (known, description, settings);
    TrackCorrection correction;

    requirePasses (passes, known, description, settings.sampleRate);

    for (const auto& pass : passes)
    {
        correction.latencies.push_back (pass.latency);
        correction.errors.push_back (worstError (scoreTracks (asPlayed (pass), wanted, description.band)));

        if (! (correction.errors.back() < largestError))
            throw InputError ("recorded pass " + std::to_string (correction.errors.size()),
                              "is " + inWords (correction.errors.back())
                                  + " dB over what is wanted at the worst finger; allowed: less than "
                                  + inWords (largestError) + " dB; check unit, sensitivity and order of the channels");
    }

    const auto best = std::min_element (correction.errors.begin(), correction.errors.end());
    correction.best = static_cast<std::size_t> (best - correction.errors.begin());
    correction.gain = std::pow (0.5, correction.errors.end() - best - 1);
    const auto& pass = passes[correction.best];

    correction.shift.predicted = predictedDisplacements (known, description, pass.voltages, untilSilence).transpose();
    auto& missing = correction.shift.missing;
    missing = -pass.displacements.transpose();
    const auto trigger = std::min<Eigen::Index> (asPlayed (pass).trigger, missing.rows());
    const auto count = std::min (wanted.rows(), missing.rows() - trigger);
    missing.middleRows (trigger, count) += wanted.topRows (count);
    missing *= correction.gain;
    correction.shift.firstTime = pass.voltages.firstTime;
    return correction;
}

Eigen::MatrixXd displacementsOf (const Eigen::MatrixXd& velocities, double sampleRate, TrackBand band)
{
    constexpr double belowBand = 0.25;
    const auto length = quickLength (2 * static_cast<double> (velocities.cols()));
    Eigen::MatrixXd displacements (velocities.rows(), velocities.cols());

    for (Eigen::Index p = 0; p < velocities.rows(); ++p)
    {
        auto lines = forwardFourier (velocities.row (p).transpose(), length);

        for (Eigen::Index k = 0; k < lines.size(); ++k)
        {
            const auto frequency = static_cast<double> (k) * sampleRate / static_cast<double> (length);
            lines[k] = frequency < belowBand * band.lower
                           ? 0
                           : lines[k] / std::complex (0.0, 2 * std::numbers::pi * frequency);
        }

        displacements.row (p) = inverseFourier (lines, length).head (velocities.cols()).transpose();
    }

    return displacements;
}
} // namespace antinode
