#pragma once

#include "IdentifiedModes.h"

namespace antinode
{
/** What a person looks at to judge an identification, beside its poles (IdentifiedModes::stabilisation and candidates).
   Only lines that were used for the modes. N_f lines, N_p points, N_b references. */
struct FitDiagram
{
    FrequencyResponses measured, synthesised; ///< At the same N_f lines.
    Eigen::MatrixXd indicator;    ///< N_f x min (N_p, N_b): complex mode indicator function, descending in each row.
    Eigen::VectorXd measuredSize; ///< N_f: RMS over points and references, (m/s)/V or (m/s)/N.
    Eigen::VectorXd errorSize;    ///< N_f: the same of measured minus synthesised.
    Eigen::Index usedLines = 0;   ///< How many lines were used; N_f where all are here.
};

/** The complex mode indicator function: singular values of the matrix of responses of each line. As many of them stand
   out at a resonance as modes are there. Values that are not finite count as 0.
    @return  N_f x min (N_p, N_b), descending in each row
    [worker] Shih et al., Mechanical Systems and Signal Processing 2 (1988) 367. */
Eigen::MatrixXd modeIndicator (const FrequencyResponses&);

/** The noise of one response around each line, as the RMS of its values, from second differences over neighbouring
   lines: those of white noise have six times its energy. Their median over 25 lines ignores resonances.
    @param values  N_f, lines that follow each other
    @return        N_f
    [any] */
Eigen::VectorXd localNoise (const Eigen::VectorXcd& values);

/** The diagram of these modes and responses.
    @param largest  most values of responses; if there are more, the least telling lines are left out
    [worker] */
FitDiagram fitDiagram (const FrequencyResponses&, const IdentifiedModes&, Eigen::Index largest);

/** The lines that were used for the modes, as indices. [any] */
std::vector<Eigen::Index> usedLines (const FrequencyResponses&, const IdentifiedModes&);

/** At most so many of these lines, the first and the last among them: their density follows the narrowest half width
   near them, so that every resonance keeps its form. All of them if they are no more than that.
    @param count  at least 2
    @return       ascending
    [any] */
std::vector<Eigen::Index> thinnedLines (const std::vector<Eigen::Index>&, const FrequencyResponses&,
                                        const IdentifiedModes&, Eigen::Index count);

/** The responses at some of their lines. [worker] */
FrequencyResponses atLines (const FrequencyResponses&, const std::vector<Eigen::Index>&);
} // namespace antinode
