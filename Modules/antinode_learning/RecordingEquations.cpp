#include "RecordingEquations.h"

#include "ShiftedSignals.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
const PlayedRecording& recordingOf (const LearningPrior& prior, Eigen::Index r)
{
    return prior.recordings[static_cast<std::size_t> (r)];
}

/** The motions of all modes, N_s x N_m each. */
struct ModalChanges
{
    Eigen::MatrixXd velocities, byFrequency, byDamping;
};

ModalChanges changes (const ModalModel& model, const PlayedVoltages& voltages, Eigen::Index samples)
{
    ModalChanges result { Eigen::MatrixXd (samples, model.modes()), Eigen::MatrixXd (samples, model.modes()),
                          Eigen::MatrixXd (samples, model.modes()) };
    parallelFor (static_cast<std::size_t> (model.modes()),
                 [&] (std::size_t mode)
                 {
                     const auto k = static_cast<Eigen::Index> (mode);
                     auto motion = modeMotion (model.angularFrequencies[k], model.dampingRatios[k],
                                               voltages.force (model.participation.row (k)), voltages.sampleRate(),
                                               samples, true);
                     result.velocities.col (k) = motion.velocity;
                     result.byFrequency.col (k) = motion.byFrequency;
                     result.byDamping.col (k) = motion.byDamping;
                 });
    return result;
}

/** Every modal parameter's effect: a history in time, and how much of it each sensor hears. */
struct Effects
{
    Eigen::MatrixXd histories; ///< N_s x P
    Eigen::MatrixXd weights;   ///< N x P
};

/** The history of a parameter's effect. */
Eigen::VectorXd history (const LearningPrior& prior, const LearningParameter& parameter, const LearningState& state,
                         const PlayedVoltages& voltages, const ModalChanges& change)
{
    const auto k = parameter.mode;

    switch (parameter.kind)
    {
        case ParameterKind::frequency:
            return prior.deviations.frequencies[k] * change.byFrequency.col (k);

        case ParameterKind::damping:
            return prior.deviations.dampings[k] * change.byDamping.col (k);

        case ParameterKind::participation:
            return modeMotion (state.model.angularFrequencies[k], state.model.dampingRatios[k],
                               voltages.force (
                                   prior.deviations.participation[k]
                                   * prior.model.participation.row (k).cwiseProduct (parameter.ceramics.transpose())),
                               voltages.sampleRate(), change.velocities.rows(), false)
                .velocity;

        case ParameterKind::sensor:
            break;
    }

    return prior.sensors[static_cast<std::size_t> (parameter.sensor)].deviation * change.velocities.col (k);
}

Effects effectsOf (const LearningPrior& prior, const LearningParameters& parameters, const LearningState& state,
                   const PlayedVoltages& voltages, const ModalChanges& change)
{
    const auto count = parameters.modal.size();
    Effects effects { Eigen::MatrixXd (change.velocities.rows(), parameters.drift()),
                      Eigen::MatrixXd (state.sensors.rows(), parameters.drift()) };
    parallelFor (count,
                 [&] (std::size_t index)
                 {
                     const auto p = static_cast<Eigen::Index> (index);
                     const auto& parameter = parameters.modal[index];
                     effects.histories.col (p) = history (prior, parameter, state, voltages, change);

                     if (parameter.kind == ParameterKind::sensor)
                     {
                         effects.weights.col (p).setZero();
                         effects.weights (parameter.sensor, p) =
                             prior.sensors[static_cast<std::size_t> (parameter.sensor)].shapes[parameter.mode];
                     }
                     else
                         effects.weights.col (p) = state.sensors.col (parameter.mode);
                 });
    return effects;
}

/** The inner products of histories, the lower triangle. Quick modes die out early: in each part of the record only
   those are multiplied that can still be heard.
    @param audibility  P: information per square of a history */
Eigen::MatrixXd gramOf (const Eigen::MatrixXd& histories, const Eigen::VectorXd& audibility)
{
    constexpr Eigen::Index partLength = 1024; // samples
    constexpr double inaudible = 1e-4;        // information, of the prior's
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (histories.cols(), histories.cols());

    for (Eigen::Index first = 0; first < histories.rows(); first += partLength)
    {
        const auto part = histories.middleRows (first, std::min (partLength, histories.rows() - first));
        const Eigen::VectorXd information = part.colwise().squaredNorm().transpose().cwiseProduct (audibility);
        std::vector<Eigen::Index> heard;

        for (Eigen::Index p = 0; p < information.size(); ++p)
            if (information[p] > inaudible)
                heard.push_back (p);

        const auto count = static_cast<Eigen::Index> (heard.size());
        Eigen::MatrixXd some = Eigen::MatrixXd::Zero (count, count);
        addGram (some, 1, part (Eigen::all, heard).transpose());

        for (Eigen::Index q = 0; q < count; ++q)
            for (Eigen::Index p = q; p < count; ++p)
                gram (heard[static_cast<std::size_t> (p)], heard[static_cast<std::size_t> (q)]) += some (p, q);
    }

    return gram;
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
                                       const LearningState& state, Eigen::Index r, Eigen::Index samples)
{
    checkWatch();
    const auto& recording = recordingOf (prior, r);
    const auto& voltages = prior.voltages[static_cast<std::size_t> (r)];
    const auto change = changes (state.model, voltages, samples);
    const auto effects = effectsOf (prior, parameters, state, voltages, change);
    const Eigen::VectorXd precision = recording.noise.cwiseAbs2().cwiseInverse();
    const Eigen::MatrixXd heard = change.velocities * state.sensors.transpose(); // N_s x N
    const Eigen::MatrixXd signals = signalsEarlier (recording, state.delays[r], samples);
    const Eigen::MatrixXd residual = signals - heard;
    const auto modal = parameters.drift();

    RecordingEquations equations { Eigen::MatrixXd::Zero (parameters.size(), parameters.size()),
                                   Eigen::VectorXd::Zero (parameters.size()) };
    const Eigen::MatrixXd weighted = precision.asDiagonal() * effects.weights;
    const Eigen::VectorXd audibility = weighted.cwiseProduct (effects.weights).colwise().sum().transpose();
    const auto gram = gramOf (effects.histories, audibility);
    equations.matrix.topLeftCorner (modal, modal) = gram.cwiseProduct (effects.weights.transpose() * weighted);
    const Eigen::MatrixXd products = effects.histories.transpose() * residual; // P x N
    equations.right.head (modal) = products.cwiseProduct (weighted.transpose()).rowwise().sum();

    // What all modes share reaches every sensor in its own form.
    const auto addCommon = [&] (Eigen::Index row, const Eigen::MatrixXd& effect)
    {
        const Eigen::MatrixXd across = effects.histories.transpose() * effect;
        equations.matrix.row (row).head (modal) = across.cwiseProduct (weighted.transpose()).rowwise().sum();
        Eigen::MatrixXd scaled = effect * precision.asDiagonal();
        equations.matrix (row, row) = scaled.cwiseProduct (effect).sum();
        equations.right[row] = scaled.cwiseProduct (residual).sum();
        return scaled;
    };

    const Eigen::MatrixXd byDrift = prior.deviations.drift * (change.byFrequency * state.sensors.transpose());
    const Eigen::MatrixXd byDelay = -prior.deviations.delay * derivative (heard, recording.sampleRate);
    addCommon (parameters.drift(), byDrift);
    // The residual is that of signals that were shifted back: a longer delay moves them, not the prediction.
    const auto scaled = addCommon (parameters.delay (r), byDelay);
    equations.matrix (parameters.delay (r), parameters.drift()) = scaled.cwiseProduct (byDrift).sum();
    equations.misfit = (residual.array().square().matrix() * precision).sum();
    equations.signal = (signals.array().square().matrix() * precision).sum();
    equations.samples = static_cast<double> (residual.size());
    return equations;
}

double recordingMisfit (const LearningPrior& prior, const LearningState& state, Eigen::Index r, Eigen::Index samples)
{
    checkWatch();
    const auto& recording = recordingOf (prior, r);
    const auto velocities = modeVelocities (state.model, prior.voltages[static_cast<std::size_t> (r)], samples);
    const Eigen::MatrixXd residual =
        signalsEarlier (recording, state.delays[r], samples) - velocities * state.sensors.transpose();
    return (residual.array().square().matrix() * recording.noise.cwiseAbs2().cwiseInverse()).sum();
}
} // namespace antinode
