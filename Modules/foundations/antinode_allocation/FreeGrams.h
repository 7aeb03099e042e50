#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** W W' over the samples that are not at their limit, for each ceramic: kept from one Newton step to the next, of which
    each changes few samples only. A ceramic with few samples at their limit keeps these instead: what they take from
    the whole is a product of few columns. Docs/Theory.md, section 4.9. */
class FreeGrams
{
public:
    /** All samples are free. @param weightsToUse  N_r x N_s, outlives this
        @param wholeGram  N_r x N_r, the lower triangle of W W' over all samples; outlives this
        @param mostHeld   so many samples at their limit are few; 0 where of() is asked for each ceramic [worker] */
    FreeGrams (const Eigen::MatrixXd& weightsToUse, const Eigen::MatrixXd& wholeGram, Eigen::Index ceramics,
               std::size_t mostHeld = 0);

    /** Takes the samples that pulls leave within their caps, both N_b x N_s, on all cores where it pays. [worker] */
    void follow (const Eigen::MatrixXd& pulls, const Eigen::MatrixXd& caps);

    /** N_r x N_r, the lower triangle. [any] */
    const Eigen::MatrixXd& of (Eigen::Index ceramic) const;

    /** to += sum_i p_i p_i' times the matrix of ceramic i, element by element; the lower triangle.
        @param participation  N_r x N_b, its columns are the p_i [worker] */
    void addWeighted (Eigen::MatrixXd& to, const Eigen::MatrixXd& participation) const;

private:
    struct Part
    {
        std::vector<char> isFree;       ///< Of each sample.
        std::vector<Eigen::Index> held; ///< The samples at their limit, where they are few.
        Eigen::MatrixXd gram;           ///< Empty: that of all samples but those held.

        bool isFew() const { return gram.size() == 0; }
    };

    void followOne (Part&, const Eigen::MatrixXd& pulls, const Eigen::MatrixXd& caps, Eigen::Index ceramic) const;
    void addFew (Eigen::MatrixXd& to, const Eigen::MatrixXd& participation) const;

    const Eigen::MatrixXd &weights, &whole;
    std::size_t few;
    std::vector<Part> parts;
};

/** to += p p' times a matrix, element by element; the lower triangles. [any] */
void addWeightedLower (Eigen::MatrixXd& to, const Eigen::Ref<const Eigen::VectorXd>& p, const Eigen::MatrixXd& matrix);
} // namespace antinode
