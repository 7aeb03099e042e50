#include "Decompositions.h"
#include "Householder.h"
#include "MatrixKernel.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace antinode
{
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
