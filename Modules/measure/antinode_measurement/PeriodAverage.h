#pragma once

#include "EstimatedResponses.h"

#include <vector>

namespace antinode
{
/** The lines of a periodic excitation. */
struct PeriodicLines
{
    Eigen::Index period = 0;           ///< Samples.
    std::vector<Eigen::Index> excited; ///< Ascending.
    bool showsDistortion = false;      ///< The lines between them tell of even and odd distortion.
};

/** Responses to a periodic signal in its steady state: mean output over mean input, line by line, without leakage.

    The variance comes from how periods differ, that of the input and what both share included: with R periods and h =
   Y/X

        E |error|^2 = |h|^2 (s_Y^2 / |Y|^2 + s_X^2 / |X|^2 - 2 Re (s_YX / (Y conj X))) / R.

    @param input    whole periods
    @param outputs  N x as many samples
    @throws InputError  where the length is no whole number of periods, or the input has nothing on a line
    [worker] Pintelon and Schoukens, System Identification, 2012, section 2.5; Docs/Theory.md, section 8.9. */
EstimatedResponses averagePeriods (const PeriodicLines&, const Eigen::VectorXd& input, const Eigen::MatrixXd& outputs);
} // namespace antinode
