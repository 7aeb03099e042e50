#include "Householder.h"

#include "DenseKernels.h"

#include <antinode_base/Watch.h>

#include <Eigen/Householder>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr Eigen::Index reflectionsAtOnce = 32;

/** The product of some reflections, 1 - V T V': what they do together is mostly products of large matrices. Reflection
   j is 1 - factor (j) v v', v 0 above place j and 1 there, and below as given. Schreiber, Van Loan, A storage-efficient
   WY representation, SIAM J. Sci. Stat. Comput. 10 (1989). */
class Reflections
{
public:
    Reflections (const MatrixIn& below, const Eigen::VectorXd& factors)
        : v (below), t (Eigen::MatrixXd::Zero (factors.size(), factors.size()))
    {
        v.triangularView<Eigen::StrictlyUpper>().setZero();
        v.diagonal().setOnes();
        Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (v.cols(), v.cols());
        addTransposedLeft (gram, 1, v, v);

        for (Eigen::Index j = 0; j < t.cols(); ++j)
        {
            t.col (j).head (j) = -factors[j] * (t.topLeftCorner (j, j) * gram.col (j).head (j));
            t (j, j) = factors[j];
        }
    }

    void applyTo (MatrixOut x) const { apply (x, t); }
    void applyTransposedTo (MatrixOut x) const { apply (x, t.transpose()); }

private:
    void apply (MatrixOut x, const Eigen::MatrixXd& middle) const
    {
        Eigen::MatrixXd seen = Eigen::MatrixXd::Zero (v.cols(), x.cols());
        addTransposedLeft (seen, 1, v, x);
        addProduct (x, -1, v, middle * seen);
    }

    Eigen::MatrixXd v, t;
};

/** Reduces a panel to its triangle, with what the reflections take below it. @return  their factors */
Eigen::VectorXd reducePanel (MatrixOut panel)
{
    Eigen::VectorXd factors (panel.cols()), workspace (panel.cols());

    for (Eigen::Index j = 0; j < panel.cols(); ++j)
    {
        checkWatch();
        const auto below = panel.rows() - j, beside = panel.cols() - j - 1;
        double length = 0;
        panel.col (j).tail (below).makeHouseholderInPlace (factors[j], length);
        panel (j, j) = length;
        panel.bottomRightCorner (below, beside)
            .applyHouseholderOnTheLeft (panel.col (j).tail (below - 1), factors[j], workspace.data());
    }

    return factors;
}
} // namespace

Eigen::MatrixXd householderTriangle (Eigen::MatrixXd columns)
{
    const auto filled = std::min (columns.rows(), columns.cols());

    for (Eigen::Index first = 0; first < filled; first += reflectionsAtOnce)
    {
        const auto count = std::min (reflectionsAtOnce, filled - first), rows = columns.rows() - first;
        const auto others = columns.cols() - first - count;
        const auto factors = reducePanel (columns.block (first, first, rows, count));

        if (others > 0)
            Reflections (columns.block (first, first, rows, count), factors)
                .applyTransposedTo (columns.bottomRightCorner (rows, others));
    }

    return columns.topRows (filled).triangularView<Eigen::Upper>();
}

Tridiagonal tridiagonalise (Eigen::MatrixXd& a)
{
    const auto size = a.rows();
    Tridiagonal t { {}, Eigen::VectorXd (size - 1), Eigen::VectorXd (size - 1) };
    Eigen::VectorXd change;

    for (Eigen::Index j = 0; j + 1 < size; ++j)
    {
        checkWatch();
        const auto rest = size - j - 1;
        auto v = a.col (j).tail (rest);
        v.makeHouseholderInPlace (t.factors[j], t.beside[j]);
        v[0] = 1;
        auto part = a.bottomRightCorner (rest, rest);
        change.noalias() = part.selfadjointView<Eigen::Lower>() * (t.factors[j] * v);
        change -= 0.5 * t.factors[j] * change.dot (v) * v;
        part.selfadjointView<Eigen::Lower>().rankUpdate (v, change, -1);
    }

    t.diagonal = a.diagonal();
    return t;
}

Eigen::MatrixXd accumulateReflections (const Eigen::MatrixXd& a, const Tridiagonal& t)
{
    const auto size = a.rows();
    Eigen::MatrixXd vectors = Eigen::MatrixXd::Identity (size, size);

    // Backwards, so that each block finds only rows and columns that the later ones have filled.
    for (auto end = size - 1; end > 0;)
    {
        const auto first = (end - 1) / reflectionsAtOnce * reflectionsAtOnce, count = end - first;
        const auto rest = size - first - 1;
        Reflections (a.block (first + 1, first, rest, count), t.factors.segment (first, count))
            .applyTo (vectors.bottomRightCorner (rest, rest));
        end = first;
    }

    return vectors;
}
} // namespace antinode
