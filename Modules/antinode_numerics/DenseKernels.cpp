#include "DenseKernels.h"

#include <cblas.h>

#include <mutex>
#include <stdexcept>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): LAPACK names it.
extern "C" void dsyevd_ (const char* job, const char* triangle, const int* size, double* matrix, const int* stride,
                         double* values, double* work, const int* workSize, int* integerWork,
                         const int* integerWorkSize, int* info);

// NOLINTNEXTLINE(readability-identifier-naming): LAPACK names it.
extern "C" void dpotrf_ (const char* triangle, const int* size, double* matrix, const int* stride, int* info);

namespace antinode
{
namespace
{
/** Debian's OpenBLAS without threads hands its work memory to whoever calls: two threads at once would compute in the same memory. */
std::unique_lock<std::mutex> alone()
{
    static std::mutex mutex;
    return std::unique_lock (mutex);
}

int asInt (Eigen::Index index)
{
    return static_cast<int> (index);
}

void product (MatrixOut& to, double factor, const MatrixIn& a, CBLAS_TRANSPOSE aOrder, const MatrixIn& b,
              CBLAS_TRANSPOSE bOrder)
{
    const auto depth = aOrder == CblasNoTrans ? a.cols() : a.rows();

    if (to.size() == 0 || depth == 0)
        return;

    const auto lock = alone();
    cblas_dgemm (CblasColMajor, aOrder, bOrder, asInt (to.rows()), asInt (to.cols()), asInt (depth), factor, a.data(),
                 asInt (a.outerStride()), b.data(), asInt (b.outerStride()), 1, to.data(), asInt (to.outerStride()));
}

void triangle (CBLAS_SIDE side, CBLAS_UPLO part, CBLAS_TRANSPOSE order, CBLAS_DIAG diagonal, const MatrixIn& a,
               MatrixOut& x)
{
    if (x.size() == 0)
        return;

    const auto lock = alone();
    cblas_dtrsm (CblasColMajor, side, part, order, diagonal, asInt (x.rows()), asInt (x.cols()), 1, a.data(),
                 asInt (a.outerStride()), x.data(), asInt (x.outerStride()));
}
} // namespace

void keepToOneThread()
{
    const auto lock = alone();
    openblas_set_num_threads (1);
}

void addProduct (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b)
{
    product (to, factor, a, CblasNoTrans, b, CblasNoTrans);
}

void addTransposedLeft (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b)
{
    product (to, factor, a, CblasTrans, b, CblasNoTrans);
}

void addTransposedRight (MatrixOut to, double factor, const MatrixIn& a, const MatrixIn& b)
{
    product (to, factor, a, CblasNoTrans, b, CblasTrans);
}

void addGram (MatrixOut to, double factor, const MatrixIn& a)
{
    if (a.size() == 0)
        return;

    const auto lock = alone();
    cblas_dsyrk (CblasColMajor, CblasLower, CblasNoTrans, asInt (to.rows()), asInt (a.cols()), factor, a.data(),
                 asInt (a.outerStride()), 1, to.data(), asInt (to.outerStride()));
}

bool factorLower (Eigen::MatrixXd& a)
{
    const int size = asInt (a.rows());
    int info = 0;
    const auto lock = alone();

    if (size > 0)
        dpotrf_ ("L", &size, a.data(), &size, &info);

    return info == 0;
}

void solveLower (const MatrixIn& a, MatrixOut x)
{
    triangle (CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, a, x);
}

void solveLowerTransposed (const MatrixIn& a, MatrixOut x)
{
    triangle (CblasLeft, CblasLower, CblasTrans, CblasNonUnit, a, x);
}

void solveUnitLower (const MatrixIn& a, MatrixOut x)
{
    triangle (CblasLeft, CblasLower, CblasNoTrans, CblasUnit, a, x);
}

void solveUnitLowerTransposed (const MatrixIn& a, MatrixOut x)
{
    triangle (CblasLeft, CblasLower, CblasTrans, CblasUnit, a, x);
}

void solveUnitLowerTransposedFromRight (const MatrixIn& a, MatrixOut x)
{
    triangle (CblasRight, CblasLower, CblasTrans, CblasUnit, a, x);
}

void solveUpperFromRight (const MatrixIn& a, MatrixOut x)
{
    triangle (CblasRight, CblasUpper, CblasNoTrans, CblasNonUnit, a, x);
}

SymmetricEigen symmetricEigen (Eigen::MatrixXd a)
{
    SymmetricEigen result { Eigen::VectorXd (a.rows()), {} };
    const int size = asInt (a.rows());
    const auto lock = alone();
    int info = 0, askSize = -1, integerSize = 0;
    double workSize = 0;
    dsyevd_ ("V", "L", &size, a.data(), &size, result.values.data(), &workSize, &askSize, &integerSize, &askSize,
             &info);

    const auto realSize = static_cast<int> (workSize);
    std::vector<double> work (static_cast<std::size_t> (realSize));
    std::vector<int> integerWork (static_cast<std::size_t> (integerSize));
    dsyevd_ ("V", "L", &size, a.data(), &size, result.values.data(), work.data(), &realSize, integerWork.data(),
             &integerSize, &info);

    if (info != 0)
        throw std::runtime_error ("the eigenvalue solver for symmetric matrices did not converge");

    result.vectors = std::move (a);
    return result;
}
} // namespace antinode
