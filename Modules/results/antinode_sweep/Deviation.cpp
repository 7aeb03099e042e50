#include "Deviation.h"

#include "Distribution.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Reflection.h>
#include <antinode_focus/Detuning.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <array>

namespace antinode
{
namespace
{
constexpr double percent = 100;
constexpr NumberRange commonPercent { -90, 1000 }, spreadPercent { 0, 100 };

/** Where the value of a key goes. */
struct DeviationKey
{
    std::string_view key;
    double& (*at) (Deviation&);
    bool isSpread;
};

constexpr std::array<DeviationKey, 9> keys { {
    { "deviation.frequency_percent", [] (Deviation& d) -> double& { return d.frequency; }, false },
    { "deviation.damping_percent", [] (Deviation& d) -> double& { return d.damping; }, false },
    { "deviation.participation_percent", [] (Deviation& d) -> double& { return d.participation; }, false },
    { "deviation.voltage_percent", [] (Deviation& d) -> double& { return d.voltage; }, false },
    { "deviation.frequency_spread_percent", [] (Deviation& d) -> double& { return d.spread.frequency; }, true },
    { "deviation.damping_spread_percent", [] (Deviation& d) -> double& { return d.spread.damping; }, true },
    { "deviation.participation_spread_percent", [] (Deviation& d) -> double& { return d.spread.participation; }, true },
    { "deviation.drift_spread_percent", [] (Deviation& d) -> double& { return d.spread.drift; }, true },
    { "deviation.voltage_spread_percent", [] (Deviation& d) -> double& { return d.voltageSpread; }, true },
} };

const DeviationKey* findKey (std::string_view name)
{
    const auto* const found =
        std::find_if (keys.begin(), keys.end(), [&] (const auto& each) { return each.key == name; });
    return found == keys.end() ? nullptr : found;
}
} // namespace

bool Deviation::operator== (const Deviation& other) const
{
    auto left = *this, right = other;
    return std::all_of (keys.begin(), keys.end(), [&] (const auto& each) { return each.at (left) == each.at (right); });
}

std::vector<std::string_view> deviationKeys()
{
    std::vector<std::string_view> names;
    names.reserve (keys.size());

    for (const auto& each : keys)
        names.push_back (each.key);

    return names;
}

bool isDeviationKey (std::string_view name)
{
    return findKey (name) != nullptr;
}

Deviation readDeviation (const std::vector<std::pair<std::string, nlohmann::json>>& assignments)
{
    Deviation deviation;

    for (const auto& [name, json] : assignments)
        if (const auto* const key = findKey (name))
            key->at (deviation) =
                JsonValue (json, name).number (key->isSpread ? spreadPercent : commonPercent) / percent;

    return deviation;
}

ModalModel deviated (const ModalModel& model, const Deviation& deviation, std::uint64_t seed)
{
    const auto& spread = deviation.spread;
    const auto isSpread = spread.frequency > 0 || spread.damping > 0 || spread.participation > 0 || spread.drift > 0;
    auto result = isSpread ? detuned (model, spread, seed) : model;
    constexpr double largestDamping = 0.999, leastGain = 0.01;
    result.angularFrequencies *= 1 + deviation.frequency;
    result.dampingRatios = (result.dampingRatios * (1 + deviation.damping)).cwiseMin (largestDamping);
    result.participation *= (1 + deviation.participation) * (1 + deviation.voltage);

    if (deviation.voltageSpread > 0)
        for (Eigen::Index i = 0; i < result.actuators(); ++i)
        {
            const auto drawn = normalQuantile (randomUniform (seed, static_cast<std::uint64_t> (i), 0));
            result.participation.col (i) *= std::max (leastGain, 1 + deviation.voltageSpread * drawn);
        }

    return result;
}
} // namespace antinode
