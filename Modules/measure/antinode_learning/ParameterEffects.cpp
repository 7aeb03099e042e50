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
} // namespace antinode
