#pragma once

#include "LearningParameters.h"

#include <antinode_identification/NormalModes.h>

namespace antinode
{
/** How well a device explains a recording: sums over all samples of all sensors. */
struct DataMisfit
{
    double residual = 0; ///< Of squared residuals over the noise.
    double signal = 0;   ///< Of squared signals over the noise.
    double samples = 0;  ///< How many that are independent, over which white noise sums to as much.

    DataMisfit& operator+= (const DataMisfit& other)
    {
        residual += other.residual;
        signal += other.signal;
        samples += other.samples;
        return *this;
    }
};

/** What one recording says of the parameters: the normal equations of the linearised problem, in standard deviations,
    without what was known before. */
struct DataEquations
{
    Eigen::MatrixXd matrix; ///< P x P, the lower triangle.
    Eigen::VectorXd right;  ///< P
    DataMisfit misfit;
};

/** @param samples  how many of the recording, from its beginning
    [worker] Docs/Theory.md, section 7.6. */
DataEquations recordingEquations (const LearningPrior&, const LearningParameters&, const LearningState&,
                                  Eigen::Index recording, Eigen::Index samples);

/** What a device does not explain of a recording: samples x N. [worker] */
Eigen::MatrixXd recordingResidual (const LearningPrior&, const LearningState&, Eigen::Index recording,
                                   Eigen::Index samples);

/** How strong white noise would be that hides as much as a residual does where it is loudest: its mean square, times
    how much narrower than white noise it is. [worker] */
double powerAsWhiteNoise (const Eigen::VectorXd& residual);

/** The misfit alone. [worker] */
DataMisfit recordingMisfit (const LearningPrior&, const LearningState&, Eigen::Index recording, Eigen::Index samples);

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
