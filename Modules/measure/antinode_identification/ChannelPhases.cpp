#include "ChannelPhases.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** Squares have twice the phase, so that signs of shapes do not matter. */
template <typename Turn>
double realShareTurned (const Eigen::VectorXcd& residues, const Eigen::VectorXd& omega, const Turn& turn)
{
    double real = 0, all = 0;

    for (Eigen::Index k = 0; k < residues.size(); ++k)
    {
        // Each mode counts by its amplitude, so that the strongest is not alone.
        const auto amplitude = std::abs (residues[k]);
        const auto phase = 2 * (std::arg (residues[k]) + turn (omega[k]));
        real += amplitude * std::cos (phase);
        all += amplitude;
    }

    return all > 0 ? real / all : 0;
}

/** How far the two by two tables of one channel agree, 1 to -1: of one shape times one participation every determinant
   is 0, and an inverted channel makes it twice a product. */
double agreement (const Eigen::MatrixXcd& residues, Eigen::Index points, Eigen::Index channel)
{
    const auto reference = channel / points, point = channel % points;
    double agreeing = 0, all = 0;

    for (Eigen::Index k = 0; k < residues.rows(); ++k)
        for (Eigen::Index i = 0; i < residues.cols() / points; ++i)
            for (Eigen::Index p = 0; p < points; ++p)
                if (i != reference && p != point)
                {
                    const auto one = residues (k, channel) * residues (k, i * points + p);
                    const auto other = residues (k, i * points + point) * residues (k, reference * points + p);
                    agreeing += (one * std::conj (other)).real() / std::max (std::abs (other), 1e-300);
                    all += std::abs (one);
                }

    return all > 0 ? agreeing / all : 1;
}

/** What is not real of all channels with weight. @param score  the real share of one, turned as it may be */
template <typename Score>
double imaginaryShare (const Eigen::MatrixXcd& residues, const Eigen::VectorXd& columnWeights, const Score& score)
{
    double left = 0, all = 0;

    for (Eigen::Index c = 0; c < residues.cols(); ++c)
    {
        const auto amount = std::sqrt (columnWeights[c]) * residues.col (c).cwiseAbs().sum();
        left += amount > 0 ? amount * (1 - score (Eigen::VectorXcd (residues.col (c)))) : 0;
        all += amount;
    }

    return left / std::max (all, 1e-300);
}
} // namespace

Eigen::MatrixXcd channelResidues (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    const auto data = prepare (responses, modes.minimumFrequency * (1 - 1e-9), modes.maximumFrequency * (1 + 1e-9));
    const auto basis = makeBasis (modes.angularFrequencies, modes.dampingRatios, data);
    return complexResidues (basis, modalProducts (basis, data, modes.delay), 1e-12);
}

double realShare (const Eigen::VectorXcd& residues)
{
    return realShareTurned (residues, Eigen::VectorXd::Zero (residues.size()), [] (double) { return 0.0; });
}

ChannelPhase bestDelay (const Eigen::VectorXcd& residues, const Eigen::VectorXd& omega)
{
    constexpr double longest = 1e-3;
    const auto step = 0.1 / omega.maxCoeff();
    const auto steps = static_cast<int> (2 * longest / step);
    ChannelPhase best { 0, 0, realShare (residues) };

    for (int n = 0; n <= steps; ++n)
    {
        const auto delay = n * step - longest;

        if (const auto score = realShareTurned (residues, omega, [delay] (double at) { return at * delay; });
            score > best.score + 1e-3)
            best = { delay, 0, score };
    }

    return best;
}

ChannelPhase bestLowPass (const Eigen::VectorXcd& residues, const Eigen::VectorXd& omega)
{
    constexpr int steps = 200;
    ChannelPhase best;

    for (int n = 0; n < steps; ++n)
    {
        const auto corner = omega.maxCoeff() * std::pow (10, 1.5 - 3.0 * n / steps);
        const auto score = realShareTurned (residues, omega, [corner] (double at) { return std::atan (at / corner); });

        if (score > best.score)
            best = { 0, corner, score };
    }

    return best;
}

Eigen::VectorXd channelAgreements (const Eigen::MatrixXcd& residues, Eigen::Index points)
{
    Eigen::VectorXd agreements (residues.cols());

    for (Eigen::Index c = 0; c < residues.cols(); ++c)
    {
        checkWatch();
        agreements[c] = agreement (residues, points, c);
    }

    return agreements;
}

bool phasesAreOfChannels (const Eigen::MatrixXcd& residues, const Eigen::VectorXd& omega,
                          const Eigen::VectorXd& columnWeights)
{
    constexpr Eigen::Index fewest = 3; // of modes: fewer phases are explained by any delay
    // What may be left; of few phases little, since some delay suits them by chance.
    const auto mostLeft = 0.4 * (1 - 2 / static_cast<double> (residues.rows()));

    if (residues.rows() < fewest)
        return false;

    const auto withoutCommonDelay = [&] (const Eigen::MatrixXcd& values) -> Eigen::MatrixXcd
    {
        const std::complex<double> delay (0, estimateDelay (omega, values, columnWeights));
        return (omega.array() * delay).exp().matrix().asDiagonal() * values;
    };
    const auto left = [&] (const Eigen::MatrixXcd& values, const auto& score)
    { return imaginaryShare (values, columnWeights, score); };
    const auto asTheyAre = [] (const Eigen::VectorXcd& values) { return realShare (values); };
    const auto delayed = [&] (const Eigen::VectorXcd& values) { return bestDelay (values, omega).score; };
    const auto lowPassed = [&] (const Eigen::VectorXcd& values) { return bestLowPass (values, omega).score; };
    const auto standing = withoutCommonDelay (residues);
    const auto limit = mostLeft * left (standing, asTheyAre);
    return left (withoutCommonDelay (residues * std::complex<double> (0, 1)), asTheyAre) < limit
           || left (standing, delayed) < limit || left (standing, lowPassed) < limit;
}
} // namespace antinode
