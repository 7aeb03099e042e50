#pragma once

#include "FreeGrams.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** What each ceramic's own parts of the rows add to a Newton step of WaveformDual: they meet those of other ceramics in
    the rows alone, so each ceramic's are eliminated by themselves. Docs/Theory.md, section 7.5. */
class OwnRows
{
public:
    /** @param spread         N_r x N_b, at least 0; 0: no such row. Outlives this
        @param participation  N_r x N_b, outlives this [any] */
    OwnRows (const Eigen::MatrixXd& spread, const Eigen::MatrixXd& participation);

    /** Factors 1 + S G S of each ceramic, S its spread, on all cores where it pays.
        @param grams  that follow the samples of this step
        @return       N_b matrices G - G S (1 + S G S)^-1 S G, N_r x N_r: the rows' Gram matrix as it is when own parts
                      follow; lower triangles
        [worker] */
    std::vector<Eigen::MatrixXd> eliminate (const FreeGrams& grams);

    /** What slopes of own rows take from the slope of the rows, N_r. @param slope  N_r x N_b [worker] */
    Eigen::VectorXd takenBySlope (const Eigen::MatrixXd& slope) const;

    /** The step of own rows, N_r x N_b. @param slope  theirs, N_r x N_b @param step  of the rows, N_r [worker] */
    Eigen::MatrixXd steps (const Eigen::MatrixXd& slope, const Eigen::VectorXd& step) const;

private:
    struct Part
    {
        std::vector<Eigen::Index> rows; ///< Those of spread above 0.
        Eigen::MatrixXd factor;         ///< L, with 1 + S G S = L L'.
        Eigen::MatrixXd coupling;       ///< L^-1 S G, rows x N_r.
    };

    Eigen::MatrixXd eliminateOne (Part&, const Eigen::MatrixXd& gram, Eigen::Index ceramic) const;

    const Eigen::MatrixXd &spread, &participation;
    std::vector<Part> parts;
};
} // namespace antinode
