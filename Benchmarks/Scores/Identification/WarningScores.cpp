#include "WarningScores.h"

#include <cctype>
#include <cstdio>
#include <set>

namespace antinode::test
{
namespace
{
constexpr double tolerance = 0.1;

/** The largest error of a mode. @param taken  the true ones that were found before */
double worstError (const IdentifiedModes& modes, Eigen::Index k, const KnownStructure& truth, std::vector<bool>& taken)
{
    const auto frequency = modes.angularFrequencies[k] / (2 * std::numbers::pi);
    Eigen::Index j = 0;
    (truth.frequencies.array() - frequency).abs().minCoeff (&j);
    const auto shift = std::abs (frequency / truth.frequencies[j] - 1) / truth.dampingRatios[j];

    if (taken[static_cast<std::size_t> (j)] || shift > 1)
        return std::numeric_limits<double>::infinity();

    taken[static_cast<std::size_t> (j)] = true;
    const Eigen::MatrixXd found = modes.shapes.col (k) * modes.participation.row (k);
    const Eigen::MatrixXd real = truth.shapes.col (j) * truth.participation.row (j);
    return std::max (
        { shift, std::abs (modes.dampingRatios[k] / truth.dampingRatios[j] - 1), (found - real).norm() / real.norm() });
}

std::string withoutNumbers (const std::string& warning)
{
    constexpr std::size_t most = 44;
    std::string text;

    for (const auto letter : warning.substr (0, warning.find ('(')))
        if (std::isdigit (static_cast<unsigned char> (letter)) == 0)
            text += letter;

    return text.substr (0, most);
}

void count (Worth& worth, bool isWrong)
{
    ++worth.all;
    worth.wrong += isWrong ? 1 : 0;
}
} // namespace

void add (WarningScores& scores, const IdentifiedModes& modes, const KnownStructure& truth)
{
    std::vector<bool> taken (static_cast<std::size_t> (truth.frequencies.size()));

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto isWrong = worstError (modes, k, truth, taken) > tolerance;
        std::set<std::string> kinds;

        for (const auto& warning : modes.quality[static_cast<std::size_t> (k)].warnings)
            kinds.insert (withoutNumbers (warning));

        count (scores.modes, isWrong);

        if (! kinds.empty())
            count (scores.withAny, isWrong);

        for (const auto& kind : kinds)
            count (scores.ofEach[kind], isWrong);
    }
}

void print (const WarningScores& scores)
{
    const auto line = [&] (const std::string& name, const Worth& worth)
    {
        std::printf ("%-46s %5d modes, %4d wrong: precision %5.1f %%, recall %5.1f %%\n", name.c_str(), worth.all,
                     worth.wrong, 100.0 * worth.wrong / std::max (worth.all, 1),
                     100.0 * worth.wrong / std::max (scores.modes.wrong, 1));
    };
    line ("all modes", scores.modes);
    line ("any warning", scores.withAny);

    for (const auto& [name, worth] : scores.ofEach)
        line (name, worth);
}
} // namespace antinode::test
