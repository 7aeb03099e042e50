#pragma once

#include "LearningParameters.h"

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
} // namespace antinode
