#include "PeakRows.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
/** Between two looks at the watch: multiples of what a product takes at once, so that it is the same in pieces. */
constexpr Eigen::Index columnsAtOnce = 2048;

/** A positive semidefinite matrix's directions and how long each is, those of rounding left out: T with T' G T = 1. */
Eigen::MatrixXd whitenedBasis (const Eigen::MatrixXd& gram)
{
    constexpr auto smallest = 4 * std::numeric_limits<double>::epsilon();
    auto [values, vectors] = symmetricEigen (gram);
    const auto minimum = smallest * values.sum();
    Eigen::Index first = 0;

    while (first < values.size() && values[first] <= minimum)
        ++first;

    const auto rank = values.size() - first;
    return vectors.rightCols (rank) * values.tail (rank).cwiseSqrt().cwiseInverse().asDiagonal();
}
} // namespace

PeakRows::PeakRows (const MinimumPeakProblem& problem) : ceramics (problem.ceramics)
{
    const auto rows = problem.wanted.size();
    Eigen::VectorXd squares = Eigen::VectorXd::Zero (rows);
    absoluteValues = Eigen::VectorXd::Zero (rows);
    offsets.push_back (0);

    for (const auto& [gains, weights] : ceramics)
    {
        checkWatch();
        offsets.push_back (offsets.back() + weights->cols());
        squares += gains.cwiseAbs2().cwiseProduct (weights->rowwise().squaredNorm());
        absoluteValues += gains.cwiseAbs().cwiseProduct (weights->rowwise().lpNorm<1>());
    }

    scale = (squares.array() > 0).select (squares.cwiseSqrt().cwiseInverse(), 0);

    for (auto& ceramic : ceramics)
        ceramic.gains = ceramic.gains.cwiseProduct (scale);

    wantedValues = scale.cwiseProduct (problem.wanted);
    absoluteValues = absoluteValues.cwiseProduct (scale);
    basis = whitenedBasis (gram (nullptr));
}

Eigen::VectorXd PeakRows::pulls (const Eigen::VectorXd& y) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero (columns());

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        const auto& [gains, weights] = ceramics[i];
        addTransposedLeft (result.segment (offsets[i], weights->cols()), 1, *weights, gains.cwiseProduct (y));
    }

    return result;
}

Eigen::VectorXd PeakRows::values (const Eigen::VectorXd& s) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero (wantedValues.size());

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        const auto& [gains, weights] = ceramics[i];
        Eigen::VectorXd sums = Eigen::VectorXd::Zero (result.size());

        for (Eigen::Index first = 0; first < weights->cols(); first += columnsAtOnce)
        {
            checkWatch();
            const auto count = std::min (columnsAtOnce, weights->cols() - first);
            sums += weights->middleCols (first, count) * s.segment (offsets[i] + first, count);
        }

        result += gains.cwiseProduct (sums);
    }

    return result;
}

/** A diag (weights) A', its lower triangle; without weights those of 1. */
Eigen::MatrixXd PeakRows::gram (const Eigen::ArrayXd* columnWeights) const
{
    const auto rows = wantedValues.size();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero (rows, rows), part;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        const auto& [gains, weights] = ceramics[i];

        if (columnWeights != nullptr || i == 0 || weights != ceramics[i - 1].weights)
        {
            part = Eigen::MatrixXd::Zero (rows, rows);

            for (Eigen::Index first = 0; first < weights->cols(); first += columnsAtOnce)
            {
                const auto count = std::min (columnsAtOnce, weights->cols() - first);
                const auto some = weights->middleCols (first, count);

                if (columnWeights != nullptr)
                    addGram (part, 1,
                             some * columnWeights->segment (offsets[i] + first, count).sqrt().matrix().asDiagonal());
                else
                    addGram (part, 1, some);
            }
        }

        for (Eigen::Index k = 0; k < rows; ++k)
            sum.col (k).tail (rows - k) += gains[k] * gains.tail (rows - k).cwiseProduct (part.col (k).tail (rows - k));
    }

    return sum;
}

Eigen::MatrixXd PeakRows::factored (const Eigen::ArrayXd& weights) const
{
    constexpr std::array lifts { 1e-15, 1e-13, 1e-11, 1e-9, 1e-7 };
    const Eigen::MatrixXd whole = gram (&weights).selfadjointView<Eigen::Lower>();
    Eigen::MatrixXd half = Eigen::MatrixXd::Zero (whole.rows(), basis.cols());
    Eigen::MatrixXd whitened = Eigen::MatrixXd::Zero (basis.cols(), basis.cols());
    addProduct (half, 1, whole, basis);
    addTransposedLeft (whitened, 1, basis, half);

    for (const auto lift : lifts)
    {
        Eigen::MatrixXd factor = whitened;
        factor.diagonal() *= 1 + lift;

        if (factorLower (factor) && factor.allFinite())
            return factor;
    }

    return {};
}

Eigen::VectorXd PeakRows::solved (const Eigen::MatrixXd& factor, const Eigen::VectorXd& values) const
{
    if (factor.size() == 0)
        return Eigen::VectorXd::Zero (values.size());

    Eigen::MatrixXd x = basis.transpose() * values;
    solveLower (factor, x);
    solveLowerTransposed (factor, x);
    return basis * x;
}

Eigen::VectorXd PeakRows::corrected (Eigen::VectorXd s) const
{
    constexpr auto maximumRefinements = 12;
    constexpr auto rounding = 1e-3; // of the residual that is accepted

    for (int i = 0; i < maximumRefinements && (i < 2 || residual (s) > rounding * metResidual); ++i)
    {
        const Eigen::VectorXd missing = wantedValues - values (s);
        s += pulls (basis * (basis.transpose() * missing));
    }

    return s;
}

double PeakRows::residual (const Eigen::VectorXd& s) const
{
    constexpr auto rounding = 1e-4; // times the accepted 1e-9: 1e-13 of what is summed
    const Eigen::ArrayXd error = (wantedValues - values (s)).array().abs();
    const Eigen::ArrayXd beside =
        wantedValues.array().abs() + rounding * s.cwiseAbs().maxCoeff() * absoluteValues.array();
    return (beside > 0).select (error / beside, error).maxCoeff();
}

Eigen::VectorXd PeakRows::unreachable() const
{
    return wantedValues - values (pulls (leastNormMultipliers()));
}
} // namespace antinode
