#include "BlockLanczos.h"

#include "Decompositions.h"
#include "DenseKernels.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace antinode
{
namespace
{
constexpr double residualTolerance = 1e-7; ///< Of a pair, relative to its eigenvalue of the shifted inverse.

/** The orthonormal basis that grows by a block a step, and the shifted inverse on it. */
class KrylovSpace
{
public:
    KrylovSpace (const BlockBandedFactor& factorToUse, const MassProduct& massToUse, Eigen::Index unknowns,
                 Eigen::Index blockColumns, Eigen::Index maximumColumns)
        : factor (factorToUse), mass (massToUse), basis (unknowns, maximumColumns),
          massBasis (unknowns, maximumColumns), projected (maximumColumns, maximumColumns), width (blockColumns)
    {
        block = randomBlock();
        factor.solveInPlace (block);
        orthonormalise();
    }

    Eigen::Index size() const { return filled; }
    bool canGrow() const { return filled + width <= basis.cols(); }

    /** Whether nothing but rounding is left outside. */
    bool isWhole() const { return filled + width > basis.rows(); }

    /** Takes the next block into the basis and applies the shifted inverse to it. */
    void grow()
    {
        basis.middleCols (filled, width) = block;
        massBasis.middleCols (filled, width) = massBlock;
        filled += width;
        block = massBlock;
        factor.solveInPlace (block);
        const Eigen::MatrixXd coefficients = orthogonalise();
        // A block at a time, as far as it is used: to fill all columns at once takes a third of a second on the largest
        // plates. What is below the diagonal is scaled along with the rest, so it is 0.
        projected.block (0, filled - width, filled, width) = coefficients;
        projected.block (filled - width, 0, width, filled - width).setZero();
        orthonormalise();
    }

    /** The eigenpairs of the projected inverse, the largest first, and the residual norm of each. */
    SymmetricEigen ritzPairs (Eigen::VectorXd& residuals) const
    {
        // Its upper triangle is known: what each block leaves on those before it.
        auto pairs = symmetricEigen (projected.topLeftCorner (filled, filled).transpose());
        pairs.values.reverseInPlace();
        pairs.vectors = pairs.vectors.rowwise().reverse().eval();
        residuals = (remainder * pairs.vectors.bottomRows (width)).colwise().norm();
        return pairs;
    }

    Eigen::MatrixXd vectors (const Eigen::MatrixXd& coefficients) const
    {
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero (basis.rows(), coefficients.cols());
        addProduct (result, 1, basis.leftCols (filled), coefficients);
        return result;
    }

private:
    Eigen::MatrixXd randomBlock()
    {
        // Not std::uniform_real_distribution: what it gives is left to the library.
        return Eigen::MatrixXd::NullaryExpr (basis.rows(), width,
                                             [&] { return static_cast<double> (random()) / 4294967296.0 - 0.5; });
    }

    /** Takes from the block what lies in the basis; what it was. But for rounding that is in the last two blocks only:
       once they are out, one pass over all of them leaves nothing. */
    Eigen::MatrixXd orthogonalise()
    {
        Eigen::MatrixXd all = Eigen::MatrixXd::Zero (filled, width);

        for (const auto count : { std::min (filled, 2 * width), filled })
        {
            Eigen::MatrixXd part = Eigen::MatrixXd::Zero (count, width);
            addTransposedLeft (part, 1, massBasis.middleCols (filled - count, count), block);
            addProduct (block, -1, basis.middleCols (filled - count, count), part);
            all.bottomRows (count) += part;
        }

        return all;
    }

    /** Makes the block orthonormal in M. Negligible directions are exhausted and replaced by random ones. */
    void orthonormalise()
    {
        remainder = Eigen::MatrixXd::Identity (width, width);

        massBlock = mass (block);

        for (int pass = 0; pass < 2; ++pass)
        {
            Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (width, width);
            addTransposedLeft (gram, 1, block, massBlock);
            const auto pairs = symmetricEigen (gram);
            const auto largest = pairs.values[width - 1];

            if (! (largest > 0 && std::isfinite (largest)))
                throw std::runtime_error ("eigenpairs: the iteration space is exhausted");

            // What is left of a used-up direction is rounding: a random one is as good, and is met by the passes that
            // follow.
            const Eigen::VectorXd sizes = pairs.values.cwiseMax (1e-24 * largest).cwiseSqrt();
            const Eigen::MatrixXd scaled = pairs.vectors * sizes.cwiseInverse().asDiagonal();
            transform (block, scaled);
            transform (massBlock, scaled);
            remainder = (sizes.asDiagonal() * pairs.vectors.transpose() * remainder).eval();

            if (pass == 0 && pairs.values[0] < 1e-20 * largest)
            {
                orthogonalise();
                massBlock = mass (block);
            }
        }
    }

    static void transform (Eigen::MatrixXd& columns, const Eigen::MatrixXd& by)
    {
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero (columns.rows(), by.cols());
        addProduct (result, 1, columns, by);
        columns.swap (result);
    }

    const BlockBandedFactor& factor;
    const MassProduct& mass;
    Eigen::MatrixXd basis, massBasis, projected, block, massBlock, remainder;
    Eigen::Index width, filled = 0;
    std::mt19937 random { 1 };
};
} // namespace

Eigenpairs lowestEigenpairs (const BlockBandedFactor& factor, const MassProduct& mass, Eigen::Index unknowns,
                             double shift, Eigen::Index count)
{
    const auto width = std::clamp<Eigen::Index> (count / 12, 2, 12);
    const auto maximum = std::min (unknowns / width * width, (6 * count + 80) / width * width);
    KrylovSpace space (factor, mass, unknowns, width, maximum);
    auto nextCheck = std::min (maximum, 2 * count + 4 * width);

    while (space.canGrow())
    {
        space.grow();

        if (space.size() < nextCheck && space.canGrow())
            continue;

        Eigen::VectorXd residuals;
        const auto pairs = space.ritzPairs (residuals);
        const auto isConverged =
            (residuals.head (count).array() <= residualTolerance * pairs.values.head (count).array()).all();

        if (isConverged || ! space.canGrow())
            return { (shift + pairs.values.head (count).array().inverse()).matrix(),
                     space.vectors (pairs.vectors.leftCols (count)), isConverged || space.isWhole() };

        nextCheck = space.size() + std::max (count / 6, 2 * width);
    }

    throw std::runtime_error ("eigenpairs: more requested than exist");
}

std::optional<Eigenpairs> ritzPairsBehind (const MassProduct& stiffness, const MassProduct& mass,
                                           const Eigen::MatrixXd& modes, Eigen::MatrixXd columns)
{
    const Eigen::MatrixXd weighted = mass (modes);

    for (int pass = 0; pass < 2; ++pass) // the second removes what rounding left
    {
        columns -= modes * (weighted.transpose() * columns);
        columns.colwise().normalize();
    }

    const auto ritz =
        generalizedEigen (columns.transpose() * stiffness (columns), columns.transpose() * mass (columns));

    if (! ritz || ! (ritz->values[0] > 0))
        return std::nullopt;

    return Eigenpairs { ritz->values, columns * ritz->vectors };
}
} // namespace antinode
