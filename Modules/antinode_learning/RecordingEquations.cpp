#include "RecordingEquations.h"

#include "DrivenModes.h"

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

/** Every modal parameter's effect: a history in time, and how much of it each sensor hears. */
struct Effects
{
    Histories histories;             ///< P
    Eigen::MatrixXd weights;         ///< N x P
    std::vector<Eigen::Index> modes; ///< P
};

/** The histories of those parameters that are of participations. */
void addParticipations (Effects& effects, const LearningPrior& prior, const LearningParameters& parameters,
                        const LearningState& state, const PlayedVoltages& voltages, Eigen::Index samples)
{
    std::vector<Eigen::Index> modes, indices;

    for (std::size_t p = 0; p < parameters.modal.size(); ++p)
        if (parameters.modal[p].kind == ParameterKind::participation)
        {
            modes.push_back (parameters.modal[p].mode);
            indices.push_back (static_cast<Eigen::Index> (p));
        }

    Eigen::MatrixXd participations (std::ssize (modes), prior.model.actuators());

    for (std::size_t i = 0; i < modes.size(); ++i)
        participations.row (static_cast<Eigen::Index> (i)) =
            prior.deviations.participation[modes[i]]
            * prior.model.participation.row (modes[i]).cwiseProduct (
                parameters.modal[static_cast<std::size_t> (indices[i])].ceramics.transpose());

    const auto some = drivenBy (state.model, modes, participations, voltages, samples);
    effects.histories.driven (Eigen::all, indices) = some.driven;

    for (std::size_t i = 0; i < modes.size(); ++i)
        effects.histories.after[static_cast<std::size_t> (indices[i])] = some.after[i];
}

Effects effectsOf (const LearningPrior& prior, const LearningParameters& parameters, const LearningState& state,
                   const PlayedVoltages& voltages, const DrivenModes& motions, Eigen::Index samples)
{
    const auto all = parameters.drift();
    Effects effects { { Eigen::MatrixXd (motions.velocity.driven.rows(), all),
                        std::vector<FreeDecay> (parameters.modal.size()) },
                      Eigen::MatrixXd (state.sensors.rows(), all),
                      {} };
    const auto take = [&] (Eigen::Index p, double factor, const Histories& histories, Eigen::Index k)
    {
        const auto& after = histories.after[static_cast<std::size_t> (k)];
        effects.histories.driven.col (p) = factor * histories.driven.col (k);
        effects.histories.after[static_cast<std::size_t> (p)] = { factor * after.constant, factor * after.slope };
    };

    for (Eigen::Index p = 0; p < all; ++p)
    {
        const auto& parameter = parameters.modal[static_cast<std::size_t> (p)];
        const auto k = parameter.mode;
        const auto& sensor = prior.sensors[static_cast<std::size_t> (parameter.sensor)];
        effects.modes.push_back (k);
        effects.weights.col (p) = state.sensors.col (k);

        if (parameter.kind == ParameterKind::frequency)
            take (p, prior.deviations.frequencies[k], motions.byFrequency, k);
        else if (parameter.kind == ParameterKind::damping)
            take (p, prior.deviations.dampings[k], motions.byDamping, k);
        else if (parameter.kind == ParameterKind::sensor)
        {
            take (p, sensor.deviation, motions.velocity, k);
            effects.weights.col (p).setZero();
            effects.weights (parameter.sensor, p) = sensor.shapes[k];
        }
    }

    addParticipations (effects, prior, parameters, state, voltages, samples);
    return effects;
}

/** Inner products of histories with signals, samples x columns: P x columns. */
Eigen::MatrixXd productsWith (const Effects& effects, const Eigen::VectorXcd& logarithms,
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

    return products;
}

/** Where the parameters of each mode begin, which follow each other, and the end. */
std::vector<Eigen::Index> beginsOfModes (const std::vector<Eigen::Index>& modes)
{
    std::vector<Eigen::Index> begins;

    for (std::size_t p = 0; p < modes.size(); ++p)
        if (p == 0 || modes[p] != modes[p - 1])
            begins.push_back (static_cast<Eigen::Index> (p));

    begins.push_back (std::ssize (modes));
    return begins;
}

/** What sensors tell of all pairs of parameters: inner products of histories, by how much all sensors together hear of
    both.
    @param weighted  the weights by the sensors' precision, N x P
    @param gram      P x P in and out, of which the lower triangle is written */
void takeGram (const Effects& effects, const Eigen::MatrixXd& weighted, const Eigen::VectorXcd& logarithms,
               Eigen::Index samples, MatrixOut gram)
{
    const auto& histories = effects.histories;
    const auto parts = histories.parts();
    const auto rest = samples - histories.driven.rows();
    const auto begins = beginsOfModes (effects.modes);
    addGram (gram, 1, histories.driven.transpose());
    parallelFor (begins.size() - 1,
                 [&] (std::size_t i)
                 {
                     const auto row = begins[i], rows = begins[i + 1] - row;
                     const auto mode = logarithms[effects.modes[static_cast<std::size_t> (row)]];

                     for (std::size_t j = 0; j <= i; ++j)
                     {
                         const auto column = begins[j], columns = begins[j + 1] - column;
                         const auto other = logarithms[effects.modes[static_cast<std::size_t> (column)]];
                         const Eigen::Matrix4Xd right =
                             decayProducts (mode, other, rest) * parts.middleCols (column, columns);
                         auto block = gram.block (row, column, rows, columns);
                         block += parts.middleCols (row, rows).transpose().lazyProduct (right);
                         block.array() *= effects.weights.middleCols (row, rows)
                                              .transpose()
                                              .lazyProduct (weighted.middleCols (column, columns))
                                              .array();
                     }
                 });
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
    const auto effects = effectsOf (prior, parameters, state, voltages, motions, samples);
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
    Eigen::MatrixXd against (samples, 3 * sensors);
    against << residual, byDrift, byDelay;

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
