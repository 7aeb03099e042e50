#include "FileUnits.h"
#include "FingerFile.h"
#include "FocusFile.h"
#include "FocusWords.h"

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
using Json = nlohmann::ordered_json;

template <typename T>
void put (Json& object, const char* key, const std::optional<T>& value)
{
    if (value)
        object[key] = *value;
}

void putMilliseconds (Json& object, const char* key, const std::optional<double>& seconds)
{
    if (seconds)
        object[key] = toMilliseconds (*seconds);
}

Json targetToJson (const Target& target)
{
    Json object { { "shape", wordFor (targetShapeWords, target.shape) },
                  { "profile", wordFor (targetProfileWords, target.profile) },
                  { "x_mm", toMillimetres (target.x) },
                  { "y_mm", toMillimetres (target.y) },
                  { "width_mm", toMillimetres (target.width) } };

    if (target.widthY)
        object["width_y_mm"] = toMillimetres (*target.widthY);

    object["peak_velocity_mm_s"] = toMillimetres (target.peakVelocity);
    object["phase"] = target.phase;
    putMilliseconds (object, "time_ms", target.time);
    return object;
}

Json modesToJson (const ModeChoice& modes)
{
    auto object = Json::object();
    put (object, "count", modes.count);
    put (object, "captured", modes.captured);
    put (object, "maximum_frequency_Hz", modes.maximumFrequency);

    if (modes.count)
        object["choose"] = wordFor (modeOrderWords, modes.order);

    return object;
}

Json transientsToJson (const TransientChoice& transients)
{
    Json object { { "drive", wordFor (driveKindWords, transients.drive) } };

    if (! transients.growth.empty())
        object["growth"] = transients.growth;

    if (! transients.cycles.empty())
        object["cycles"] = transients.cycles;

    putMilliseconds (object, "maximum_duration_ms", transients.maximumDuration);
    put (object, "brake", transients.brake);
    putMilliseconds (object, "brake_duration_ms", transients.brakeDuration);
    return object;
}

Json robustnessToJson (const Robustness& robustness)
{
    return { { "frequency_percent", toPercent (robustness.spread.frequency) },
             { "damping_percent", toPercent (robustness.spread.damping) },
             { "participation_percent", toPercent (robustness.spread.participation) },
             { "drift_percent", toPercent (robustness.spread.drift) },
             { "weight", robustness.weight } };
}

Json allocationToJson (const AllocationChoice& allocation)
{
    Json object { { "method", wordFor (allocationMethodWords, allocation.method) } };
    put (object, "voltage_limit_V", allocation.voltageLimit);
    object["guard_modes"] = allocation.guardModes ? Json (*allocation.guardModes) : Json ("all");
    object["guard_weight"] = allocation.guardWeight;
    putMilliseconds (object, "window_ms", allocation.window);

    if (allocation.isUndisplaced)
        object["displacement"] = "zero";

    if (allocation.robust)
        object["robust"] = robustnessToJson (*allocation.robust);

    put (object, "times_bound", allocation.timesBound);

    return object;
}

Json placesToJson (const std::vector<std::pair<double, double>>& places)
{
    auto list = Json::array();

    for (const auto& [x, y] : places)
        list.push_back ({ toMillimetres (x), toMillimetres (y) });

    return list;
}

Json feltToJson (const FeltChoice& felt)
{
    return { { "at", felt.at == FeltAt::places ? placesToJson (felt.places) : Json (wordFor (feltAtWords, felt.at)) },
             { "weight", felt.weight },
             { "after_ms", toMilliseconds (felt.after) } };
}
} // namespace

nlohmann::ordered_json focusToJson (const FocusDescription& focus)
{
    Json object { { "schema", "antinode.focus/1" }, { "name", focus.name } };
    object["targets"] = Json::array();

    for (const auto& target : focus.targets)
        object["targets"].push_back (targetToJson (target));

    object["focus_time_ms"] = toMilliseconds (focus.focusTime);
    object["modes"] = modesToJson (focus.modes);
    object["transients"] = transientsToJson (focus.transients);
    object["allocation"] = allocationToJson (focus.allocation);

    if (focus.edgeWindow)
        object["edge_window"] = { { "tukey", *focus.edgeWindow } };

    object["probes_mm"] = placesToJson (focus.probes);

    for (const auto& finger : focus.fingers)
        object["fingers"].push_back (fingerToJson (finger));

    if (focus.felt)
        object["felt"] = feltToJson (*focus.felt);

    return object;
}
} // namespace antinode
