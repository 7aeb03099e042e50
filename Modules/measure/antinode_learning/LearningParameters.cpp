#include "LearningParameters.h"

#include "ModeSpread.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace antinode
{
namespace
{
constexpr double largestDamping = 0.9;

void require (bool isRight, const std::string& what)
{
    if (! isRight)
        throw InputError ("recordings", what);
}

/** What sensors hear of each mode: N x N_m. */
Eigen::MatrixXd shapesOf (const std::vector<Sensor>& sensors)
{
    Eigen::MatrixXd shapes (std::ssize (sensors), sensors.front().shapes.size());

    for (std::size_t m = 0; m < sensors.size(); ++m)
        shapes.row (static_cast<Eigen::Index> (m)) = sensors[m].shapes;

    return shapes;
}

/** A standard deviation of how much a mode has of the next one. */
double mixtureOf (const LearningPrior& prior, Eigen::Index k)
{
    return mixturesOf (prior.modes.angularFrequencies, k, prior.deviations.mixing)[k + 1];
}

/** Changes of a mode's participations, in their standard deviations: N_b. */
Eigen::VectorXd inDeviations (const LearningPrior& prior, Eigen::Index k, const Eigen::RowVectorXd& changes)
{
    const Eigen::VectorXd deviations = prior.deviating.participation.row (k).transpose();
    return (deviations.array() > 0).select (changes.transpose().cwiseQuotient (deviations), 0.0);
}

/** The standard deviation of each participation: by a part of its own, and by neighbours. */
Eigen::MatrixXd participationDeviations (const ModalModel& modes, const ModeSpread& spread)
{
    Eigen::MatrixXd deviations (modes.participation.rows(), modes.participation.cols());
    const Eigen::MatrixXd squares = modes.participation.cwiseAbs2();

    for (Eigen::Index k = 0; k < deviations.rows(); ++k)
    {
        deviations.row (k) =
            std::pow (spread.participation[k], 2)
            * (squares.row (k).array() + std::pow (spread.atNodes, 2) * squares.row (k).mean()).matrix();

        if (spread.mixing > 0 && spread.mixesForces)
            deviations.row (k) +=
                farMixturesOf (modes.angularFrequencies, k, spread.mixing).cwiseAbs2().transpose() * squares;
    }

    return deviations.cwiseSqrt();
}

void apply (LearningState& state, const LearningParameter& parameter, double value, const LearningPrior& prior)
{
    const auto k = parameter.mode;
    const auto& deviations = prior.deviations;

    switch (parameter.kind)
    {
        case ParameterKind::frequency:
            state.model.angularFrequencies[k] *= std::exp (deviations.frequencies[k] * value);
            break;

        case ParameterKind::damping:
            state.model.dampingRatios[k] =
                std::min (largestDamping, state.model.dampingRatios[k] * std::exp (deviations.dampings[k] * value));
            break;

        case ParameterKind::participation:
            state.model.participation.row (k) +=
                value * prior.deviating.participation.row (k).cwiseProduct (parameter.ceramics.transpose());
            break;

        case ParameterKind::sensor:
            state.sensors (parameter.sensor, k) +=
                value * prior.sensors[static_cast<std::size_t> (parameter.sensor)].deviations[k];
            break;
    }
}

/** Each mode with a share of the next one, and the next one with the opposite share of it: of columns.
    @param share  of mode k of the next one */
Eigen::MatrixXd mixed (const Eigen::MatrixXd& columns, Eigen::Index k, double share)
{
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero (columns.rows(), columns.cols());
    change.col (k) = share * columns.col (k + 1);
    change.col (k + 1) = -share * columns.col (k);
    return change;
}

/** What a standard deviation of a parameter changes; none of what it leaves as it is. */
struct SharedChange
{
    Eigen::MatrixXd participation = {}; ///< N_m x N_b
    Eigen::MatrixXd sensors = {};       ///< N x N_m
};

SharedChange changeOf (const LearningPrior& prior, const SharedParameter& parameter)
{
    using Kind = SharedParameter::Kind;
    const auto& all = prior.modes.participation;
    const auto i = parameter.index;

    if (parameter.kind == Kind::gain)
        return { prior.deviations.gain * all };

    if (parameter.kind == Kind::ceramicGain)
    {
        SharedChange change { Eigen::MatrixXd::Zero (all.rows(), all.cols()) };
        change.participation.col (i) = prior.deviations.ceramicGains * all.col (i);
        return change;
    }

    const auto shapes = shapesOf (prior.sensors);

    if (parameter.kind == Kind::mixture)
    {
        const auto share = mixtureOf (prior, i);
        SharedChange change { {}, mixed (shapes, i, share) };

        if (prior.deviations.mixesForces)
            change.participation = mixed (all.transpose(), i, share).transpose();

        return change;
    }

    const auto& sensor = prior.sensors[static_cast<std::size_t> (i)];
    SharedChange change { {}, Eigen::MatrixXd::Zero (shapes.rows(), shapes.cols()) };

    if (parameter.kind == Kind::sensorGain)
        change.sensors.row (i) = sensor.gain * sensor.shapes;
    else
        change.sensors.row (i) = sensor.slopes.row (parameter.kind == Kind::sensorX ? 0 : 1);

    return change;
}

void apply (LearningState& state, const SharedParameter& parameter, double value, const LearningPrior& prior)
{
    const auto change = changeOf (prior, parameter);

    if (change.participation.size() > 0)
        state.model.participation += value * change.participation;

    if (change.sensors.size() > 0)
        state.sensors += value * change.sensors;

    if (parameter.kind == SharedParameter::Kind::mixture)
        state.mixtures[parameter.index] += value * mixtureOf (prior, parameter.index);
}

/** 1/V^2, of each ceramic that plays: the deviation by its largest voltage, or by a hundredth of that of all ceramics,
    below which no cube is heard. */
Eigen::VectorXd distortionDeviationsOf (double deviation, Eigen::Index ceramics,
                                        const std::vector<PlayedRecording>& recordings)
{
    constexpr double leastShare = 0.01;
    Eigen::ArrayXd largest = Eigen::ArrayXd::Zero (ceramics);

    for (const auto& recording : recordings)
        if (recording.cubes.size() > 0)
            largest = largest.max (recording.voltages.rowwise().lpNorm<Eigen::Infinity>().array());

    const Eigen::ArrayXd reference = largest.max (leastShare * largest.maxCoeff());
    return (largest > 0).select (deviation / reference.square(), 0.0);
}
} // namespace

void requireUsable (const ModalModel& model, const std::vector<Sensor>& sensors, const ModeSpread& deviations,
                    const std::vector<PlayedRecording>& recordings)
{
    requireRealModes (model, "learning from recordings");
    const auto modes = model.modes();
    require (! sensors.empty(), "need at least one recording of one sensor");
    require (deviations.frequencies.size() == modes && deviations.dampings.size() == modes
                 && deviations.participation.size() == modes,
             "need the deviations of " + std::to_string (modes) + " modes");
    require (std::isfinite (deviations.distortion) && deviations.distortion >= 0,
             "need a deviation of the distortion of 0 or more");

    for (const auto& sensor : sensors)
        require (sensor.shapes.size() == modes && sensor.shapes.allFinite()
                     && (sensor.deviations.size() == 0 || sensor.deviations.size() == modes)
                     && (sensor.slopes.size() == 0 || sensor.slopes.cols() == modes),
                 "need one finite shape of every mode for every sensor");

    for (const auto& recording : recordings)
    {
        require (recording.voltages.cols() > 0, "need at least one sample");
        require (recording.voltages.rows() == model.actuators() && recording.voltages.allFinite(),
                 "need finite voltages of all " + std::to_string (model.actuators()) + " ceramics");
        require (recording.signals.rows() == static_cast<Eigen::Index> (sensors.size())
                     && recording.signals.cols() == recording.voltages.cols() && recording.signals.allFinite(),
                 "need a finite signal of every sensor, as long as the voltages");
        require ((recording.cubes.size() > 0) == (recordings.front().cubes.size() > 0)
                     && (recording.cubes.size() == 0
                         || (recording.cubes.rows() == recording.voltages.rows()
                             && recording.cubes.cols() == recording.voltages.cols() && recording.cubes.allFinite())),
                 "need finite cubes of all voltages of all recordings, or none");
        require (recording.noise.size() == recording.signals.rows() && recording.noise.minCoeff() > 0
                     && recording.sampleRate > 0 && recording.delay >= 0,
                 "need noise above 0, a sample rate above 0 and a delay of 0 or more");
    }
}

LearningPrior makePrior (const ModalModel& model, const std::vector<Sensor>& sensors, const ModeSpread& deviations,
                         const std::vector<PlayedRecording>& recordings, HeardResponses* responses)
{
    requireUsable (model, sensors, deviations, recordings);
    require (! recordings.empty() || responses != nullptr, "need at least one recording of one sensor");
    LearningPrior prior { model, sensors, deviations, recordings, {}, {}, {}, {}, {}, {} };
    prior.distortionDeviations = distortionDeviationsOf (deviations.distortion, model.actuators(), recordings);
    prior.modes.angularFrequencies = model.angularFrequencies;
    prior.modes.dampingRatios = model.dampingRatios;
    prior.modes.participation = model.participation;
    prior.responses = responses;
    prior.deviating = prior.modes;
    prior.deviating.participation = participationDeviations (prior.modes, deviations);

    for (const auto& recording : recordings)
    {
        prior.noise.push_back (recording.noise);
        prior.voltages.emplace_back (recording.voltages, recording.cubes, recording.sampleRate);
        prior.signals.push_back (std::make_unique<ShiftedSignals> (recording));
    }

    return prior;
}

Eigen::VectorXd LearningPrior::delays() const
{
    Eigen::VectorXd all (std::ssize (recordings) + (responses != nullptr ? 1 : 0));

    for (std::size_t r = 0; r < recordings.size(); ++r)
        all[static_cast<Eigen::Index> (r)] = recordings[r].delay;

    if (responses != nullptr)
        all[all.size() - 1] = responses->delay;

    return all;
}

LearningState stateAt (const LearningPrior& prior, const LearningParameters& parameters, const Eigen::VectorXd& values)
{
    LearningState state { prior.modes, {}, prior.delays(), Eigen::VectorXd::Zero (prior.model.actuators()), {} };
    state.sensors = shapesOf (prior.sensors);
    state.mixtures = Eigen::VectorXd::Zero (prior.model.modes());

    for (std::size_t p = 0; p < parameters.modal.size(); ++p)
        apply (state, parameters.modal[p], values[static_cast<Eigen::Index> (p)], prior);

    for (std::size_t i = 0; i < parameters.shared.size(); ++i)
        apply (state, parameters.shared[i], values[parameters.ofModes() + static_cast<Eigen::Index> (i)], prior);

    state.model.angularFrequencies *= std::exp (prior.deviations.drift * values[parameters.drift()]);

    state.delays += prior.deviations.delay * values.segment (parameters.delay (0), parameters.delays);

    for (std::size_t i = 0; i < parameters.distorting.size(); ++i)
    {
        const auto ceramic = parameters.distorting[i];
        state.distortions[ceramic] =
            prior.distortionDeviations[ceramic] * values[parameters.distortion (static_cast<Eigen::Index> (i))];
    }

    return state;
}

Eigen::MatrixXd effectsOfShared (const LearningPrior& prior, const LearningParameters& parameters)
{
    Eigen::MatrixXd effects = Eigen::MatrixXd::Zero (parameters.ofModes(), std::ssize (parameters.shared));

    for (Eigen::Index i = 0; i < effects.cols(); ++i)
    {
        const auto& shared = parameters.shared[static_cast<std::size_t> (i)];
        const auto change = changeOf (prior, shared);

        for (Eigen::Index p = 0; p < effects.rows(); ++p)
        {
            const auto& parameter = parameters.modal[static_cast<std::size_t> (p)];
            const auto k = parameter.mode;

            if (change.participation.size() > 0 && parameter.kind == ParameterKind::participation)
                effects (p, i) = parameter.ceramics.dot (inDeviations (prior, k, change.participation.row (k)));
            else if (change.sensors.size() > 0 && parameter.kind == ParameterKind::sensor)
                effects (p, i) = change.sensors (parameter.sensor, k)
                                 / prior.sensors[static_cast<std::size_t> (parameter.sensor)].deviations[k];
        }
    }

    return effects;
}

Eigen::VectorXd valuesOf (const LearningPrior& prior, const LearningParameters& parameters, const LearntModes& before)
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero (parameters.size());
    const auto& deviations = prior.deviations;

    if (const auto known = std::min (parameters.delays, before.delays.size()); deviations.delay > 0)
        values.segment (parameters.delay (0), known) =
            (before.delays.head (known) - prior.delays().head (known)) / deviations.delay;

    for (std::size_t i = 0; i < parameters.distorting.size(); ++i)
        values[parameters.distortion (static_cast<Eigen::Index> (i))] =
            before.distortions[parameters.distorting[i]] / prior.distortionDeviations[parameters.distorting[i]];

    for (Eigen::Index p = 0; p < parameters.ofModes(); ++p)
    {
        const auto& parameter = parameters.modal[static_cast<std::size_t> (p)];
        const auto k = parameter.mode;

        switch (parameter.kind)
        {
            case ParameterKind::frequency:
                values[p] = std::log (before.model.angularFrequencies[k] / prior.model.angularFrequencies[k])
                            / deviations.frequencies[k];
                break;

            case ParameterKind::damping:
                values[p] =
                    std::log (before.model.dampingRatios[k] / prior.model.dampingRatios[k]) / deviations.dampings[k];
                break;

            case ParameterKind::participation:
                values[p] = parameter.ceramics.dot (
                    inDeviations (prior, k, before.model.participation.row (k) - prior.model.participation.row (k)));
                break;

            case ParameterKind::sensor:
            {
                const auto m = static_cast<std::size_t> (parameter.sensor);
                values[p] = (before.sensors[m].shapes[k] - prior.sensors[m].shapes[k]) / prior.sensors[m].deviations[k];
                break;
            }
        }
    }

    return values;
}

Eigen::VectorXd withoutSensor (Eigen::VectorXd values, const LearningParameters& parameters, Eigen::Index sensor)
{
    using Kind = SharedParameter::Kind;

    for (Eigen::Index p = 0; p < parameters.ofModes(); ++p)
        if (const auto& one = parameters.modal[static_cast<std::size_t> (p)];
            one.kind == ParameterKind::sensor && one.sensor == sensor)
            values[p] = 0;

    for (std::size_t i = 0; i < parameters.shared.size(); ++i)
        if (const auto& [kind, index] = parameters.shared[i];
            index == sensor && (kind == Kind::sensorGain || kind == Kind::sensorX || kind == Kind::sensorY))
            values[parameters.ofModes() + static_cast<Eigen::Index> (i)] = 0;

    return values;
}
} // namespace antinode
