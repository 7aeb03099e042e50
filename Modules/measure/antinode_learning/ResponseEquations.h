#pragma once

#include "RecordingEquations.h"

#include <antinode_identification/NormalModes.h>

namespace antinode
{
/** Responses beside what a device would answer. N_m modes, C columns of data. */
struct ResponseState
{
    ModalBasis basis;
    ModalProducts reduced;        ///< With the powers of frequency taken out, which modes outside the band are.
    Eigen::MatrixXd amplitudes;   ///< N_m x C: of the function velocity.
    Eigen::MatrixXd errors;       ///< functions x C: products of all functions with what is left of the data.
    Eigen::MatrixXd coefficients; ///< (functions and powers) x C: of the fit.
    double values = 0;            ///< How many were measured.
    double left = 0, energy = 0;  ///< Of the data: squares, weighted.
    Eigen::VectorXd pointErrors;  ///< N_p: what is left of each point's responses, RMS over RMS.

    double variance() const { return left / values; } ///< Of each value, times its weight.
};

/** Recomputes the moments of the responses where the delay is not near to theirs. [worker] */
ResponseState responseState (const LearningPrior&, const LearningState&);

/** What the responses say of the parameters. [worker] Docs/Theory.md, section 8.7. */
DataEquations responseEquations (const LearningPrior&, const LearningParameters&, const LearningState&);

/** The misfit alone. [worker] */
DataMisfit responseMisfit (const LearningPrior&, const LearningState&);

/** The parameters of each mode that responses say anything of, as heardParameters(), were their noise 50 dB below them.
    [worker] */
std::vector<std::vector<LearningParameter>> heardInResponses (const LearningPrior&, double leastInformation);
} // namespace antinode
