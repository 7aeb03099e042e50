#pragma once

#include "LearningParameters.h"

namespace antinode
{
/** What one recording says of the parameters: the normal equations of the linearised problem, in standard deviations,
    without what was known before. */
struct RecordingEquations
{
    Eigen::MatrixXd matrix; ///< P x P, the lower triangle; empty where it was not wanted.
    Eigen::VectorXd right;  ///< P
    double misfit = 0;      ///< Sum of squared residuals over the noise.
    double signal = 0;      ///< Sum of squared signals over the noise.
    double samples = 0;     ///< How many.
};

/** @param samples     how many of the recording, from its beginning
    @param withMatrix  without it there is none, and the rest costs a tenth
    [worker] Docs/Theory.md, section 7.6. */
RecordingEquations recordingEquations (const LearningPrior&, const LearningParameters&, const LearningState&,
                                       Eigen::Index recording, Eigen::Index samples, bool withMatrix = true);

/** The sum of squared residuals over the noise alone. [worker] */
double recordingMisfit (const LearningPrior&, const LearningState&, Eigen::Index recording, Eigen::Index samples);
} // namespace antinode
