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
