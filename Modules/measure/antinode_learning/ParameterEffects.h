#pragma once

#include "DrivenModes.h"
#include "LearningParameters.h"

#include <antinode_numerics/DenseKernels.h>

namespace antinode
{
/** Every modal parameter's effect on the sensors: a history in time, which those of all sensors share, and how much of
    it each hears. */
struct ParameterEffects
{
    Histories histories;                    ///< H
    std::vector<Eigen::Index> modes;        ///< H: whose it is; those of one mode follow each other.
    std::vector<Eigen::Index> ofParameters; ///< P: each one's history, ascending.
    Eigen::MatrixXd weights;                ///< N x P
};

/** Of a recording in a state.
    @param motions  of its voltages in this state, of so many samples
    [worker] Docs/Theory.md, section 7.6. */
ParameterEffects parameterEffects (const LearningPrior&, const LearningParameters&, const LearningState&,
                                   const PlayedVoltages&, const DrivenModes& motions, Eigen::Index samples);

/** Inner products of each one's history with signals: samples x columns in, P x columns out.
    @param logarithms  as decayLogarithms
    [worker] */
Eigen::MatrixXd productsWith (const ParameterEffects&, const Eigen::VectorXcd& logarithms,
                              const Eigen::MatrixXd& signals);

/** What sensors tell of all pairs of parameters: inner products of histories, by how much all sensors together hear of
    both.
    @param weighted  the weights by the sensors' precision, N x P
    @param gram      P x P, zeros in; the lower triangle is written
    [worker] */
void takeGram (const ParameterEffects&, const Eigen::MatrixXd& weighted, const Eigen::VectorXcd& logarithms,
               Eigen::Index samples, MatrixOut gram);

/** The parameters that the data say anything of, recordings where there are any: those of which they have at least a
   tenth of the prior's information. The others are left as they are.
    @throws Cancelled  as checkWatch()
    [worker] Docs/Theory.md, section 7.6. */
LearningParameters heardParameters (const LearningPrior&);
} // namespace antinode
