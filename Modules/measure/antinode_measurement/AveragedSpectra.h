#pragma once

#include "EstimatedResponses.h"

namespace antinode
{
/** The classical estimators. S_yx = E Y conj X. */
enum class ResponseEstimator
{
    h1, ///< S_yx / S_xx: unbiased by noise at the output.
    h2, ///< S_yy / S_xy: unbiased by noise at the input.
    hv  ///< Their geometric mean, with their common phase.
};

/** Sums over blocks of an input's spectra and those of one output. */
class AveragedSpectra
{
public:
    /** @param input  N_f x N: the lines of N blocks [worker] */
    explicit AveragedSpectra (Eigen::MatrixXcd input);

    /** Whether the input has something on every line. [worker] */
    bool drivesAllLines() const { return powers.minCoeff() > 0; }

    /** Response, coherence and the variance of H1, |H|^2 (1 - gamma^2) / (gamma^2 n), of one sensor, into a column.
       One block fits itself and tells neither coherence nor variance.
        @param output    N_f x N
        @param averages  n, at most N where blocks overlap
        [worker] Bendat and Piersol, Random Data, 2010, section 9.1; Docs/Theory.md, section 8.9. */
    void estimate (const Eigen::MatrixXcd& output, ResponseEstimator, double averages, Eigen::Index column,
                   EstimatedResponses&) const;

private:
    Eigen::MatrixXcd spectra;
    Eigen::ArrayXd powers; ///< S_xx
};
} // namespace antinode
