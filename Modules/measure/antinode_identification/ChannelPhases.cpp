#include "ChannelPhases.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

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

namespace
{
/** Radians by which residues are turned back. */
double angle (ChannelTurn turn, double value, double omega, double damping)
{
    // A residue is seen through 1 + s T at its pole s.
    return turn == ChannelTurn::delay ? omega * value
           : turn == ChannelTurn::lowPass
               ? std::atan2 (omega * std::sqrt (1 - damping * damping) * value, 1 - damping * omega * value)
               : value / damping;
}

/** Values from which a search starts, ascending. */
std::vector<double> coarseTurns (const GroupedPhases& phases, ChannelTurn turn)
{
    std::vector<double> values;

    if (turn == ChannelTurn::lowPass)
    {
        constexpr double weakest = 0.02, strongest = 50, ratio = 1.25;
        const auto first = weakest / phases.omega.maxCoeff(), last = strongest / phases.omega.minCoeff();
        const auto count = static_cast<int> (std::ceil (std::log (last / first) / std::log (ratio)));
        values.push_back (0);

        for (int n = 0; n < count; ++n)
            values.push_back (first * std::pow (ratio, n));

        return values;
    }

    constexpr int steps = 40;
    constexpr double fine = 0.25; // rad at the mode that turns most
    const auto unit =
        turn == ChannelTurn::delay ? fine / phases.omega.maxCoeff() : fine / 8 * phases.damping.minCoeff();

    for (int n = -steps; n <= steps; ++n)
        values.push_back (n * unit);

    return values;
}

/** The search for the best value of a turn. */
class TurnSearch
{
public:
    TurnSearch (const GroupedPhases& given, ChannelTurn kind)
        : phases (given), turn (kind), values (coarseTurns (given, kind))
    {
        for (const auto value : values)
            coarse.push_back (phasors (value));
    }

    /** The value that agrees best with sums, N_m, among the coarse ones, or beside the best of these. */
    double best (const Eigen::VectorXcd& sums, bool isFine) const
    {
        std::size_t at = 0;
        auto most = -std::numeric_limits<double>::infinity();

        for (std::size_t n = 0; n < values.size(); ++n)
            if (const auto found = real (coarse[n], sums); found > most)
            {
                most = found;
                at = n;
            }

        return isFine ? refined (sums, values[at > 0 ? at - 1 : 0], values[std::min (at + 1, values.size() - 1)])
                      : values[at];
    }

    double agreement (const Eigen::VectorXcd& sums, double value) const { return real (phasors (value), sums); }

private:
    Eigen::VectorXcd phasors (double value) const
    {
        Eigen::VectorXcd result (phases.omega.size());

        for (Eigen::Index k = 0; k < result.size(); ++k)
            result[k] = std::polar (1.0, 2 * angle (turn, value, phases.omega[k], phases.damping[k]));

        return result;
    }

    static double real (const Eigen::VectorXcd& by, const Eigen::VectorXcd& sums)
    {
        return by.real().dot (sums.real()) - by.imag().dot (sums.imag());
    }

    double refined (const Eigen::VectorXcd& sums, double lower, double upper) const
    {
        constexpr int steps = 30;

        for (int n = 0; n < steps; ++n)
        {
            const auto third = (upper - lower) / 3;

            if (agreement (sums, lower + third) < agreement (sums, upper - third))
                lower += third;
            else
                upper -= third;
        }

        return (lower + upper) / 2;
    }

    const GroupedPhases& phases;
    ChannelTurn turn;
    std::vector<double> values;
    std::vector<Eigen::VectorXcd> coarse;
};

/** All groups, turned by a common delay before. */
TurnsOfGroups turnsAt (const GroupedPhases& phases, const TurnSearch& search, double delay, bool isFine)
{
    checkWatch();
    const Eigen::VectorXcd before = (phases.omega.array() * std::complex<double> (0, 2 * delay)).exp();
    TurnsOfGroups result { Eigen::VectorXd (phases.sums.cols()), Eigen::VectorXd (phases.sums.cols()),
                           phases.weights / 2 };

    for (Eigen::Index g = 0; g < phases.sums.cols(); ++g)
    {
        const Eigen::VectorXcd sums = before.cwiseProduct (phases.sums.col (g));
        result.values[g] = search.best (sums, isFine);
        const auto agreement = search.agreement (sums, result.values[g]);
        result.gains[g] = (agreement - sums.real().sum()) / 2;
        result.left -= agreement / 2;
    }

    return result;
}
} // namespace

TurnsOfGroups bestTurns (const GroupedPhases& phases, ChannelTurn turn)
{
    const TurnSearch search (phases, turn);

    if (turn == ChannelTurn::delay)
        return turnsAt (phases, search, 0, true);

    constexpr int halvings = 12;
    auto best = turnsAt (phases, search, 0, false);
    double at = 0;
    const auto delays = coarseTurns (phases, ChannelTurn::delay);

    for (const auto delay : delays)
        if (auto found = turnsAt (phases, search, delay, false); found.left < best.left)
        {
            best = std::move (found);
            at = delay;
        }

    best = turnsAt (phases, search, at, true);

    auto step = delays[1] - delays[0];

    for (int n = 0; n < halvings; ++n, step /= 2)
        for (const auto sign : { -1, 1 })
        {
            const auto delay = at + sign * step;

            if (auto found = turnsAt (phases, search, delay, true); found.left < best.left)
            {
                best = std::move (found);
                at = delay;
            }
        }

    return best;
}
} // namespace antinode
