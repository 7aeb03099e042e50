#include "ResponseEquations.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
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
