#pragma once

#include "FeltLines.h"
#include "QuietBasis.h"

#include <vector>

namespace antinode
{
/** The felt level elsewhere of voltages and corrections: one column of 2 N_f values a row of the lines, whose squares
   add up to the energy. N_f lines of frequency, N_p rows of the lines. [worker] Docs/Theory.md, section 4.14. */
class FeltElsewhere
{
public:
    FeltElsewhere (FeltLines linesToUse, const QuietBasis& basis, const Eigen::MatrixXd& participation,
                   double sampleRate);

    /** @param samples  N_b x samples, V. @return  2 N_f x N_p */
    Eigen::MatrixXd ofSamples (const Eigen::MatrixXd& samples, double sampleRate) const;
    Eigen::MatrixXd ofCorrection (const QuietCorrection& change) const;

    /** The slope of half of the energy of what is felt. */
    QuietCorrection slope (const Eigen::MatrixXd& felt) const;

private:
    Eigen::MatrixXd ofSpectra (const Eigen::MatrixXd& spectra) const;

    FeltLines lines;
    Eigen::MatrixXd splines;           // N_l x 2 N_f
    std::vector<Eigen::MatrixXd> rows; // Of each row of the lines: 2 N_f x N_r.
};
} // namespace antinode
