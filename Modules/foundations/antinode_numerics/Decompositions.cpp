#include "Decompositions.h"

#include "DenseKernels.h"
#include "MatrixKernel.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Householder>
#include <Eigen/QR>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace antinode
{
std::optional<SymmetricEigen> generalizedEigen (Eigen::MatrixXd a, Eigen::MatrixXd b)
{
    if (! factorLower (b))
        return std::nullopt;

    // C = L^-1 A L'^-1 has the same eigenvalues.
    a = Eigen::MatrixXd (a.selfadjointView<Eigen::Lower>());
    solveLower (b, a);
    solveLowerTransposedFromRight (b, a);

    if (! a.allFinite())
        return std::nullopt;

    auto eigen = symmetricEigen (std::move (a));
    solveLowerTransposed (b, eigen.vectors);
    return eigen;
}

ComplexEigenpair largestEigenpair (const Eigen::MatrixXcd& a)
{
    // The real matrix of the same map has each eigenvalue twice; any vector of the largest one serves.
    const auto size = a.rows();
    Eigen::MatrixXd real (2 * size, 2 * size);
    real << a.real(), -a.imag(), a.imag(), a.real();
    const auto [values, vectors] = symmetricEigen (std::move (real));
    ComplexEigenpair pair { values[2 * size - 1], Eigen::VectorXcd (size) };
    pair.vector.real() = vectors.col (2 * size - 1).head (size);
    pair.vector.imag() = vectors.col (2 * size - 1).tail (size);
    return pair;
}

Eigen::MatrixXd solveSemidefinite (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return a.ldlt().solve (b);
}

PivotedFactor pivotedFactor (const Eigen::MatrixXd& a)
{
    const auto factor = a.ldlt();
    const Eigen::MatrixXd triangle = factor.matrixL();
    return { factor.vectorD(), factor.transpositionsP().transpose() * triangle };
}

Eigen::MatrixXd orthogonalTriangle (const Eigen::MatrixXd& columns)
{
    const auto size = columns.cols(), filled = std::min (size, columns.rows());
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero (size, size);
    triangle.topRows (filled) = householderTriangle (columns);
    return triangle;
}

Eigen::MatrixXd nullSpace (const Eigen::MatrixXd& rows)
{
    const auto size = rows.cols();
    Eigen::MatrixXd basis = Eigen::MatrixXd::Identity (size, size).rightCols (size - rows.rows());

    if (rows.rows() > 0)
        basis.applyOnTheLeft (Eigen::HouseholderQR<Eigen::MatrixXd> (rows.transpose()).householderQ());

    return basis;
}

Eigen::VectorXd leastSquares (const Eigen::MatrixXd& a, const Eigen::VectorXd& b)
{
    constexpr Eigen::Index many = 64; // columns, from which on blocks of them are quicker
    const auto size = a.cols();

    if (size < many || a.rows() < 2 * size)
        return a.completeOrthogonalDecomposition().solve (b);

    // The triangle of both is the same problem with as many rows as columns.
    Eigen::MatrixXd both (a.rows(), size + 1);
    both << a, b;
    const auto triangle = orthogonalTriangle (both);
    return triangle.topLeftCorner (size, size)
        .completeOrthogonalDecomposition()
        .solve (triangle.col (size).head (size));
}

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

std::optional<Eigen::VectorXcd> complexEigenvalues (const Eigen::MatrixXcd& a)
{
    const Eigen::ComplexSchur<Eigen::MatrixXcd> schur (a, false);

    if (schur.info() != Eigen::Success)
        return std::nullopt;

    return Eigen::VectorXcd (schur.matrixT().diagonal());
}

Eigen::MatrixXcd solveSemidefinite (const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b)
{
    return a.ldlt().solve (b);
}

namespace
{
/** Wilkinson's shift: the eigenvalue of the last 2 x 2 that lies nearer its last entry. */
double shiftAt (const Tridiagonal& t, Eigen::Index end)
{
    const auto half = 0.5 * (t.diagonal[end - 1] - t.diagonal[end]), off = t.beside[end - 1];
    const auto length = std::hypot (half, off);
    return off == 0 ? t.diagonal[end] : t.diagonal[end] - off / (half + (half > 0 ? length : -length)) * off;
}

/** One implicit QR step on rows start to end; its rotations are put behind those there are. Golub, Van Loan, Matrix
   Computations, algorithm 8.3.2. */
void step (Tridiagonal& t, Eigen::Index start, Eigen::Index end, std::vector<PlaneRotation>& rotations)
{
    auto& d = t.diagonal;
    auto& e = t.beside;
    auto x = d[start] - shiftAt (t, end), z = e[start];

    for (auto k = start; k < end && z != 0; ++k)
    {
        const auto length = std::hypot (x, z), c = x / length, s = -z / length;
        const auto a = d[k], b = e[k], f = d[k + 1];

        if (k > start)
            e[k - 1] = length;

        d[k] = c * c * a - 2 * c * s * b + s * s * f;
        d[k + 1] = s * s * a + 2 * c * s * b + c * c * f;
        e[k] = c * s * (a - f) + (c * c - s * s) * b;
        rotations.push_back ({ k, c, s });
        x = e[k];

        if (k + 1 < end)
        {
            z = -s * e[k + 1];
            e[k + 1] *= c;
        }
    }
}

/** Brings a tridiagonal matrix to its eigenvalues, with the rotations that do so.
    @throws std::runtime_error  where 30 steps an eigenvalue are not enough */
std::vector<PlaneRotation> diagonalise (Tridiagonal& t)
{
    constexpr auto epsilon = std::numeric_limits<double>::epsilon();
    constexpr auto smallest = std::numeric_limits<double>::min();
    std::vector<PlaneRotation> rotations;
    const auto isNothing = [&] (Eigen::Index k) {
        return std::abs (t.beside[k]) <= smallest + epsilon * (std::abs (t.diagonal[k]) + std::abs (t.diagonal[k + 1]));
    };
    auto end = t.diagonal.size() - 1;
    auto stepsLeft = 30 * t.diagonal.size();

    while (end > 0)
    {
        if (isNothing (end - 1))
        {
            --end;
            continue;
        }

        auto start = end - 1;

        while (start > 0 && ! isNothing (start - 1))
            --start;

        if (stepsLeft-- == 0)
            throw std::runtime_error ("eigenvalues of a symmetric matrix: no convergence");

        checkWatch();
        step (t, start, end, rotations);
    }

    return rotations;
}

/** Between two looks at the watch: some hundred microseconds. */
constexpr std::size_t rotationsAtOnce = 16384;

/** The columns of a matrix turned, strip of rows by strip. */
void rotateAll (Eigen::MatrixXd& vectors, const std::vector<PlaneRotation>& rotations)
{
    Eigen::MatrixXd strip = Eigen::MatrixXd::Zero (rotationRows, vectors.cols());

    for (Eigen::Index first = 0; first < vectors.rows(); first += rotationRows)
    {
        const auto count = std::min<Eigen::Index> (rotationRows, vectors.rows() - first);
        strip.topRows (count) = vectors.middleRows (first, count);

        for (std::size_t next = 0; next < rotations.size(); next += rotationsAtOnce)
        {
            checkWatch();
            rotateColumns (strip.data(), rotations.data() + next,
                           static_cast<std::ptrdiff_t> (std::min (rotationsAtOnce, rotations.size() - next)));
        }

        vectors.middleRows (first, count) = strip.topRows (count);
    }
}

/** What a matrix is divided by, so that its largest entry is 1. */
double computeScale (const Eigen::MatrixXd& a)
{
    const auto size = a.cwiseAbs().maxCoeff();

    if (! std::isfinite (size))
        throw std::runtime_error ("eigenvalues of a symmetric matrix: it is not finite");

    return size > 0 ? size : 1.0;
}
} // namespace

SymmetricEigen symmetricEigen (Eigen::MatrixXd a)
{
    if (a.size() == 0)
        return {};

    const auto scale = computeScale (a);
    a /= scale;
    auto t = tridiagonalise (a);
    auto vectors = accumulateReflections (a, t);
    rotateAll (vectors, diagonalise (t));

    std::vector<Eigen::Index> order (static_cast<std::size_t> (vectors.cols()));
    std::iota (order.begin(), order.end(), 0);
    std::stable_sort (order.begin(), order.end(),
                      [&] (auto left, auto right) { return t.diagonal[left] < t.diagonal[right]; });
    return { scale * t.diagonal (order), vectors (Eigen::all, order) };
}

Eigen::VectorXd symmetricEigenvalues (const Eigen::MatrixXd& a)
{
    if (a.size() == 0)
        return {};

    const auto scale = computeScale (a);
    Eigen::MatrixXd scaled = a / scale;
    auto t = tridiagonalise (scaled);
    diagonalise (t);
    std::sort (t.diagonal.begin(), t.diagonal.end());
    return scale * t.diagonal;
}
} // namespace antinode
