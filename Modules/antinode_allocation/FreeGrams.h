#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** W W' over the samples that are not at their limit, for each ceramic: kept from one Newton step to the next, of which
    each changes few samples only. Docs/Theory.md, section 4.9. */
class FreeGrams
{
public:
    /** All samples are free. @param weightsToUse  N_r x N_s, outlives this
        @param wholeGram  N_r x N_r, the lower triangle of W W' over all samples; outlives this [worker] */
    FreeGrams (const Eigen::MatrixXd& weightsToUse, const Eigen::MatrixXd& wholeGram, Eigen::Index ceramics);

    /** Takes the samples that pulls leave within their caps, both N_b x N_s, on all cores where it pays. [worker] */
    void follow (const Eigen::MatrixXd& pulls, const Eigen::MatrixXd& caps);

    /** N_r x N_r, the lower triangle. [any] */
    const Eigen::MatrixXd& of (Eigen::Index ceramic) const;

private:
    struct Part
    {
        std::vector<char> isFree; ///< Of each sample.
        Eigen::MatrixXd gram;     ///< Empty: all samples are free.
    };

    void followOne (Part&, const Eigen::MatrixXd& pulls, const Eigen::MatrixXd& caps, Eigen::Index ceramic) const;

    const Eigen::MatrixXd &weights, &whole;
    std::vector<Part> parts;
};
} // namespace antinode
