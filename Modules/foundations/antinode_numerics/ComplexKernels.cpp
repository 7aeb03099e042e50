#include "ComplexKernels.h"

#include "DenseKernels.h"

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
} // namespace antinode
