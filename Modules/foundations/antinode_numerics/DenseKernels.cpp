#include "DenseKernels.h"

#include "MatrixKernel.h"

#include <Eigen/Cholesky>

#include <complex>

namespace antinode
{
Eigen::MatrixXcd productTransposedLeft (const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b)
{
    const Eigen::MatrixXd aReal = a.real(), aImaginary = a.imag(), bReal = b.real(), bImaginary = b.imag();
    Eigen::MatrixXd real = Eigen::MatrixXd::Zero (a.cols(), b.cols()), imaginary = real;
    addTransposedLeft (real, 1, aReal, bReal);
    addTransposedLeft (real, -1, aImaginary, bImaginary);
    addTransposedLeft (imaginary, 1, aReal, bImaginary);
    addTransposedLeft (imaginary, 1, aImaginary, bReal);
    Eigen::MatrixXcd result (a.cols(), b.cols());
    result.real() = real;
    result.imag() = imaginary;
    return result;
}

Eigen::MatrixXcd adjointGram (const Eigen::MatrixXcd& a)
{
    const Eigen::MatrixXd real = a.real(), imaginary = a.imag();
    Eigen::MatrixXd symmetric = Eigen::MatrixXd::Zero (a.cols(), a.cols()), half = symmetric;
    addTransposedLeft (symmetric, 1, real, real);
    addTransposedLeft (symmetric, 1, imaginary, imaginary);
    addTransposedLeft (half, 1, real, imaginary);
    Eigen::MatrixXcd result (a.cols(), a.cols());
    result.real() = symmetric;
    result.imag() = half - half.transpose();
    return result;
}

bool factorLower (Eigen::MatrixXcd& a)
{
    return Eigen::internal::llt_inplace<std::complex<double>, Eigen::Lower>::unblocked (a) < 0;
}

void solveLower (const Eigen::MatrixXcd& a, Eigen::MatrixXcd& x)
{
    a.triangularView<Eigen::Lower>().solveInPlace (x);
}

namespace
{
/** Up to this size triangles are left to Eigen; larger ones are halved, so that most of the work is products. */
constexpr Eigen::Index smallTriangle = 32;

MatrixInMemory inMemory (const MatrixIn& a)
{
    return { a.data(), 1, a.outerStride() };
}

MatrixInMemory transposed (const MatrixIn& a)
{
    return { a.data(), a.outerStride(), 1 };
}

void product (MatrixOut& to, Eigen::Index depth, double factor, const MatrixInMemory& a, const MatrixInMemory& b,
              bool isLowerOnly)
{
    if (to.size() > 0 && depth > 0)
        addProductInMemory ({ to.data(), to.outerStride(), to.rows(), to.cols(), isLowerOnly }, depth, factor, a, b);
}

/** Solves with L on the left by halves. */
template <unsigned int triangle>
void solveLeft (const MatrixIn& a, MatrixOut x)
{
    if (a.rows() <= smallTriangle || x.cols() == 1)
    {
        a.triangularView<triangle>().solveInPlace (x);
        return;
    }

    const auto half = a.rows() / 2, rest = a.rows() - half;
    solveLeft<triangle> (a.topLeftCorner (half, half), x.topRows (half));
    addProduct (x.bottomRows (rest), -1, a.bottomLeftCorner (rest, half), x.topRows (half));
    solveLeft<triangle> (a.bottomRightCorner (rest, rest), x.bottomRows (rest));
}

/** Solves with L' on the left by halves. */
template <unsigned int triangle>
void solveLeftTransposed (const MatrixIn& a, MatrixOut x)
{
    if (a.rows() <= smallTriangle || x.cols() == 1)
    {
        a.triangularView<triangle>().transpose().solveInPlace (x);
        return;
    }

    const auto half = a.rows() / 2, rest = a.rows() - half;
    solveLeftTransposed<triangle> (a.bottomRightCorner (rest, rest), x.bottomRows (rest));
    addTransposedLeft (x.topRows (half), -1, a.bottomLeftCorner (rest, half), x.bottomRows (rest));
    solveLeftTransposed<triangle> (a.topLeftCorner (half, half), x.topRows (half));
}

/** Solves with L' on the right by halves. */
template <unsigned int triangle>
void solveRightTransposed (const MatrixIn& a, MatrixOut x)
{
    if (a.rows() <= smallTriangle || x.rows() == 1)
    {
        a.triangularView<triangle>().transpose().template solveInPlace<Eigen::OnTheRight> (x);
        return;
    }

    const auto half = a.rows() / 2, rest = a.rows() - half;
    solveRightTransposed<triangle> (a.topLeftCorner (half, half), x.leftCols (half));
    addTransposedRight (x.rightCols (rest), -1, x.leftCols (half), a.bottomLeftCorner (rest, half));
    solveRightTransposed<triangle> (a.bottomRightCorner (rest, rest), x.rightCols (rest));
}

bool factor (MatrixOut a)
{
    if (a.rows() <= smallTriangle)
    {
        const auto failed = Eigen::internal::llt_inplace<double, Eigen::Lower>::unblocked (a);

        if (failed >= 0)
            a (failed, failed) = 0;

        return failed < 0;
    }

    const auto half = a.rows() / 2, rest = a.rows() - half;

    if (! factor (a.topLeftCorner (half, half)))
        return false;

    solveRightTransposed<Eigen::Lower> (a.topLeftCorner (half, half), a.bottomLeftCorner (rest, half));
    addGram (a.bottomRightCorner (rest, rest), -1, a.bottomLeftCorner (rest, half));
    return factor (a.bottomRightCorner (rest, rest));
}
} // namespace

void addProduct (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b)
{
    product (to, a.cols(), factor, inMemory (a), inMemory (b), false);
}

void addTransposedLeft (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b)
{
    product (to, a.rows(), factor, transposed (a), inMemory (b), false);
}

void addTransposedRight (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b)
{
    product (to, a.cols(), factor, inMemory (a), transposed (b), false);
}

void addGram (MatrixOut to, double factor, const MatrixIn& a)
{
    product (to, a.cols(), factor, inMemory (a), transposed (a), true);
}

bool factorLower (Eigen::MatrixXd& a)
{
    return a.rows() == 0 || factor (a);
}

void solveLower (const MatrixIn& a, MatrixOut x)
{
    if (x.size() > 0)
        solveLeft<Eigen::Lower> (a, x);
}
void solveLowerTransposed (const MatrixIn& a, MatrixOut x)
{
    if (x.size() > 0)
        solveLeftTransposed<Eigen::Lower> (a, x);
}
void solveLowerTransposedFromRight (const MatrixIn& a, MatrixOut x)
{
    if (x.size() > 0)
        solveRightTransposed<Eigen::Lower> (a, x);
}
Eigen::MatrixXd solveFactored (const MatrixIn& a, Eigen::MatrixXd right)
{
    solveLower (a, right);
    solveLowerTransposed (a, right);
    return right;
}
void solveUnitLower (const MatrixIn& a, MatrixOut x)
{
    if (x.size() > 0)
        solveLeft<Eigen::UnitLower> (a, x);
}
void solveUnitLowerTransposed (const MatrixIn& a, MatrixOut x)
{
    if (x.size() > 0)
        solveLeftTransposed<Eigen::UnitLower> (a, x);
}
void solveUnitLowerTransposedFromRight (const MatrixIn& a, MatrixOut x)
{
    if (x.size() > 0)
        solveRightTransposed<Eigen::UnitLower> (a, x);
}

} // namespace antinode
