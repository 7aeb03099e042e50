#include "DrawnDevices.h"

#include <antinode_base/MessageText.h>

#include <limits>

namespace antinode
{
namespace
{
constexpr double percent = 100;
}

std::vector<Field> fields (DrawnDevices& devices)
{
    const auto deviation = [] (const char* option, std::optional<double>& value, double most, const char* of)
    {
        return Field (option, &value, std::string ("Standard deviation of ") + of)
            .in (percent)
            .within (0, most)
            .by ("those of the robust design, else by the origin of the modes");
    };
    return { Field ("--draws", &devices.draws, "Number of random devices").within (1, 1000000),
             Field ("--seed", &devices.seed, "Seed of the random devices").within (0, std::numeric_limits<int>::max()),
             deviation ("--frequency-percent", devices.frequency, 10, "each frequency, %"),
             deviation ("--damping-percent", devices.damping, 50, "each damping, %"),
             deviation ("--participation-percent", devices.participation, 50, "each participation, %"),
             deviation ("--drift-percent", devices.drift, 10, "a common drift of all frequencies, %") };
}

ToleranceOptions toleranceOptions (const DrawnDevices& devices, const DetuningSpread& usual)
{
    return { { devices.frequency.value_or (usual.frequency), devices.damping.value_or (usual.damping),
               devices.participation.value_or (usual.participation), devices.drift.value_or (usual.drift) },
             devices.draws,
             static_cast<std::uint64_t> (devices.seed) };
}

std::string drawnInWords (const ToleranceOptions& options)
{
    const auto& spread = options.spread;
    return std::to_string (options.draws)
           + " random devices; standard deviations: " + inWords (percent * spread.frequency) + " % in frequency, "
           + inWords (percent * spread.damping) + " % in damping, " + inWords (percent * spread.participation)
           + " % in participation, " + inWords (percent * spread.drift) + " % by a drift of all frequencies";
}
} // namespace antinode
