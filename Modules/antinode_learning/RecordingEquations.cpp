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

/** The change from sample to sample per second, by central differences. */
Eigen::MatrixXd derivative (const Eigen::MatrixXd& signals, double sampleRate)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (signals.rows(), signals.cols());
    const auto inner = signals.rows() - 2;

    if (inner > 0)
        result.middleRows (1, inner) = (signals.bottomRows (inner) - signals.topRows (inner)) * (sampleRate / 2);

    return result;
}
} // namespace

RecordingEquations recordingEquations (const LearningPrior& prior, const LearningParameters& parameters,
                                       const LearningState& state, Eigen::Index r, Eigen::Index samples,
                                       bool withMatrix)
{
    checkWatch();
    const auto& recording = recordingOf (prior, r);
    const auto& voltages = prior.voltages[static_cast<std::size_t> (r)];
    const auto motions = driveModes (state.model, voltages, samples);
    const auto logarithms = decayLogarithms (state.model, voltages.sampleRate());
    const auto effects = parameterEffects (prior, parameters, state, voltages, motions, samples);
    const Eigen::VectorXd precision = recording.noise.cwiseAbs2().cwiseInverse();
    const auto heard = heardBy (state.sensors, motions.velocity, logarithms, samples);
    const auto& signals = prior.signals[static_cast<std::size_t> (r)]->earlier (state.delays[r], samples);
    const Eigen::MatrixXd residual = signals - heard;
    const auto modal = parameters.drift();
    const auto sensors = state.sensors.rows();

    // What all modes share reaches every sensor in its own form.
    const Eigen::MatrixXd byDrift =
        prior.deviations.drift * heardBy (state.sensors, motions.byFrequency, logarithms, samples);
    const Eigen::MatrixXd byDelay = -prior.deviations.delay * derivative (heard, recording.sampleRate);
    Eigen::MatrixXd against (samples, (withMatrix ? 3 : 1) * sensors);
    against.leftCols (sensors) = residual;

    if (withMatrix)
        against.rightCols (2 * sensors) << byDrift, byDelay;

    RecordingEquations equations;
    equations.right = Eigen::VectorXd::Zero (parameters.size());
    const Eigen::MatrixXd weighted = precision.asDiagonal() * effects.weights;
    const auto products = productsWith (effects, logarithms, against);
    const auto summed = [&] (Eigen::Index part) -> Eigen::VectorXd
    { return products.middleCols (part * sensors, sensors).cwiseProduct (weighted.transpose()).rowwise().sum(); };
    const auto product = [&] (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
    { return (a.cwiseProduct (b).colwise().sum() * precision).value(); };
    // The residual is that of signals that were shifted back: a longer delay moves them, not the prediction.
    const auto drift = parameters.drift(), delay = parameters.delay (r);
    equations.right.head (modal) = summed (0);
    equations.right[drift] = product (byDrift, residual);
    equations.right[delay] = product (byDelay, residual);

    if (withMatrix)
    {
        equations.matrix = Eigen::MatrixXd::Zero (parameters.size(), parameters.size());
        takeGram (effects, weighted, logarithms, samples, equations.matrix.topLeftCorner (modal, modal));
        equations.matrix.row (drift).head (modal) = summed (1).transpose();
        equations.matrix.row (delay).head (modal) = summed (2).transpose();
        equations.matrix (drift, drift) = product (byDrift, byDrift);
        equations.matrix (delay, delay) = product (byDelay, byDelay);
        equations.matrix (delay, drift) = product (byDelay, byDrift);
    }

    equations.misfit = product (residual, residual);
    equations.signal = product (signals, signals);
    equations.samples = static_cast<double> (residual.size());
    return equations;
}

double recordingMisfit (const LearningPrior& prior, const LearningState& state, Eigen::Index r, Eigen::Index samples)
{
    checkWatch();
    const auto& recording = recordingOf (prior, r);
    const auto& voltages = prior.voltages[static_cast<std::size_t> (r)];
    const auto heard = heardBy (state.sensors, modeHistories (state.model, voltages, samples),
                                decayLogarithms (state.model, voltages.sampleRate()), samples);
    const auto& signals = prior.signals[static_cast<std::size_t> (r)]->earlier (state.delays[r], samples);
    return ((signals - heard).cwiseAbs2().colwise().sum() * recording.noise.cwiseAbs2().cwiseInverse()).value();
}
} // namespace antinode
