#include "RecordingEquations.h"

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

/** What sensors hear of all modes' velocities or changes: samples x N. */
template <typename Part>
Eigen::MatrixXd heardBy (const Eigen::MatrixXd& sensors, const std::vector<ModeMotion>& motions, Eigen::Index samples,
                         const Part& part)
{
    Eigen::MatrixXd heard = Eigen::MatrixXd::Zero (samples, sensors.rows());

    for (std::size_t k = 0; k < motions.size(); ++k)
    {
        const Eigen::VectorXd& motion = part (motions[k]);

        for (Eigen::Index m = 0; m < sensors.rows(); ++m)
            heard.col (m).head (motion.size()) += sensors (m, static_cast<Eigen::Index> (k)) * motion;
    }

    return heard;
}

/** Every modal parameter's effect: a history in time, until it is at rest, and how much of it each sensor hears. */
struct Effects
{
    std::vector<Eigen::VectorXd> histories; ///< P
    Eigen::MatrixXd weights;                ///< N x P
};

/** The history of a parameter's effect. */
Eigen::VectorXd history (const LearningPrior& prior, const LearningParameter& parameter, const LearningState& state,
                         const PlayedVoltages& voltages, const ModeMotion& motion, Eigen::Index samples)
{
    const auto k = parameter.mode;

    switch (parameter.kind)
    {
        case ParameterKind::frequency:
            return prior.deviations.frequencies[k] * motion.byFrequency;

        case ParameterKind::damping:
            return prior.deviations.dampings[k] * motion.byDamping;

        case ParameterKind::participation:
            return modeMotionUntilRest (state.model.angularFrequencies[k], state.model.dampingRatios[k],
                                        voltages.force (prior.deviations.participation[k]
                                                        * prior.model.participation.row (k).cwiseProduct (
                                                            parameter.ceramics.transpose())),
                                        voltages.sampleRate(), samples, false)
                .velocity;

        case ParameterKind::sensor:
            break;
    }

    return prior.sensors[static_cast<std::size_t> (parameter.sensor)].deviation * motion.velocity;
}

Effects effectsOf (const LearningPrior& prior, const LearningParameters& parameters, const LearningState& state,
                   const PlayedVoltages& voltages, const std::vector<ModeMotion>& motions, Eigen::Index samples)
{
    Effects effects { std::vector<Eigen::VectorXd> (parameters.modal.size()),
                      Eigen::MatrixXd (state.sensors.rows(), parameters.drift()) };
    parallelFor (parameters.modal.size(),
                 [&] (std::size_t index)
                 {
                     const auto p = static_cast<Eigen::Index> (index);
                     const auto& parameter = parameters.modal[index];
                     effects.histories[index] = history (prior, parameter, state, voltages,
                                                         motions[static_cast<std::size_t> (parameter.mode)], samples);

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

/** Inner products of histories with each other and with signals. */
struct InnerProducts
{
    Eigen::MatrixXd gram;    ///< P x P, the lower triangle; empty where it was not wanted.
    Eigen::MatrixXd signals; ///< P x columns
};

/** Histories die out, quick modes early: in each part of the record only those are multiplied that can still be heard.
    @param audibility  P: information per square of a history */
InnerProducts innerProducts (const std::vector<Eigen::VectorXd>& histories, const Eigen::VectorXd& audibility,
                             const Eigen::MatrixXd& signals, bool withGram)
{
    constexpr Eigen::Index partLength = 512; // samples
    constexpr double inaudible = 1e-4;       // information, of the prior's
    const auto all = static_cast<Eigen::Index> (histories.size());
    InnerProducts products { withGram ? Eigen::MatrixXd::Zero (all, all) : Eigen::MatrixXd (0, 0),
                             Eigen::MatrixXd::Zero (all, signals.cols()) };
    std::vector<Eigen::Index> heard;
    Eigen::MatrixXd part (partLength, all);

    for (Eigen::Index first = 0; first < signals.rows(); first += partLength)
    {
        const auto length = std::min (partLength, signals.rows() - first);
        heard.clear();

        for (Eigen::Index p = 0; p < all; ++p)
        {
            const auto& history = histories[static_cast<std::size_t> (p)];
            const auto left = std::min (length, history.size() - first);

            if (left <= 0 || history.segment (first, left).squaredNorm() * audibility[p] <= inaudible)
                continue;

            auto column = part.col (std::ssize (heard));
            column.head (left) = history.segment (first, left);
            column.segment (left, length - left).setZero();
            heard.push_back (p);
        }

        if (heard.empty())
            continue;

        const auto count = std::ssize (heard);
        const auto block = part.topLeftCorner (length, count);
        Eigen::MatrixXd some = Eigen::MatrixXd::Zero (count, signals.cols());
        addTransposedLeft (some, 1, block, signals.middleRows (first, length));
        products.signals (heard, Eigen::all) += some;

        if (! withGram)
            continue;

        Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (count, count);
        addGram (gram, 1, block.transpose());

        for (Eigen::Index q = 0; q < count; ++q)
            for (Eigen::Index p = q; p < count; ++p)
                products.gram (heard[static_cast<std::size_t> (p)], heard[static_cast<std::size_t> (q)]) += gram (p, q);
    }

    return products;
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
    const auto motions = modeMotions (state.model, voltages, samples, true);
    const auto effects = effectsOf (prior, parameters, state, voltages, motions, samples);
    const Eigen::VectorXd precision = recording.noise.cwiseAbs2().cwiseInverse();
    const auto heard = heardBy (state.sensors, motions, samples,
                                [] (const ModeMotion& motion) -> const Eigen::VectorXd& { return motion.velocity; });
    const auto& signals = prior.signals[static_cast<std::size_t> (r)]->earlier (state.delays[r], samples);
    const Eigen::MatrixXd residual = signals - heard;
    const auto modal = parameters.drift();
    const auto sensors = state.sensors.rows();

    // What all modes share reaches every sensor in its own form.
    const Eigen::MatrixXd byDrift =
        prior.deviations.drift
        * heardBy (state.sensors, motions, samples,
                   [] (const ModeMotion& motion) -> const Eigen::VectorXd& { return motion.byFrequency; });
    const Eigen::MatrixXd byDelay = -prior.deviations.delay * derivative (heard, recording.sampleRate);
    Eigen::MatrixXd against (samples, 3 * sensors);
    against << residual, byDrift, byDelay;

    RecordingEquations equations;
    equations.right = Eigen::VectorXd::Zero (parameters.size());
    const Eigen::MatrixXd weighted = precision.asDiagonal() * effects.weights;
    const Eigen::VectorXd audibility = weighted.cwiseProduct (effects.weights).colwise().sum().transpose();
    const auto products = innerProducts (effects.histories, audibility, against, withMatrix);
    const auto summed = [&] (Eigen::Index part) -> Eigen::VectorXd {
        return products.signals.middleCols (part * sensors, sensors)
            .cwiseProduct (weighted.transpose())
            .rowwise()
            .sum();
    };
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
        equations.matrix.topLeftCorner (modal, modal) =
            products.gram.cwiseProduct (effects.weights.transpose() * weighted);
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
    const auto motions = modeMotions (state.model, prior.voltages[static_cast<std::size_t> (r)], samples, false);
    const auto heard = heardBy (state.sensors, motions, samples,
                                [] (const ModeMotion& motion) -> const Eigen::VectorXd& { return motion.velocity; });
    const auto& signals = prior.signals[static_cast<std::size_t> (r)]->earlier (state.delays[r], samples);
    return ((signals - heard).cwiseAbs2().colwise().sum() * recording.noise.cwiseAbs2().cwiseInverse()).value();
}
} // namespace antinode
