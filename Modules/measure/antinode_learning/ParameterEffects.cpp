#include "ParameterEffects.h"

#include "DrivenModes.h"
#include "LearningEquations.h"
#include "ModeSpread.h"

#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>

namespace antinode
{
namespace
{
/** The histories of those parameters that are of participations. */
void addParticipations (ParameterEffects& effects, const LearningPrior& prior, const LearningParameters& parameters,
                        const LearningState& state, const PlayedVoltages& voltages, Eigen::Index samples)
{
    std::vector<Eigen::Index> modes, indices;
    std::vector<std::size_t> found;

    for (std::size_t p = 0; p < parameters.modal.size(); ++p)
        if (parameters.modal[p].kind == ParameterKind::participation)
        {
            modes.push_back (parameters.modal[p].mode);
            indices.push_back (effects.ofParameters[p]);
            found.push_back (p);
        }

    Eigen::MatrixXd participations (std::ssize (modes), prior.model.actuators());

    for (std::size_t i = 0; i < modes.size(); ++i)
        participations.row (static_cast<Eigen::Index> (i)) =
            prior.deviating.participation.row (modes[i]).cwiseProduct (parameters.modal[found[i]].ceramics.transpose());

    const auto some = drivenBy (state.model, modes, participations, voltages, samples);
    effects.histories.driven (Eigen::all, indices) = some.driven;

    for (std::size_t i = 0; i < modes.size(); ++i)
        effects.histories.after[static_cast<std::size_t> (indices[i])] = some.after[i];
}

/** Each parameter's history: its own, or the velocity of a mode, which what all sensors hear of it share. */
void shareHistories (ParameterEffects& effects, const LearningParameters& parameters)
{
    for (std::size_t p = 0; p < parameters.modal.size(); ++p)
    {
        const auto& parameter = parameters.modal[p];
        const auto isShared = p > 0 && parameter.kind == ParameterKind::sensor
                              && parameters.modal[p - 1].kind == ParameterKind::sensor
                              && parameters.modal[p - 1].mode == parameter.mode;

        if (! isShared)
            effects.modes.push_back (parameter.mode);

        effects.ofParameters.push_back (std::ssize (effects.modes) - 1);
    }
}

/** What belongs to one mode: its histories, and its parameters with the history that each has among these. */
struct OfMode
{
    Eigen::Index mode = 0, firstHistory = 0, firstParameter = 0;
    std::vector<Eigen::Index> histories; ///< Of each of its parameters, from its first one on.

    Eigen::Index parameters() const { return std::ssize (histories); }
    Eigen::Index historyCount() const { return histories.back() + 1; }
};

std::vector<OfMode> byMode (const ParameterEffects& effects)
{
    std::vector<OfMode> all;

    for (std::size_t p = 0; p < effects.ofParameters.size(); ++p)
    {
        const auto history = effects.ofParameters[p];
        const auto mode = effects.modes[static_cast<std::size_t> (history)];

        if (all.empty() || all.back().mode != mode)
            all.push_back ({ mode, history, static_cast<Eigen::Index> (p), {} });

        all.back().histories.push_back (history - all.back().firstHistory);
    }

    return all;
}
} // namespace

ParameterEffects parameterEffects (const LearningPrior& prior, const LearningParameters& parameters,
                                   const LearningState& state, const PlayedVoltages& voltages,
                                   const DrivenModes& motions, Eigen::Index samples)
{
    ParameterEffects effects;
    shareHistories (effects, parameters);
    effects.histories = { Eigen::MatrixXd (motions.velocity.driven.rows(), std::ssize (effects.modes)),
                          std::vector<FreeDecay> (effects.modes.size()) };
    effects.weights.resize (state.sensors.rows(), parameters.ofModes());
    const auto take = [&] (std::size_t p, double factor, const Histories& histories, Eigen::Index k)
    {
        const auto to = effects.ofParameters[p];
        const auto& after = histories.after[static_cast<std::size_t> (k)];
        effects.histories.driven.col (to) = factor * histories.driven.col (k);
        effects.histories.after[static_cast<std::size_t> (to)] = { factor * after.constant, factor * after.slope };
    };

    for (std::size_t p = 0; p < parameters.modal.size(); ++p)
    {
        const auto& parameter = parameters.modal[p];
        const auto k = parameter.mode;
        auto weights = effects.weights.col (static_cast<Eigen::Index> (p));
        weights = state.sensors.col (k);

        if (parameter.kind == ParameterKind::frequency)
            take (p, prior.deviations.frequencies[k], motions.byFrequency, k);
        else if (parameter.kind == ParameterKind::damping)
            take (p, prior.deviations.dampings[k], motions.byDamping, k);
        else if (parameter.kind == ParameterKind::sensor)
        {
            take (p, 1, motions.velocity, k);
            weights.setZero();
            weights[parameter.sensor] = prior.sensors[static_cast<std::size_t> (parameter.sensor)].deviations[k];
        }
    }

    addParticipations (effects, prior, parameters, state, voltages, samples);
    return effects;
}

Eigen::MatrixXd productsWith (const ParameterEffects& effects, const Eigen::VectorXcd& logarithms,
                              const Eigen::MatrixXd& signals)
{
    const auto& histories = effects.histories;
    const auto driven = histories.driven.rows();
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero (histories.driven.cols(), signals.cols());
    addTransposedLeft (products, 1, histories.driven, signals.topRows (driven));

    Eigen::MatrixXd ofModes = Eigen::MatrixXd::Zero (4 * logarithms.size(), signals.cols());
    forEachDecayPart (logarithms, signals.rows() - driven,
                      [&] (const DecayPart& part)
                      {
                          Eigen::MatrixXd some = Eigen::MatrixXd::Zero (std::ssize (part.columns), signals.cols());
                          addTransposedLeft (some, 1, part.basis,
                                             signals.middleRows (driven + part.first, part.basis.rows()));
                          ofModes (part.columns, Eigen::all) += some;
                      });
    const auto parts = histories.parts();

    for (Eigen::Index p = 0; p < parts.cols(); ++p)
        products.row (p) +=
            parts.col (p).transpose() * ofModes.middleRows<4> (4 * effects.modes[static_cast<std::size_t> (p)]);

    return products (effects.ofParameters, Eigen::all);
}

void takeGram (const ParameterEffects& effects, const Eigen::MatrixXd& weighted, const Eigen::VectorXcd& logarithms,
               Eigen::Index samples, MatrixOut gram)
{
    const auto& histories = effects.histories;
    const auto parts = histories.parts();
    const auto rest = samples - histories.driven.rows();
    const auto modes = byMode (effects);
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero (parts.cols(), parts.cols());
    addGram (products, 1, histories.driven.transpose());
    parallelFor (
        modes.size(),
        [&] (std::size_t i)
        {
            const auto& row = modes[i];
            const auto ofRow = parts.middleCols (row.firstHistory, row.historyCount());

            for (std::size_t j = 0; j <= i; ++j)
            {
                const auto& column = modes[j];
                auto block =
                    products.block (row.firstHistory, column.firstHistory, row.historyCount(), column.historyCount());
                const Eigen::Matrix4Xd right = decayProducts (logarithms[row.mode], logarithms[column.mode], rest)
                                               * parts.middleCols (column.firstHistory, column.historyCount());
                block += ofRow.transpose().lazyProduct (right);
                gram.block (row.firstParameter, column.firstParameter, row.parameters(), column.parameters()) =
                    block (row.histories, column.histories)
                        .cwiseProduct (
                            effects.weights.middleCols (row.firstParameter, row.parameters())
                                .transpose()
                                .lazyProduct (weighted.middleCols (column.firstParameter, column.parameters())));
            }
        });
}

namespace
{
constexpr double leastInformation = 0.1; // of the prior's, of a parameter

/** The inner products of what a deviation of each participation does to a mode, N_b x N_b, of all recordings, each of
    its length. */
Eigen::MatrixXd sharesOfCeramics (const LearningPrior& prior, Eigen::Index k)
{
    const auto ceramics = prior.model.actuators();
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero (ceramics, ceramics);

    for (const auto& voltages : prior.voltages)
    {
        const auto each = drivenByEachCeramic (prior.deviating, k, voltages, voltages.samples());
        const auto parts = each.parts();
        const auto logarithm = decayLogarithm (prior.model, k, voltages.sampleRate());
        const auto decay = decayProducts (logarithm, logarithm, voltages.samples() - each.driven.rows());
        products += parts.transpose() * decay * parts;
        addGram (products, 1, each.driven.transpose());
    }

    return products.selfadjointView<Eigen::Lower>();
}

/** How well all sensors together hear a mode: the sum of squares over the noise. */
double audibility (const LearningPrior& prior, Eigen::Index k)
{
    double sum = 0;

    for (std::size_t m = 0; m < prior.sensors.size(); ++m)
    {
        const auto ratio = prior.sensors[m].shapes[k] / prior.recordings.front().noise[static_cast<Eigen::Index> (m)];
        sum += ratio * ratio;
    }

    return sum;
}

std::vector<LearningParameter> participationParameters (Eigen::Index k, const Eigen::MatrixXd& products, double heard)
{
    const auto eigen = symmetricEigen (products);
    std::vector<LearningParameter> parameters;

    for (auto v = eigen.values.size() - 1; v >= 0; --v)
        if (const auto told = heard * eigen.values[v]; told > leastInformation)
            parameters.push_back ({ ParameterKind::participation, k, 0, eigen.vectors.col (v), told });

    return parameters;
}

/** Sums of squares over a whole recording: N_m. */
Eigen::VectorXd energiesOf (const Histories& histories, const Eigen::VectorXcd& logarithms, Eigen::Index samples)
{
    Eigen::VectorXd energies = histories.driven.colwise().squaredNorm().transpose();

    for (Eigen::Index k = 0; k < energies.size(); ++k)
    {
        const auto parts = histories.after[static_cast<std::size_t> (k)].parts();
        energies[k] +=
            parts.dot (decayProducts (logarithms[k], logarithms[k], samples - histories.driven.rows()) * parts);
    }

    return energies;
}

/** The sums of squares of all modes' motions, and of their changes per relative change of frequency and damping: 3 x
    N_m. */
Eigen::Matrix3Xd knownEnergies (const LearningPrior& prior)
{
    Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero (3, prior.model.modes());

    for (const auto& voltages : prior.voltages)
    {
        const auto motions = driveModes (prior.model, voltages, voltages.samples());
        const auto logarithms = decayLogarithms (prior.model, voltages.sampleRate());
        sums.row (0) += energiesOf (motions.velocity, logarithms, voltages.samples());
        sums.row (1) += energiesOf (motions.byFrequency, logarithms, voltages.samples());
        sums.row (2) += energiesOf (motions.byDamping, logarithms, voltages.samples());
    }

    return sums;
}

/** The energies of a mode where participations are off as the prior says. Voltages that keep a mode at rest by what it
    is known to be move it on the device: ceramics that cancel each other do not any more. */
Eigen::Vector3d expectedEnergies (const Eigen::Vector3d& known, const Eigen::MatrixXd& products)
{
    const auto whole = known[0] + products.trace();
    return known[0] > 0 ? Eigen::Vector3d (known * (whole / known[0])) : Eigen::Vector3d (whole, 0, 0);
}

std::vector<LearningParameter> parametersOf (const LearningPrior& prior, Eigen::Index k, const Eigen::Vector3d& known)
{
    const auto square = [] (double value) { return value * value; };
    const auto& deviations = prior.deviations;
    const auto heard = audibility (prior, k);
    const auto products = sharesOfCeramics (prior, k);
    const auto energy = expectedEnergies (known, products);
    auto parameters = std::vector<LearningParameter> {};

    if (const auto told = heard * energy[1] * square (deviations.frequencies[k]); told > leastInformation)
        parameters.push_back ({ ParameterKind::frequency, k, 0, {}, told });

    if (const auto told = heard * energy[2] * square (deviations.dampings[k]); told > leastInformation)
        parameters.push_back ({ ParameterKind::damping, k, 0, {}, told });

    const auto directions = participationParameters (k, products, heard);
    parameters.insert (parameters.end(), directions.begin(), directions.end());

    for (std::size_t m = 0; m < prior.sensors.size(); ++m)
    {
        const auto& sensor = prior.sensors[m];

        if (sensor.deviations.size() == 0)
            continue;

        const auto ratio = sensor.deviations[k] / prior.recordings.front().noise[static_cast<Eigen::Index> (m)];

        if (const auto told = square (ratio) * energy[0]; told > leastInformation)
            parameters.push_back ({ ParameterKind::sensor, k, static_cast<Eigen::Index> (m), {}, told });
    }

    return parameters;
}

std::vector<SharedParameter> sharedOf (const LearningPrior& prior)
{
    std::vector<SharedParameter> shared;

    if (prior.deviations.gain > 0)
        shared.push_back ({ SharedParameter::Kind::gain, 0 });

    if (prior.deviations.ceramicGains > 0)
        for (Eigen::Index i = 0; i < prior.model.actuators(); ++i)
            shared.push_back ({ SharedParameter::Kind::ceramicGain, i });

    constexpr double leastMixture = 0.02;

    for (Eigen::Index k = 0; k + 1 < prior.model.modes() && prior.deviations.mixing > 0; ++k)
        if (mixturesOf (prior.modes.angularFrequencies, k, prior.deviations.mixing)[k + 1] > leastMixture)
            shared.push_back ({ SharedParameter::Kind::mixture, k });

    for (std::size_t m = 0; m < prior.sensors.size(); ++m)
    {
        const auto index = static_cast<Eigen::Index> (m);

        if (prior.sensors[m].gain > 0)
            shared.push_back ({ SharedParameter::Kind::sensorGain, index });

        if (prior.sensors[m].slopes.size() > 0)
        {
            shared.push_back ({ SharedParameter::Kind::sensorX, index });
            shared.push_back ({ SharedParameter::Kind::sensorY, index });
        }
    }

    return shared;
}

std::vector<std::vector<LearningParameter>> heardInRecordings (const LearningPrior& prior)
{
    std::vector<std::vector<LearningParameter>> ofModes (static_cast<std::size_t> (prior.model.modes()));
    const auto known = knownEnergies (prior);
    parallelFor (ofModes.size(),
                 [&] (std::size_t index)
                 {
                     const auto k = static_cast<Eigen::Index> (index);
                     ofModes[index] = parametersOf (prior, k, known.col (k));
                 });
    return ofModes;
}
} // namespace

LearningParameters heardParameters (const LearningPrior& prior)
{
    const auto ofModes =
        prior.recordings.empty() ? heardInResponses (prior, leastInformation) : heardInRecordings (prior);
    LearningParameters parameters;
    parameters.shared = sharedOf (prior);
    parameters.delays = prior.delays().size();

    for (Eigen::Index i = 0; i < prior.distortionDeviations.size(); ++i)
        if (prior.distortionDeviations[i] > 0)
            parameters.distorting.push_back (i);

    for (const auto& some : ofModes)
        parameters.modal.insert (parameters.modal.end(), some.begin(), some.end());

    return parameters;
}
} // namespace antinode
