#include "LearningParameters.h"

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

/** By how much the participations of a mode differ, relative to themselves: N_b. */
Eigen::VectorXd relativeChange (const ModalModel& now, const ModalModel& before, Eigen::Index k)
{
    const Eigen::VectorXd was = before.participation.row (k).transpose();
    return (was.array() != 0).select ((now.participation.row (k).transpose() - was).cwiseQuotient (was), 0.0);
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
            state.model.participation.row (k).array() +=
                deviations.participation[k] * value
                * (parameter.ceramics.transpose().array() * prior.model.participation.row (k).array());
            break;

        case ParameterKind::sensor:
            state.sensors (parameter.sensor, k) *=
                1 + prior.sensors[static_cast<std::size_t> (parameter.sensor)].deviation * value;
            break;
    }
}

/** 1/V^2, of each ceramic that plays: the deviation by its largest voltage, or by a hundredth of that of all ceramics,
    below which no cube is heard. */
Eigen::VectorXd distortionDeviationsOf (double deviation, const std::vector<PlayedRecording>& recordings)
{
    constexpr double leastShare = 0.01;
    Eigen::ArrayXd largest = Eigen::ArrayXd::Zero (recordings.front().voltages.rows());

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
    require (! recordings.empty() && ! sensors.empty(), "need at least one recording of one sensor");
    require (deviations.frequencies.size() == modes && deviations.dampings.size() == modes
                 && deviations.participation.size() == modes,
             "need the deviations of " + std::to_string (modes) + " modes");
    require (std::isfinite (deviations.distortion) && deviations.distortion >= 0,
             "need a deviation of the distortion of 0 or more");

    for (const auto& sensor : sensors)
        require (sensor.shapes.size() == modes && sensor.shapes.allFinite() && sensor.deviation >= 0,
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
                         const std::vector<PlayedRecording>& recordings)
{
    requireUsable (model, sensors, deviations, recordings);
    LearningPrior prior { model, sensors, deviations, recordings, {}, {}, {}, {} };
    prior.distortionDeviations = distortionDeviationsOf (deviations.distortion, recordings);
    prior.modes.angularFrequencies = model.angularFrequencies;
    prior.modes.dampingRatios = model.dampingRatios;
    prior.modes.participation = model.participation;

    for (const auto& recording : recordings)
    {
        prior.voltages.emplace_back (recording.voltages, recording.cubes, recording.sampleRate);
        prior.signals.push_back (std::make_unique<ShiftedSignals> (recording));
    }

    return prior;
}

LearningState stateAt (const LearningPrior& prior, const LearningParameters& parameters, const Eigen::VectorXd& values)
{
    LearningState state {
        prior.modes, {}, Eigen::VectorXd (parameters.recordings), Eigen::VectorXd::Zero (prior.model.actuators())
    };
    state.sensors.resize (static_cast<Eigen::Index> (prior.sensors.size()), prior.model.modes());

    for (std::size_t m = 0; m < prior.sensors.size(); ++m)
        state.sensors.row (static_cast<Eigen::Index> (m)) = prior.sensors[m].shapes;

    for (std::size_t p = 0; p < parameters.modal.size(); ++p)
        apply (state, parameters.modal[p], values[static_cast<Eigen::Index> (p)], prior);

    state.model.angularFrequencies *= std::exp (prior.deviations.drift * values[parameters.drift()]);

    for (Eigen::Index r = 0; r < parameters.recordings; ++r)
        state.delays[r] = prior.recordings[static_cast<std::size_t> (r)].delay
                          + prior.deviations.delay * values[parameters.delay (r)];

    for (std::size_t i = 0; i < parameters.distorting.size(); ++i)
    {
        const auto ceramic = parameters.distorting[i];
        state.distortions[ceramic] =
            prior.distortionDeviations[ceramic] * values[parameters.distortion (static_cast<Eigen::Index> (i))];
    }

    return state;
}

Eigen::VectorXd valuesOf (const LearningPrior& prior, const LearningParameters& parameters, const LearntModes& before)
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero (parameters.size());
    const auto& deviations = prior.deviations;

    if (deviations.delay > 0)
        for (Eigen::Index r = 0; r < std::min (parameters.recordings, before.delays.size()); ++r)
            values[parameters.delay (r)] =
                (before.delays[r] - prior.recordings[static_cast<std::size_t> (r)].delay) / deviations.delay;

    for (std::size_t i = 0; i < parameters.distorting.size(); ++i)
        values[parameters.distortion (static_cast<Eigen::Index> (i))] =
            before.distortions[parameters.distorting[i]] / prior.distortionDeviations[parameters.distorting[i]];

    for (Eigen::Index p = 0; p < parameters.drift(); ++p)
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
                values[p] = parameter.ceramics.dot (relativeChange (before.model, prior.model, k))
                            / deviations.participation[k];
                break;

            case ParameterKind::sensor:
            {
                const auto m = static_cast<std::size_t> (parameter.sensor);
                values[p] = (before.sensors[m].shapes[k] / prior.sensors[m].shapes[k] - 1) / prior.sensors[m].deviation;
                break;
            }
        }
    }

    return values;
}
} // namespace antinode
