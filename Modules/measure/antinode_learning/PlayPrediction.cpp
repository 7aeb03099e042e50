#include "PlayPrediction.h"

#include "LikelyDelays.h"
#include "RecordingEquations.h"

#include <antinode_numerics/Median.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** What sensors would hear without delay until the voltages end: samples x N. Later phases of a model that is off are
    no help to find a delay. */
Eigen::MatrixXd predictedWhilePlayed (const ModalModel& model, const std::vector<Sensor>& sensors,
                                      const PlayedRecording& recording)
{
    const PlayedVoltages voltages (recording.voltages, recording.sampleRate);
    const auto velocities = modeVelocities (model, voltages, voltages.drivenSamples());
    Eigen::MatrixXd signals (velocities.rows(), std::ssize (sensors));

    for (std::size_t m = 0; m < sensors.size(); ++m)
        signals.col (static_cast<Eigen::Index> (m)) = velocities * sensors[m].shapes.transpose();

    return signals;
}

LearningState stateOf (const LearntModes& device, const LearningPrior& prior, const LearningParameters& delayOnly,
                       double delay)
{
    auto state = stateAt (prior, delayOnly, Eigen::VectorXd::Zero (delayOnly.size()));
    state.distortions = device.distortions;
    state.delays[0] = delay;
    return state;
}

/** s: one step of Gauss and Newton's method to the delay that suits a device best, within what a recording may have and
    a sample, where the misfit is a parabola. A delay that is known has a deviation too. */
double betterDelay (const LearningPrior& prior, const LearningParameters& delayOnly, const LearningState& state,
                    const PlayedRecording& recording)
{
    const auto samples = comparableSamples (prior.recordings.front());
    const auto equations = recordingEquations (prior, delayOnly, state, 0, samples);
    const auto place = delayOnly.delay (0);
    const auto curvature = equations.matrix (place, place), delay = state.delays[0];

    if (! (curvature > 0))
        return delay;

    constexpr double farthest = 4; // deviations
    const auto deviation = prior.deviations.delay;
    const auto sample = 1 / recording.sampleRate;
    const auto change = deviation * equations.right[place] / curvature;
    return std::clamp (delay + std::clamp (change, -sample, sample),
                       std::max (0.0, recording.delay - farthest * deviation),
                       recording.delay + recording.delaySpan + farthest * deviation);
}
} // namespace

double loudnessOf (const ModalModel& model, const std::vector<Sensor>& sensors, const PlayedRecording& recording)
{
    const auto predicted = predictedWhilePlayed (model, sensors, recording);
    const auto latest = (recording.delay + recording.delaySpan) * recording.sampleRate;
    const auto samples =
        std::min (recording.signals.cols(), predicted.rows() + static_cast<Eigen::Index> (std::ceil (latest)));
    const Eigen::VectorXd heard = recording.signals.leftCols (samples).rowwise().norm();
    const Eigen::VectorXd ratios = heard.array() / predicted.colwise().norm().transpose().array().max (1e-300);
    return median ({ ratios.begin(), ratios.end() });
}

ModalModel meanModel (ModalModel model, const Eigen::VectorXd& frequencyDeviations)
{
    model.dampingRatios += frequencyDeviations;
    return model;
}

std::vector<double> delaysBy (const ModalModel& model, const std::vector<Sensor>& sensors,
                              const PlayedRecording& recording, std::size_t most)
{
    if (! (recording.delaySpan > 0))
        return { recording.delay };

    return likelyDelays (recording, predictedWhilePlayed (model, sensors, recording), most);
}

PlayedRecording withDelay (PlayedRecording recording, double delay)
{
    recording.delay = delay;
    recording.delaySpan = 0;
    return recording;
}

// From the most likely delay by a few steps: a microsecond is much for high modes.
double surprise (const LearntModes& device, const ModeSpread& deviations, const PlayedRecording& recording)
{
    constexpr int mostSteps = 3;
    auto delay = delaysBy (device.model, device.sensors, recording, 1).front();
    const std::vector<PlayedRecording> one { withDelay (recording, delay) };
    const auto prior = makePrior (device.model, device.sensors, deviations, one);
    LearningParameters delayOnly;
    delayOnly.delays = 1;
    const auto misfit = [&] (double by)
    {
        const auto sum =
            recordingMisfit (prior, stateOf (device, prior, delayOnly, by), 0, comparableSamples (one.front()));
        return std::sqrt (sum.residual / sum.samples);
    };
    auto least = misfit (delay);

    for (int i = 0; i < mostSteps; ++i)
    {
        const auto next = betterDelay (prior, delayOnly, stateOf (device, prior, delayOnly, delay), recording);
        const auto reached = misfit (next);

        if (! (reached < least))
            break;

        least = reached;
        delay = next;
    }

    return least;
}
} // namespace antinode
