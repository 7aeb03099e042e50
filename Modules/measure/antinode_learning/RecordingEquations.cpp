#include "RecordingEquations.h"

#include "ParameterEffects.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <vector>

namespace antinode
{
namespace
{
const PlayedRecording& recordingOf (const LearningPrior& prior, Eigen::Index r)
{
    return prior.recordings[static_cast<std::size_t> (r)];
}

/** What sensors hear of velocities or changes of all modes, of each history: samples x N, side by side. */
Eigen::MatrixXd heardBy (const Eigen::MatrixXd& sensors, const std::vector<const Histories*>& histories,
                         const Eigen::VectorXcd& logarithms, Eigen::Index samples)
{
    const auto count = sensors.rows(), driven = histories.front()->driven.rows();
    Eigen::MatrixXd heard = Eigen::MatrixXd::Zero (samples, std::ssize (histories) * count);
    Eigen::MatrixXd weights (4 * logarithms.size(), heard.cols());

    for (std::size_t i = 0; i < histories.size(); ++i)
    {
        const auto first = static_cast<Eigen::Index> (i) * count;
        addTransposedRight (heard.block (0, first, driven, count), 1, histories[i]->driven, sensors);
        const auto parts = histories[i]->parts();

        for (Eigen::Index k = 0; k < parts.cols(); ++k)
            weights.block (4 * k, first, 4, count) = parts.col (k) * sensors.col (k).transpose();
    }

    forEachDecayPart (logarithms, samples - driven,
                      [&] (const DecayPart& part)
                      {
                          const Eigen::MatrixXd some = weights (part.columns, Eigen::all);
                          addProduct (heard.middleRows (driven + part.first, part.basis.rows()), 1, part.basis, some);
                      });
    return heard;
}

/** 1 over the square of what is believed of each sensor's noise: N. */
Eigen::VectorXd precisionOf (const LearningPrior& prior, Eigen::Index r)
{
    return prior.noise[static_cast<std::size_t> (r)].cwiseAbs2().cwiseInverse();
}

DataMisfit misfitOf (const Eigen::MatrixXd& residual, const Eigen::MatrixXd& signals, const LearningPrior& prior,
                     Eigen::Index r)
{
    const auto precision = precisionOf (prior, r);
    const auto weighed = [&precision] (const Eigen::MatrixXd& values)
    { return (values.cwiseAbs2().colwise().sum() * precision).value(); };
    return { weighed (residual), weighed (signals),
             recordingOf (prior, r).bandShare * static_cast<double> (residual.size()) };
}

/** What each ceramic's distortion changes of the motions of all modes, of those that are looked for. */
std::vector<Histories> byDistortions (const LearningParameters& parameters, const LearningState& state,
                                      const PlayedVoltages& voltages, Eigen::Index samples)
{
    std::vector<Histories> all;

    if (voltages.hasCubes())
        for (const auto ceramic : parameters.distorting)
            all.push_back (drivenByCube (state.model, voltages, ceramic, samples));

    return all;
}

constexpr Eigen::Index ofDrift = 1, ofDelay = 2, ofDistortions = 3; // parts of SharedEffects::against; 0: the residual

/** The parameters that all modes share, each of which reaches every sensor in its own form. */
struct SharedEffects
{
    std::vector<Eigen::Index> parameters;
    Eigen::MatrixXd against; ///< The residual, then what each changes of the prediction: samples x N, side by side.
    Eigen::MatrixXd byDelay; ///< What the recording's delay changes of the residual: samples x N.
};

/** Of the drift, the recording's delay and the ceramics' distortions. */
SharedEffects sharedEffects (const LearningPrior& prior, const LearningParameters& parameters,
                             const LearningState& state, Eigen::Index r, const PlayedVoltages& voltages,
                             const DrivenModes& motions, Eigen::Index samples)
{
    const auto& deviations = prior.deviations;
    auto& recorded = *prior.signals[static_cast<std::size_t> (r)];
    const auto distortions = byDistortions (parameters, state, voltages, samples);
    // The delay's slopes are written over the second prediction.
    std::vector<const Histories*> histories { &motions.velocity, &motions.byFrequency, &motions.velocity };
    SharedEffects shared { { parameters.drift(), parameters.delay (r) }, {}, {} };

    for (const auto& each : distortions)
    {
        shared.parameters.push_back (parameters.distortion (std::ssize (histories) - ofDistortions));
        histories.push_back (&each);
    }

    shared.against = heardBy (state.sensors, histories, decayLogarithms (state.model, voltages.sampleRate()), samples);
    const auto sensors = state.sensors.rows();
    const auto part = [&] (Eigen::Index i) { return shared.against.middleCols (i * sensors, sensors); };
    // A longer delay moves the signals, not the prediction. The matrix has the slopes of the latter, which have no
    // noise.
    part (ofDelay) = -deviations.delay * slopesOf (part (0).transpose(), voltages.sampleRate());
    shared.byDelay = -deviations.delay * recorded.slopesEarlier (state.delays[r], samples);
    part (0) = recorded.earlier (state.delays[r], samples) - part (0);
    part (ofDrift) *= deviations.drift;

    for (std::size_t i = 0; i < distortions.size(); ++i)
        part (ofDistortions + static_cast<Eigen::Index> (i)) *= prior.distortionDeviations[parameters.distorting[i]];

    return shared;
}
} // namespace

DataEquations recordingEquations (const LearningPrior& prior, const LearningParameters& parameters,
                                  const LearningState& state, Eigen::Index r, Eigen::Index samples)
{
    checkWatch();
    const auto voltages = prior.voltages[static_cast<std::size_t> (r)].distorted (state.distortions);
    const auto motions = driveModes (state.model, voltages, samples);
    const auto logarithms = decayLogarithms (state.model, voltages.sampleRate());
    const auto effects = parameterEffects (prior, parameters, state, voltages, motions, samples);
    const auto shared = sharedEffects (prior, parameters, state, r, voltages, motions, samples);
    const auto precision = precisionOf (prior, r);
    const Eigen::MatrixXd weighted = precision.asDiagonal() * effects.weights;
    const auto products = productsWith (effects, logarithms, shared.against);
    const auto modal = parameters.ofModes(), sensors = state.sensors.rows();
    const auto part = [&] (Eigen::Index i) { return shared.against.middleCols (i * sensors, sensors); };
    const auto summed = [&] (Eigen::Index i) -> Eigen::VectorXd
    { return products.middleCols (i * sensors, sensors).cwiseProduct (weighted.transpose()).rowwise().sum(); };
    const auto product = [&] (const auto& a, const auto& b)
    { return (a.cwiseProduct (b).colwise().sum() * precision).value(); };
    DataEquations equations { Eigen::MatrixXd::Zero (parameters.size(), parameters.size()), {}, {} };
    equations.right = Eigen::VectorXd::Zero (parameters.size());
    equations.right.head (modal) = summed (0);
    takeGram (effects, weighted, logarithms, samples, equations.matrix.topLeftCorner (modal, modal));

    for (Eigen::Index i = 0; i < std::ssize (shared.parameters); ++i)
    {
        const auto place = shared.parameters[static_cast<std::size_t> (i)];
        equations.right[place] = product (part (1 + i), part (0));
        equations.matrix.row (place).head (modal) = summed (1 + i).transpose();

        for (Eigen::Index j = 0; j <= i; ++j)
            equations.matrix (place, shared.parameters[static_cast<std::size_t> (j)]) =
                product (part (1 + i), part (1 + j));
    }

    equations.right[parameters.delay (r)] = product (shared.byDelay, part (0));
    const auto& signals = prior.signals[static_cast<std::size_t> (r)]->earlier (state.delays[r], samples);
    equations.misfit = misfitOf (part (0), signals, prior, r);
    return equations;
}

Eigen::MatrixXd recordingResidual (const LearningPrior& prior, const LearningState& state, Eigen::Index r,
                                   Eigen::Index samples)
{
    checkWatch();
    const auto voltages = prior.voltages[static_cast<std::size_t> (r)].distorted (state.distortions);
    const auto histories = modeHistories (state.model, voltages, samples);
    const auto heard =
        heardBy (state.sensors, { &histories }, decayLogarithms (state.model, voltages.sampleRate()), samples);
    return prior.signals[static_cast<std::size_t> (r)]->earlier (state.delays[r], samples) - heard;
}

double powerAsWhiteNoise (const Eigen::VectorXd& residual)
{
    const Eigen::ArrayXd powers = forwardFourier (residual).cwiseAbs2();
    const auto mean = powers.mean();

    if (! (mean > 0))
        return 0;

    // A periodogram of white noise is exponentially distributed: its mean square is twice its squared mean.
    const auto narrowness = powers.square().mean() / (2 * mean * mean);
    return residual.squaredNorm() / static_cast<double> (residual.size()) * std::max (1.0, narrowness);
}

DataMisfit recordingMisfit (const LearningPrior& prior, const LearningState& state, Eigen::Index r,
                            Eigen::Index samples)
{
    const auto residual = recordingResidual (prior, state, r, samples);
    const auto& signals = prior.signals[static_cast<std::size_t> (r)]->earlier (state.delays[r], samples);
    return misfitOf (residual, signals, prior, r);
}
} // namespace antinode
