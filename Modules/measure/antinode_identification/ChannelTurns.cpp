#include "ChannelTurns.h"

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
