#include "LearningEquations.h"

#include "ParameterEffects.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
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

namespace
{
using Places = std::vector<Eigen::Index>;

/** The rows or columns of one function of all modes. */
auto functionsOf (ModalFunction function, Eigen::Index modes)
{
    return Eigen::seqN (static_cast<Eigen::Index> (function), modes, Eigen::fix<realModeFunctions>);
}

/** What one sensor hears of each mode under one ceramic, of the function velocity: N_m x C, a ceramic's sensors after
    each other. */
Eigen::MatrixXd amplitudesOf (const LearningState& state)
{
    const auto sensors = state.sensors.rows(), ceramics = state.model.participation.cols();
    const Eigen::MatrixXd strengths =
        state.model.angularFrequencies.cwiseInverse().asDiagonal() * state.model.participation;
    Eigen::MatrixXd amplitudes (strengths.rows(), sensors * ceramics);

    for (Eigen::Index i = 0; i < ceramics; ++i)
        amplitudes.middleCols (i * sensors, sensors) = strengths.col (i).asDiagonal() * state.sensors.transpose();

    return amplitudes;
}

/** What a standard deviation of each parameter changes: a function of its mode, by so much in each column. */
struct ResponseEffects
{
    Places functions;        ///< P
    Eigen::MatrixXd weights; ///< P x C
};

ResponseEffects effectsOf (const LearningPrior& prior, const LearningParameters& parameters, const LearningState& state,
                           const ResponseState& now)
{
    const auto sensors = state.sensors.rows(), ceramics = state.model.participation.cols();
    ResponseEffects effects { {}, Eigen::MatrixXd::Zero (parameters.ofModes(), now.amplitudes.cols()) };
    effects.functions.reserve (parameters.modal.size());

    for (std::size_t p = 0; p < parameters.modal.size(); ++p)
    {
        const auto& parameter = parameters.modal[p];
        const auto k = parameter.mode;
        const auto add = [&] (ModalFunction function) { effects.functions.push_back (now.basis.column (k, function)); };
        auto weights = effects.weights.row (static_cast<Eigen::Index> (p));

        if (parameter.kind == ParameterKind::frequency)
        {
            add (ModalFunction::frequency);
            weights = prior.deviations.frequencies[k] / state.model.dampingRatios[k] * now.amplitudes.row (k);
        }
        else if (parameter.kind == ParameterKind::damping)
        {
            add (ModalFunction::damping);
            weights = prior.deviations.dampings[k] * now.amplitudes.row (k);
        }
        else if (parameter.kind == ParameterKind::participation)
        {
            add (ModalFunction::velocity);

            for (Eigen::Index i = 0; i < ceramics; ++i)
                weights.segment (i * sensors, sensors) = prior.deviating.participation (k, i) * parameter.ceramics[i]
                                                         / state.model.angularFrequencies[k]
                                                         * state.sensors.col (k).transpose();
        }
        else
        {
            add (ModalFunction::velocity);
            const auto deviation = prior.sensors[static_cast<std::size_t> (parameter.sensor)].deviations[k];

            for (Eigen::Index i = 0; i < ceramics; ++i)
                weights[i * sensors + parameter.sensor] =
                    deviation * state.model.participation (k, i) / state.model.angularFrequencies[k];
        }
    }

    return effects;
}

/** What a standard deviation of the common drift and of the delay change: functions x C each. */
std::vector<Eigen::MatrixXd> effectsOnAllModes (const LearningPrior& prior, const LearningState& state,
                                                const ResponseState& now)
{
    const auto& modes = state.model;
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero (now.basis.modalColumns(), now.amplitudes.cols());
    std::vector<Eigen::MatrixXd> effects (2, none);
    effects[0](functionsOf (ModalFunction::frequency, modes.modes()), Eigen::all) =
        prior.deviations.drift * modes.dampingRatios.cwiseInverse().asDiagonal() * now.amplitudes;
    effects[1](functionsOf (ModalFunction::delay, modes.modes()), Eigen::all) =
        prior.deviations.delay * modes.angularFrequencies.asDiagonal() * now.amplitudes;
    return effects;
}

Eigen::VectorXd precisionOf (const HeardResponses& responses)
{
    return responses.data.columnWeights / responses.variance;
}

DataMisfit misfitOf (const HeardResponses& responses, const ResponseState& now)
{
    return { now.left / responses.variance, now.energy / responses.variance, now.values };
}
} // namespace

ResponseState responseState (const LearningPrior& prior, const LearningState& state)
{
    checkWatch();
    auto& responses = *prior.responses;
    const auto& data = responses.data;
    const auto delay = state.delays[state.delays.size() - 1];

    if (responses.moments.spans.empty() || ! isNear (responses.moments, delay))
        responses.moments = lineMoments (data, delay);

    ResponseState now;
    now.basis = makeBasis (state.model.angularFrequencies, state.model.dampingRatios, data);
    const auto products = modalProducts (now.basis, data, responses.moments, delay);
    now.reduced = withoutPowers (now.basis, products);
    now.amplitudes = amplitudesOf (state);
    const auto velocity = functionsOf (ModalFunction::velocity, state.model.modes());
    const Eigen::MatrixXd toVelocity = now.reduced.gram (Eigen::all, velocity);
    now.errors = now.reduced.data;
    addProduct (now.errors, -1, toVelocity, now.amplitudes);
    const Eigen::VectorXd costs =
        now.reduced.energies
        - now.amplitudes.cwiseProduct (now.reduced.data (velocity, Eigen::all) + now.errors (velocity, Eigen::all))
              .colwise()
              .sum()
              .transpose();
    now.energy = products.energies.dot (data.columnWeights);
    now.left = std::max (costs.dot (data.columnWeights), 1e-20 * now.energy);
    now.values = 2 * static_cast<double> (data.lines() * (data.columnWeights.array() > 0).count());
    const auto ofPoints = [&] (const Eigen::VectorXd& columns) -> Eigen::VectorXd
    { return columns.cwiseProduct (data.columnWeights).reshaped (data.points(), data.references()).rowwise().sum(); };
    now.pointErrors =
        (ofPoints (costs).cwiseMax (0).array() / ofPoints (products.energies).array().max (1e-300)).sqrt().matrix();
    Eigen::MatrixXd ofModes = Eigen::MatrixXd::Zero (now.basis.modalColumns(), data.columns());
    ofModes (velocity, Eigen::all) = now.amplitudes;
    now.coefficients.resize (now.basis.size(), data.columns());
    now.coefficients << ofModes, powerCoefficients (now.basis, products, ofModes);
    return now;
}

DataEquations responseEquations (const LearningPrior& prior, const LearningParameters& parameters,
                                 const LearningState& state)
{
    const auto now = responseState (prior, state);
    const auto effects = effectsOf (prior, parameters, state, now);
    const auto precision = precisionOf (*prior.responses);
    const Eigen::MatrixXd weighted = effects.weights * precision.asDiagonal();
    const auto modal = parameters.ofModes();
    const auto summed = [&] (const Eigen::MatrixXd& products) -> Eigen::VectorXd
    { return products (effects.functions, Eigen::all).cwiseProduct (weighted).rowwise().sum(); };
    DataEquations equations { Eigen::MatrixXd::Zero (parameters.size(), parameters.size()),
                              Eigen::VectorXd::Zero (parameters.size()), misfitOf (*prior.responses, now) };
    auto ofModes = equations.matrix.topLeftCorner (modal, modal);
    addTransposedRight (ofModes, 1, weighted, effects.weights);

    for (Eigen::Index q = 0; q < modal; ++q)
        for (auto p = q; p < modal; ++p)
            ofModes (p, q) *= now.reduced.gram (effects.functions[static_cast<std::size_t> (p)],
                                                effects.functions[static_cast<std::size_t> (q)]);

    equations.right.head (modal) = summed (now.errors);
    const auto onAll = effectsOnAllModes (prior, state, now);
    const std::vector<Eigen::Index> places { parameters.drift(), parameters.delay (state.delays.size() - 1) };

    for (std::size_t i = 0; i < onAll.size(); ++i)
    {
        const auto place = places[i];
        Eigen::MatrixXd products = Eigen::MatrixXd::Zero (onAll[i].rows(), onAll[i].cols());
        addProduct (products, 1, now.reduced.gram, onAll[i]);
        equations.matrix.row (place).head (modal) = summed (products).transpose();
        equations.right[place] = (now.errors.cwiseProduct (onAll[i]).colwise().sum() * precision).value();

        for (std::size_t j = 0; j <= i; ++j)
            equations.matrix (place, places[j]) =
                (products.cwiseProduct (onAll[j]).colwise().sum() * precision).value();
    }

    return equations;
}

DataMisfit responseMisfit (const LearningPrior& prior, const LearningState& state)
{
    return misfitOf (*prior.responses, responseState (prior, state));
}

std::vector<std::vector<LearningParameter>> heardInResponses (const LearningPrior& prior, double leastInformation)
{
    constexpr double quiet = 1e-5; // of the energy
    const auto state =
        stateAt (prior, { {}, {}, prior.delays().size(), {} }, Eigen::VectorXd::Zero (1 + prior.delays().size()));
    const auto now = responseState (prior, state);
    const auto& modes = state.model;
    const auto sensors = state.sensors.rows(), ceramics = modes.participation.cols();
    const Eigen::MatrixXd precisions =
        (prior.responses->data.columnWeights * (now.values / (quiet * now.energy))).reshaped (sensors, ceramics);
    std::vector<std::vector<LearningParameter>> all (static_cast<std::size_t> (modes.modes()));

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        auto& ofMode = all[static_cast<std::size_t> (k)];
        const auto add = [&] (LearningParameter parameter, ModalFunction function, double squares)
        {
            const auto column = now.basis.column (k, function);
            parameter.information = squares * now.reduced.gram (column, column);

            if (parameter.information > leastInformation)
                ofMode.push_back (std::move (parameter));
        };
        const Eigen::VectorXd heard = state.sensors.col (k).cwiseAbs2(),
                              driven = (modes.participation.row (k) / modes.angularFrequencies[k]).cwiseAbs2();
        const auto whole = heard.dot (precisions * driven);
        const auto frequency = prior.deviations.frequencies[k] / modes.dampingRatios[k],
                   damping = prior.deviations.dampings[k];
        add ({ ParameterKind::frequency, k, 0, {}, 0 }, ModalFunction::frequency, frequency * frequency * whole);
        add ({ ParameterKind::damping, k, 0, {}, 0 }, ModalFunction::damping, damping * damping * whole);

        for (Eigen::Index i = 0; i < ceramics; ++i)
        {
            const auto deviation = prior.deviating.participation (k, i) / modes.angularFrequencies[k];
            add ({ ParameterKind::participation, k, 0, Eigen::VectorXd::Unit (ceramics, i), 0 },
                 ModalFunction::velocity, deviation * deviation * heard.dot (precisions.col (i)));
        }

        for (Eigen::Index m = 0; m < sensors; ++m)
            if (const auto& deviations = prior.sensors[static_cast<std::size_t> (m)].deviations; deviations.size() > 0)
                add ({ ParameterKind::sensor, k, m, {}, 0 }, ModalFunction::velocity,
                     deviations[k] * deviations[k] * precisions.row (m).dot (driven));
    }

    return all;
}
} // namespace antinode
