#include "SkinThreshold.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double slopeBeyond = 4; // of the logarithms: 24 dB an octave
}

double thresholdAt (const SkinThreshold& threshold, double frequency)
{
    const auto& frequencies = threshold.frequencies;
    const auto& displacements = threshold.displacements;
    const auto last = frequencies.size() - 1;

    if (frequency <= frequencies[0])
        return displacements[0] * std::pow (frequencies[0] / frequency, slopeBeyond);

    if (frequency >= frequencies[last])
        return displacements[last] * std::pow (frequency / frequencies[last], slopeBeyond);

    const auto upper = std::upper_bound (frequencies.begin(), frequencies.end(), frequency) - frequencies.begin();
    const auto share =
        std::log (frequency / frequencies[upper - 1]) / std::log (frequencies[upper] / frequencies[upper - 1]);
    return displacements[upper - 1] * std::pow (displacements[upper] / displacements[upper - 1], share);
}

void validate (const SkinThreshold& threshold)
{
    const auto& frequencies = threshold.frequencies;

    if (frequencies.size() < 2 || frequencies.size() != threshold.displacements.size())
        throw InputError (threshold.source, "needs at least two lines of a frequency in Hz and a displacement in um");

    for (Eigen::Index i = 0; i < frequencies.size(); ++i)
    {
        const auto isAscending = frequencies[i] > (i > 0 ? frequencies[i - 1] : 0.0);

        if (! isAscending || ! std::isfinite (frequencies[i]))
            throw InputError (threshold.source, "has the frequency " + inWords (frequencies[i]) + " Hz in row "
                                                    + std::to_string (i + 1) + "; allowed: above 0 and ascending");

        if (! (threshold.displacements[i] > 0) || ! std::isfinite (threshold.displacements[i]))
            throw InputError (threshold.source, "has a displacement that is not above 0 at " + inWords (frequencies[i])
                                                    + " Hz; allowed: um above 0");
    }
}
} // namespace antinode
