#pragma once

#include "FocusDescription.h"
#include "QuietWaveform.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** The felt level elsewhere, line by line of frequency: the mean over places of the energy of the displacement in
   thresholds over the whole event is the sum over lines and rows of |row (line)' U (line)|^2, s, where U (line) =
   integral U (t) exp (-j 2 pi f t) dt. There are as many rows as places, or as the mode shapes elsewhere need. */
struct FeltLines
{
    Eigen::VectorXd frequencies;                  ///< N_f, Hz, even.
    std::vector<Eigen::MatrixXd> real, imaginary; ///< Of each row: N_b x N_f, s^1/2 / (V s).
};

/** @param duration  s, for which voltages last; lines are so near to each other that the ringing is told apart
    @throws InputError  where there is no place elsewhere, or one outside the surface; or where modes are complex
    [worker] Docs/Theory.md, section 4.14. */
FeltLines feltLines (const ModalModel&, const FocusDescription&, double duration);

/** Spectra of samples, one waveform a row: integral exp (-j 2 pi f t) dt on these lines, real parts before imaginary
   ones. N x 2 N_f, s times the samples' unit. [worker] */
Eigen::MatrixXd spectraOn (const FeltLines&, const Eigen::MatrixXd& samples, double sampleRate);

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
