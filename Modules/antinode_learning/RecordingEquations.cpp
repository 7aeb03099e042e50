#include "RecordingEquations.h"

#include "ParameterEffects.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

namespace antinode
{
namespace
{
const PlayedRecording& recordingOf (const LearningPrior& prior, Eigen::Index r)
{
    return prior.recordings[static_cast<std::size_t> (r)];
}

/** What sensors hear of the velocities or changes of all modes: samples x N. */
Eigen::MatrixXd heardBy (const Eigen::MatrixXd& sensors, const Histories& histories, const Eigen::VectorXcd& logarithms,
                         Eigen::Index samples)
{
    const auto driven = histories.driven.rows();
    Eigen::MatrixXd heard = Eigen::MatrixXd::Zero (samples, sensors.rows());
    addTransposedRight (heard.topRows (driven), 1, histories.driven, sensors);

    const auto parts = histories.parts();
    Eigen::MatrixXd weights (4 * parts.cols(), sensors.rows());

    for (Eigen::Index k = 0; k < parts.cols(); ++k)
        weights.middleRows<4> (4 * k) = parts.col (k) * sensors.col (k).transpose();

    forEachDecayPart (logarithms, samples - driven,
                      [&] (const DecayPart& part)
                      {
                          const Eigen::MatrixXd some = weights (part.columns, Eigen::all);
                          addProduct (heard.middleRows (driven + part.first, part.basis.rows()), 1, part.basis, some);
                      });
    return heard;
}

RecordingMisfit misfitOf (const Eigen::MatrixXd& residual, const Eigen::MatrixXd& signals,
                          const PlayedRecording& recording)
{
    const Eigen::VectorXd precision = recording.noise.cwiseAbs2().cwiseInverse(); // N
    const auto weighed = [&precision] (const Eigen::MatrixXd& values)
    { return (values.cwiseAbs2().colwise().sum() * precision).value(); };
    return { weighed (residual), weighed (signals), recording.bandShare * static_cast<double> (residual.size()) };
}
} // namespace

RecordingEquations recordingEquations (const LearningPrior& prior, const LearningParameters& parameters,
                                       const LearningState& state, Eigen::Index r, Eigen::Index samples)
{
    checkWatch();
    const auto& recording = recordingOf (prior, r);
    const auto& voltages = prior.voltages[static_cast<std::size_t> (r)];
    const auto motions = driveModes (state.model, voltages, samples);
    const auto logarithms = decayLogarithms (state.model, voltages.sampleRate());
    const auto effects = parameterEffects (prior, parameters, state, voltages, motions, samples);
    const Eigen::VectorXd precision = recording.noise.cwiseAbs2().cwiseInverse();
    const auto heard = heardBy (state.sensors, motions.velocity, logarithms, samples);
    auto& recorded = *prior.signals[static_cast<std::size_t> (r)];
    const auto& signals = recorded.earlier (state.delays[r], samples);
    const Eigen::MatrixXd residual = signals - heard;
    const auto modal = parameters.drift();
    const auto sensors = state.sensors.rows();

    // What all modes share reaches every sensor in its own form.
    const Eigen::MatrixXd byDrift =
        prior.deviations.drift * heardBy (state.sensors, motions.byFrequency, logarithms, samples);
    // A longer delay moves the signals, not the prediction. The matrix has the slopes of the latter, which have no
    // noise.
    const Eigen::MatrixXd byDelay = -prior.deviations.delay * slopesOf (heard.transpose(), recording.sampleRate);
    const Eigen::MatrixXd signalsByDelay = -prior.deviations.delay * recorded.slopesEarlier (state.delays[r], samples);
    Eigen::MatrixXd against (samples, 3 * sensors);
    against << residual, byDrift, byDelay;
    RecordingEquations equations { Eigen::MatrixXd::Zero (parameters.size(), parameters.size()), {}, {} };
    equations.right = Eigen::VectorXd::Zero (parameters.size());
    const Eigen::MatrixXd weighted = precision.asDiagonal() * effects.weights;
    const auto products = productsWith (effects, logarithms, against);
    const auto summed = [&] (Eigen::Index part) -> Eigen::VectorXd
    { return products.middleCols (part * sensors, sensors).cwiseProduct (weighted.transpose()).rowwise().sum(); };
    const auto product = [&] (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
    { return (a.cwiseProduct (b).colwise().sum() * precision).value(); };
    const auto drift = parameters.drift(), delay = parameters.delay (r);
    equations.right.head (modal) = summed (0);
    equations.right[drift] = product (byDrift, residual);
    equations.right[delay] = product (signalsByDelay, residual);

    auto& matrix = equations.matrix;
    takeGram (effects, weighted, logarithms, samples, matrix.topLeftCorner (modal, modal));
    matrix.row (drift).head (modal) = summed (1).transpose();
    matrix.row (delay).head (modal) = summed (2).transpose();
    matrix (drift, drift) = product (byDrift, byDrift);
    matrix (delay, delay) = product (byDelay, byDelay);
    matrix (delay, drift) = product (byDelay, byDrift);
    equations.misfit = misfitOf (residual, signals, recording);
    return equations;
}

RecordingMisfit recordingMisfit (const LearningPrior& prior, const LearningState& state, Eigen::Index r,
                                 Eigen::Index samples)
{
    checkWatch();
    const auto& recording = recordingOf (prior, r);
    const auto& voltages = prior.voltages[static_cast<std::size_t> (r)];
    const auto heard = heardBy (state.sensors, modeHistories (state.model, voltages, samples),
                                decayLogarithms (state.model, voltages.sampleRate()), samples);
    const auto& signals = prior.signals[static_cast<std::size_t> (r)]->earlier (state.delays[r], samples);
    return misfitOf (signals - heard, signals, recording);
}
} // namespace antinode
