#include "ParameterEffects.h"

#include <antinode_numerics/ParallelFor.h>

namespace antinode
{
namespace
{
/** The histories of those parameters that are of participations. */
void addParticipations (ParameterEffects& effects, const LearningPrior& prior, const LearningParameters& parameters,
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
        participations.row (static_cast<Eigen::Index> (i)) = prior.deviating.participation.row (modes[i]).cwiseProduct (
            parameters.modal[static_cast<std::size_t> (indices[i])].ceramics.transpose());

    const auto some = drivenBy (state.model, modes, participations, voltages, samples);
    effects.histories.driven (Eigen::all, indices) = some.driven;

    for (std::size_t i = 0; i < modes.size(); ++i)
        effects.histories.after[static_cast<std::size_t> (indices[i])] = some.after[i];
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
} // namespace

ParameterEffects parameterEffects (const LearningPrior& prior, const LearningParameters& parameters,
                                   const LearningState& state, const PlayedVoltages& voltages,
                                   const DrivenModes& motions, Eigen::Index samples)
{
    const auto all = parameters.ofModes();
    ParameterEffects effects { { Eigen::MatrixXd (motions.velocity.driven.rows(), all),
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
            take (p, 1, motions.velocity, k);
            effects.weights.col (p).setZero();
            effects.weights (parameter.sensor, p) = sensor.deviations[k];
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

    return products;
}

void takeGram (const ParameterEffects& effects, const Eigen::MatrixXd& weighted, const Eigen::VectorXcd& logarithms,
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
} // namespace antinode
