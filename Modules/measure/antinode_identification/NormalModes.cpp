#include "NormalModes.h"

#include <antinode_numerics/Decompositions.h>

#include <cmath>

namespace antinode
{
namespace
{
using Indices = std::vector<Eigen::Index>;

auto powerColumns (const ModalBasis& basis)
{
    return Eigen::seq (basis.modalColumns(), basis.size() - 1);
}
} // namespace

Eigen::MatrixXd solveEven (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double ridge)
{
    const Eigen::VectorXd scale = a.diagonal().cwiseMax (1e-300).cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd even = scale.asDiagonal() * a * scale.asDiagonal();
    even.diagonal().array() += ridge;
    return scale.asDiagonal() * solveSemidefinite (even, scale.asDiagonal() * b);
}

ModalBasis makeBasis (const Eigen::VectorXd& angularFrequencies, const Eigen::VectorXd& dampingRatios,
                      const PreparedResponses& data)
{
    const auto scale = std::sqrt (data.omega[0] * data.omega[data.lines() - 1]);
    return { angularFrequencies, dampingRatios, { -3, -2, -1, 0, 1, 2, 3, 4, 5 }, scale };
}

ModalProducts withoutPowers (const ModalBasis& basis, const ModalProducts& products)
{
    const auto kept = Eigen::seqN (0, basis.modalColumns());
    const auto taken = powerColumns (basis);
    const Eigen::MatrixXd between = products.gram (taken, kept), data = products.data (taken, Eigen::all);
    Eigen::MatrixXd both (between.rows(), between.cols() + data.cols());
    both << between, data;
    const auto solved = solveEven (products.gram (taken, taken), both, 1e-13);
    return { products.gram (kept, kept) - between.transpose() * solved.leftCols (between.cols()),
             products.data (kept, Eigen::all) - between.transpose() * solved.rightCols (data.cols()),
             products.energies - data.cwiseProduct (solved.rightCols (data.cols())).colwise().sum().transpose() };
}

Eigen::MatrixXcd complexResidues (const ModalBasis& basis, const ModalProducts& products, double ridge)
{
    const auto reduced = withoutPowers (basis, products);
    const auto modes = basis.modes();
    Indices columns;

    for (const auto function : { ModalFunction::velocity, ModalFunction::delay })
        for (Eigen::Index k = 0; k < modes; ++k)
            columns.push_back (basis.column (k, function));

    const auto solved =
        solveEven (reduced.gram (columns, columns), reduced.data (columns, Eigen::all), std::max (ridge, 1e-14));
    Eigen::MatrixXcd result (modes, products.data.cols());

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto resonance = basis.angularFrequencies[k], damping = basis.dampingRatios[k];
        const std::complex<double> pole (-damping * resonance, resonance * std::sqrt (1 - damping * damping));
        result.row (k) = resonance * solved.row (k) - pole * solved.row (modes + k);
    }

    return result;
}

Eigen::MatrixXd powerCoefficients (const ModalBasis& basis, const ModalProducts& products,
                                   const Eigen::MatrixXd& amplitudes)
{
    const auto taken = powerColumns (basis);
    const Eigen::MatrixXd toModes = products.gram (taken, Eigen::seqN (0, basis.modalColumns()));
    return solveEven (products.gram (taken, taken), products.data (taken, Eigen::all) - toModes * amplitudes, 1e-13);
}

double estimateDelay (const Eigen::VectorXd& angularFrequencies, const Eigen::MatrixXcd& residues,
                      const Eigen::VectorXd& columnWeights)
{
    // Squares have twice the phase, so that signs of shapes do not matter; each mode counts as far as it has one phase.
    const Eigen::VectorXcd squares = residues.array().square().matrix() * columnWeights;
    const Eigen::VectorXd energies = residues.cwiseAbs2() * columnWeights;
    const auto score = [&] (double delay)
    {
        double sum = 0;

        for (Eigen::Index k = 0; k < squares.size(); ++k)
            sum += (squares[k] * std::polar (1.0, 2 * angularFrequencies[k] * delay)).real()
                   / std::max (energies[k], 1e-300);

        return sum;
    };

    constexpr double price = 0.4;
    const auto highest = squares.cwiseAbs().cwiseQuotient (energies.cwiseMax (1e-300)).sum();
    return searchDelay (score, angularFrequencies.maxCoeff(), price * highest);
}

double searchDelay (const std::function<double (double)>& score, double highest, double price)
{
    // No measurement is late by more than some milliseconds.
    constexpr double longest = 3e-3, longDelay = 2e-4;
    const auto step = 0.25 / highest;
    const auto priced = [&] (double delay)
    { return score (delay) - price * std::abs (delay) / (std::abs (delay) + longDelay); };
    double best = 0, bestScore = priced (0);

    for (auto n = static_cast<long> (-longest / step); n <= static_cast<long> (longest / step); ++n)
        if (const auto delay = static_cast<double> (n) * step; priced (delay) > bestScore)
            bestScore = priced (best = delay);

    auto width = step;

    for (int halving = 0; halving < 20; ++halving, width /= 2)
        for (const auto delay : { best - width, best + width })
            if (score (delay) > score (best))
                best = delay;

    return best;
}
} // namespace antinode
