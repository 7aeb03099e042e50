#include "ModalFilter.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr double modelError = 0.1; ///< What known shapes and participations leave of a line, relative.

/** Some lines, so near to each other that no resonance falls between them. */
std::vector<Eigen::Index> chosenLines (const PreparedResponses& data, double leastDamping)
{
    std::vector<Eigen::Index> result;
    double next = 0;

    for (Eigen::Index f = 0; f < data.lines(); ++f)
        if (data.omega[f] >= next)
        {
            result.push_back (f);
            next = data.omega[f] * (1 + 0.5 * leastDamping);
        }

    return result;
}

/** The mean square of a mode's receptance at a line, over all places where its frequency may be. */
double expectedSquare (double omega, double resonance, double damping, double spread)
{
    const auto distance = omega - resonance, half = damping * resonance;
    const auto wide = (spread * spread) * (resonance * resonance) + half * half;
    const auto peak = std::sqrt (std::numbers::pi / (32 * wide)) / half * std::exp (-distance * distance / (2 * wide));
    return peak + 1 / (4 * (distance * distance + wide));
}

/** All lines as what they have in common with each mode, and the mean square of each line. */
struct Projections
{
    Eigen::MatrixXd real, imaginary; ///< Lines x N_m
    Eigen::VectorXd powers, noise;   ///< Lines: sums over the columns of |value|^2 and of the noise's, weighted.
};

/** N_m x C: of all products of shape and participation. */
Eigen::MatrixXd signatures (const PreparedResponses& data, const KnownModes& modes)
{
    Eigen::MatrixXd result (modes.modes(), data.columns());

    for (Eigen::Index i = 0; i < data.references(); ++i)
        result.middleCols (i * data.points(), data.points()) =
            modes.participation.col (i).asDiagonal() * modes.shapes.transpose();

    return result * data.columnWeights.cwiseSqrt().asDiagonal();
}

/** @param weighted  signatures, as above */
Projections project (const PreparedResponses& data, const std::vector<Eigen::Index>& lines,
                     const Eigen::MatrixXd& weighted, double delay)
{
    const auto count = static_cast<Eigen::Index> (lines.size());
    Projections result { Eigen::MatrixXd (count, weighted.rows()), Eigen::MatrixXd (count, weighted.rows()),
                         Eigen::VectorXd (count), Eigen::VectorXd (count) };
    const Eigen::MatrixXd transposed = weighted.transpose();
    const auto roots = data.columnWeights.cwiseSqrt().eval();

    for (Eigen::Index n = 0; n < count; ++n)
    {
        checkWatch();
        // A line differs from the mean of its neighbours by noise, and by little else where lines are fine.
        const auto line = lines[static_cast<std::size_t> (n)];
        const auto first = std::clamp<Eigen::Index> (line - 1, 0, data.lines() - 3);
        auto block = dataBlock (data, first, advances (data, first, 3, delay));
        block.real *= roots.asDiagonal();
        block.imaginary *= roots.asDiagonal();
        result.real.row (n) = block.real.row (line - first) * transposed;
        result.imaginary.row (n) = block.imaginary.row (line - first) * transposed;
        result.powers[n] =
            block.real.row (line - first).squaredNorm() + block.imaginary.row (line - first).squaredNorm();
        const auto second = [] (const Eigen::MatrixXd& values)
        { return (values.row (1) - (values.row (0) + values.row (2)) / 2).squaredNorm() / 1.5; };
        result.noise[n] = second (block.real) + second (block.imaginary);
    }

    return result;
}

/** The modes whose frequency may be near a line: the first and the number of them, of all in ascending order. */
std::pair<Eigen::Index, Eigen::Index> nearModes (const KnownModes& modes, const Eigen::VectorXd& spreads, double omega)
{
    Eigen::Index first = modes.modes(), last = -1;

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        if (const auto reach = 4 * spreads[k] + 6 * modes.dampingRatios[k];
            std::abs (omega / modes.angularFrequencies[k] - 1) < reach)
        {
            first = std::min (first, k);
            last = std::max (last, k);
        }

    return { first, last < 0 ? 0 : last - first + 1 };
}
} // namespace

ModalReceptances separateModes (const PreparedResponses& data, const KnownModes& modes, const Eigen::VectorXd& spreads,
                                double delay)
{
    const auto lines = chosenLines (data, modes.dampingRatios.minCoeff());
    const auto weighted = signatures (data, modes);
    const auto given = project (data, lines, weighted, delay);
    const auto active = static_cast<double> ((data.columnWeights.array() > 0).count());
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (modes.modes(), modes.modes());
    addGram (gram, 1, weighted);
    gram = Eigen::MatrixXd (gram.selfadjointView<Eigen::Lower>());
    const auto count = static_cast<Eigen::Index> (lines.size());
    ModalReceptances result { Eigen::VectorXd (count), Eigen::MatrixXcd::Zero (count, modes.modes()),
                              Eigen::MatrixXd::Zero (count, modes.modes()) };

    for (Eigen::Index n = 0; n < count; ++n)
    {
        checkWatch();
        const auto omega = result.omega[n] = data.omega[lines[static_cast<std::size_t> (n)]];
        const auto [first, near] = nearModes (modes, spreads, omega);

        if (near == 0)
            continue;

        // Modes farther away, and errors of shapes, are as noise.
        const auto variance = (given.noise[n] + modelError * modelError * given.powers[n]) / active;
        Eigen::VectorXd priors (near);

        for (Eigen::Index a = 0; a < near; ++a)
            priors[a] = variance
                        / expectedSquare (omega, modes.angularFrequencies[first + a], modes.dampingRatios[first + a],
                                          spreads[first + a]);

        Eigen::MatrixXd inverse = gram.block (first, first, near, near);
        inverse.diagonal() += priors;

        if (variance <= 0 || ! factorLower (inverse))
            continue;

        inverse = solveFactored (inverse, Eigen::MatrixXd::Identity (near, near));
        const Eigen::VectorXd real = inverse * given.real.row (n).segment (first, near).transpose(),
                              imaginary = inverse * given.imaginary.row (n).segment (first, near).transpose();

        for (Eigen::Index a = 0; a < near; ++a)
        {
            const auto seen = 1 - inverse (a, a) * priors[a];

            if (seen <= 1e-6)
                continue;

            result.values (n, first + a) = std::complex<double> (real[a], imaginary[a]) / seen;
            result.precisions (n, first + a) = seen / (inverse (a, a) * variance);
        }
    }

    return result;
}
} // namespace antinode
