#include <antinode_numerics/DenseKernels.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tuple>

using namespace antinode;
using Eigen::Index;
using Eigen::MatrixXd;

namespace
{
// What sums of `depth` products of numbers up to 1 may differ by where they are added in another order.
double rounding (Index depth)
{
    return 4 * std::numeric_limits<double>::epsilon() * static_cast<double> (depth + 4);
}

/** to += factor a b, entry by entry. */
MatrixXd added (MatrixXd to, double factor, const MatrixXd& a, const MatrixXd& b)
{
    for (Index i = 0; i < to.rows(); ++i)
        for (Index j = 0; j < to.cols(); ++j)
        {
            double sum = 0;

            for (Index k = 0; k < a.cols(); ++k)
                sum += a (i, k) * b (k, j);

            to (i, j) += factor * sum;
        }

    return to;
}

double largest (const MatrixXd& a)
{
    return a.size() > 0 ? a.cwiseAbs().maxCoeff() : 0;
}

/** A positive definite matrix. */
MatrixXd definite (Index size)
{
    const MatrixXd a = MatrixXd::Random (size, size);
    return a * a.transpose() + static_cast<double> (size) * MatrixXd::Identity (size, size);
}
} // namespace

TEST_CASE ("Products are those of the definition, whatever the sizes and parts of matrices", "[model][processors]")
{
    std::srand (7);

    // Around the sizes of tiles, blocks and of what takes another way.
    for (const auto& [rows, columns, depth] : { std::tuple<Index, Index, Index> { 1, 1, 1 },
                                                { 3, 2, 5 },
                                                { 24, 8, 7 },
                                                { 25, 9, 300 },
                                                { 97, 17, 31 },
                                                { 130, 5, 513 },
                                                { 7, 530, 12 },
                                                { 0, 4, 3 },
                                                { 4, 3, 0 } })
    {
        const MatrixXd a = MatrixXd::Random (rows, depth), b = MatrixXd::Random (depth, columns);
        const MatrixXd at = a.transpose(), bt = b.transpose(), start = MatrixXd::Random (rows, columns);
        const auto expected = added (start, -0.7, a, b);
        MatrixXd whole = MatrixXd::Random (rows + 5, columns + 3), before = whole;
        whole.block (2, 1, rows, columns) = start;
        before.block (2, 1, rows, columns) = expected;
        addProduct (whole.block (2, 1, rows, columns), -0.7, a, b);
        CHECK (largest (whole - before) <= rounding (depth));
        MatrixXd to = start;
        addTransposedLeft (to, -0.7, at, b);
        CHECK (largest (to - expected) <= rounding (depth));
        to = start;
        addTransposedRight (to, -0.7, a, bt);
        CHECK (largest (to - expected) <= rounding (depth));
        const MatrixXd square = MatrixXd::Random (rows, rows);
        MatrixXd lower = square, full = added (square, 2, a, at);
        addGram (lower, 2, a);
        full.triangularView<Eigen::StrictlyUpper>() = square;
        CHECK (largest (lower - full) <= 2 * rounding (depth));
    }
}

TEST_CASE ("Triangles and factors undo what they are made of", "[model][processors]")
{
    std::srand (8);

    for (const Index size : { 1, 2, 31, 32, 33, 65, 150 })
    {
        const auto a = definite (size);
        MatrixXd factor = a;
        factor.triangularView<Eigen::StrictlyUpper>().setConstant (std::numeric_limits<double>::quiet_NaN());
        REQUIRE (factorLower (factor));
        const MatrixXd lower = factor.triangularView<Eigen::Lower>();
        CHECK (largest (lower * lower.transpose() - a) <= rounding (size) * largest (a));

        const MatrixXd x = MatrixXd::Random (size, 3);
        MatrixXd y = lower * x;
        solveLower (factor, y);
        CHECK (largest (y - x) <= 10 * rounding (size));
        y = lower.transpose() * x;
        solveLowerTransposed (factor, y);
        CHECK (largest (y - x) <= 10 * rounding (size));

        // With ones on the diagonal; small beside it, so that the inverse is not large.
        const MatrixXd parts = MatrixXd::Random (size, size) / static_cast<double> (size);
        const MatrixXd unit = parts.triangularView<Eigen::UnitLower>();
        y = unit * x;
        solveUnitLower (parts, y);
        CHECK (largest (y - x) <= 10 * rounding (size));
        y = unit.transpose() * x;
        solveUnitLowerTransposed (parts, y);
        CHECK (largest (y - x) <= 10 * rounding (size));
        MatrixXd z = x.transpose() * unit.transpose();
        solveUnitLowerTransposedFromRight (parts, z);
        CHECK (largest (z - x.transpose()) <= 10 * rounding (size));
    }

    MatrixXd indefinite = -definite (70);
    CHECK_FALSE (factorLower (indefinite));
    indefinite = definite (70);
    indefinite (60, 60) = -1;
    CHECK_FALSE (factorLower (indefinite));
}

TEST_CASE ("Eigenpairs are orthonormal and put the matrix together again", "[model][processors]")
{
    std::srand (9);
    const auto check = [] (const MatrixXd& a)
    {
        MatrixXd lower = a.triangularView<Eigen::Lower>();
        const auto [values, vectors] = symmetricEigen (lower);
        const auto size = a.rows();
        CHECK (std::is_sorted (values.begin(), values.end()));
        CHECK (largest (vectors.transpose() * vectors - MatrixXd::Identity (size, size)) <= 10 * rounding (size));
        CHECK (largest (vectors * values.asDiagonal() * vectors.transpose() - a) <= 10 * rounding (size) * largest (a));
    };

    for (const Index size : { 1, 2, 3, 33, 100 })
    {
        const MatrixXd a = MatrixXd::Random (size, size);
        check (a + a.transpose());
        check (a * a.transpose() * 1e-200);
        check (MatrixXd::Identity (size, size));
        check (MatrixXd::Zero (size, size));
        check (a.col (0) * a.col (0).transpose());
    }

    // 2 - 2 cos (k pi / (n + 1)): a chain of springs.
    constexpr Index links = 50;
    MatrixXd chain = 2 * MatrixXd::Identity (links, links);
    chain.diagonal (1).setConstant (-1);
    chain.diagonal (-1).setConstant (-1);
    const auto values = symmetricEigen (chain).values;

    for (Index k = 0; k < links; ++k)
        CHECK (values[k]
               == Approx (2 - 2 * std::cos (static_cast<double> (k + 1) * std::numbers::pi / (links + 1)))
                      .epsilon (1e-12));

    CHECK_THROWS_AS (symmetricEigen (MatrixXd::Constant (3, 3, std::nan (""))), std::runtime_error);
}
