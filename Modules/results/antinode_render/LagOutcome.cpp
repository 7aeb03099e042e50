#include "LagOutcome.h"

#include <antinode_base/NumberText.h>

#include <nlohmann/json.hpp>

#include <numeric>

namespace antinode
{
namespace
{
constexpr double percentOfOne = 100;

std::int64_t limitedSamples (const UndoneLags& undone)
{
    return std::accumulate (undone.limited.begin(), undone.limited.end(), std::int64_t { 0 });
}
} // namespace

std::string lagsInWords (const UndoneLags& undone)
{
    auto text = "undone to " + inWords (percentOfOne * undone.misfit) + " %; all is " + std::to_string (undone.lateness)
                + " samples later";

    if (const auto limited = limitedSamples (undone); limited > 0)
        text +=
            "; " + std::to_string (limited)
            + " samples are beyond limits of voltage or slew rate and are cut: lower the voltage limit of the design";

    return text;
}

nlohmann::ordered_json lagJson (const UndoneLags& undone)
{
    return { { "late_samples", undone.lateness },
             { "misfit_percent", percentOfOne * undone.misfit },
             { "peak_voltage_V", undone.voltages.cwiseAbs().maxCoeff() },
             { "limited_samples", undone.limited } };
}
} // namespace antinode
