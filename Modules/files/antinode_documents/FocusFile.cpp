#include "FocusFile.h"

#include "FileUnits.h"
#include "FingerFile.h"
#include "SharedFields.h"
#include "SkinThresholds.h"

#include <antinode_base/MessageText.h>
#include <antinode_text/JsonReader.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
constexpr std::size_t maximumTargets = 64;
constexpr std::size_t maximumProbes = 64;
constexpr std::size_t maximumQuietPlaces = 10;
constexpr int maximumCycles = 1000000;
constexpr NumberRange velocityMillimetresPerSecond { 1e-6, 1e7 };
constexpr NumberRange levelDecibels { -60, 80 };
constexpr double velocityWithLevel = 0.01; ///< m/s, until the level is known.
constexpr NumberRange captured { 0, 1, true };
constexpr NumberRange growth { 0, 1000 };
constexpr NumberRange brake { 1, 1000, true };
constexpr NumberRange brakeMilliseconds { 1, 1000 };
constexpr NumberRange guardWeight { 0, 1e12 };
constexpr NumberRange timesBound { 1.02, 100 };
constexpr NumberRange robustWeight { 0, 1e9, true };
constexpr NumberRange feltWeight { 0, 1e6 };
constexpr NumberRange feltAfter { 5, 100 }; // below, it is the shortness that takes volts
constexpr NumberRange tukey { 0, 1 };

std::optional<double> optionalNumber (const JsonObject& object, std::string_view key, const NumberRange& range)
{
    const auto given = object.optional (key);
    return given ? std::optional (given->number (range)) : std::nullopt;
}

std::optional<double> optionalMilliseconds (const JsonObject& object, std::string_view key)
{
    const auto given = optionalNumber (object, key, ranges::timeMillisecond);
    return given ? std::optional (fromMilliseconds (*given)) : std::nullopt;
}

Target readTarget (const JsonValue& value)
{
    const auto object = value.object ({ "shape", "profile", "x_mm", "y_mm", "width_mm", "width_y_mm",
                                        "peak_velocity_mm_s", "peak_level_dB_SL", "phase", "time_ms" });
    Target target;
    target.shape = object.required ("shape").choice (targetShapeWords);
    target.x = fromMillimetres (object.required ("x_mm").number (ranges::positionMillimetre));
    target.y = fromMillimetres (optionalNumber (object, "y_mm", ranges::positionMillimetre).value_or (0));
    target.width = fromMillimetres (object.required ("width_mm").number (ranges::lengthMillimetre));
    target.level = optionalNumber (object, "peak_level_dB_SL", levelDecibels);

    if (target.level && object.optional ("peak_velocity_mm_s"))
        object.fail ("has two sizes; allowed: one of 'peak_velocity_mm_s' and 'peak_level_dB_SL'");

    target.peakVelocity =
        target.level ? velocityWithLevel
                     : fromMillimetres (object.required ("peak_velocity_mm_s").number (velocityMillimetresPerSecond));

    if (const auto phase = object.optional ("phase"))
        target.phase = phase->sign();

    target.time = optionalMilliseconds (object, "time_ms");

    if (const auto profile = object.optional ("profile"))
        target.profile = profile->choice (targetProfileWords);

    if (const auto width = object.optional ("width_y_mm"))
    {
        if (target.profile == TargetProfile::radial)
            width->fail ("is given for a radial target, which has one width; allowed only with "
                         "\"profile\": \"separable\"");

        target.widthY = fromMillimetres (width->number (ranges::lengthMillimetre));
    }

    return target;
}

ModeChoice readModeChoice (const JsonValue& value)
{
    const auto object = value.object ({ "count", "choose", "captured", "maximum_frequency_Hz" });
    const auto count = object.optional ("count");
    const auto choose = object.optional ("choose");
    ModeChoice modes;
    modes.captured = optionalNumber (object, "captured", captured);
    modes.maximumFrequency = optionalNumber (object, "maximum_frequency_Hz", ranges::frequencyHz);

    if (count)
        modes.count = count->integer (1, static_cast<int> (ranges::maximumModes));

    if (modes.count.has_value() + modes.captured.has_value() + modes.maximumFrequency.has_value() > 1)
        value.fail ("has more than one of 'count', 'captured' and 'maximum_frequency_Hz'; allowed: at most one");

    if (choose && ! count)
        choose->fail ("is given without 'count'; allowed only together");

    if (choose)
        modes.order = choose->choice (modeOrderWords);

    return modes;
}

std::vector<int> readCycles (const JsonValue& value)
{
    if (! value.isList())
        return { value.integer (0, maximumCycles) };

    std::vector<int> cycles;

    for (const auto& item : value.items (1, ranges::maximumModes))
        cycles.push_back (item.integer (0, maximumCycles));

    return cycles;
}

TransientChoice readTransients (const JsonValue& value)
{
    const auto object =
        value.object ({ "drive", "growth", "cycles", "maximum_duration_ms", "brake", "brake_duration_ms" });
    TransientChoice transients;

    if (const auto drive = object.optional ("drive"))
        transients.drive = drive->choice (driveKindWords);

    if (const auto given = object.optional ("growth"))
        transients.growth = given->numberOrNumbers (ranges::maximumModes, growth);

    if (const auto given = object.optional ("cycles"))
        transients.cycles = readCycles (*given);

    transients.maximumDuration = optionalMilliseconds (object, "maximum_duration_ms");
    transients.brake = optionalNumber (object, "brake", brake);

    if (const auto duration = optionalNumber (object, "brake_duration_ms", brakeMilliseconds))
        transients.brakeDuration = fromMilliseconds (*duration);

    return transients;
}

/** The number of guarded modes; no value for "all". */
std::optional<int> readGuardModes (const JsonValue& value)
{
    if (value.isString())
        return value.choice (WordList<std::optional<int>, 1> { { { "all", std::nullopt } } });

    return value.integer (0, static_cast<int> (ranges::maximumModes));
}

/** Percentages as fractions; missing ones have their defaults. */
Robustness readRobustness (const JsonValue& value)
{
    const auto object =
        value.object ({ "frequency_percent", "damping_percent", "participation_percent", "drift_percent", "weight" });
    Robustness robustness;
    const auto read = [&] (const char* key, const NumberRange& range, double& share)
    {
        if (const auto given = object.optional (key))
            share = fromPercent (given->number (range));
    };
    read ("frequency_percent", ranges::frequencySpreadPercent, robustness.spread.frequency);
    read ("damping_percent", ranges::spreadPercent, robustness.spread.damping);
    read ("participation_percent", ranges::spreadPercent, robustness.spread.participation);
    read ("drift_percent", ranges::frequencySpreadPercent, robustness.spread.drift);
    robustness.weight = optionalNumber (object, "weight", robustWeight).value_or (robustness.weight);
    return robustness;
}

/** @param choice  with what decides what is used where the method is no longer offered */
AllocationChoice readMethod (const JsonValue& value, AllocationChoice choice)
{
    for (const auto& retired : retiredMethods)
        if (value.isWord (retired.word))
            return withRetired (choice, retired);

    choice.method = value.choice (allocationMethodWords);
    return choice;
}

double readTimesBound (const JsonValue& value, const AllocationChoice& choice)
{
    if (choice.method != AllocationMethod::leastVoltage || choice.retired != nullptr)
        value.fail ("is given with a method other than least_voltage; allowed only with least_voltage");

    return value.isString() ? value.choice (timesBoundWords) : value.number (timesBound);
}

/** Rows and samples that other keys of the allocation ask for have to suit its method. */
void checkMethod (const JsonObject& object, const AllocationChoice& choice)
{
    const auto isExact = choice.method == AllocationMethod::exact;

    if (choice.isUndisplaced && ! isExact)
        object.required ("displacement").fail ("is 'zero' with a method other than exact; allowed only with exact");

    if (choice.isUndisplaced && choice.robust)
        object.required ("displacement").fail ("is 'zero' together with 'robust'; allowed: one of the two");

    if (choice.robust && ! isExact && ! choice.isNearBound())
        object.required ("robust").fail (
            "is given with a method other than exact or least_voltage, or up to the limit; "
            "allowed only with exact, and with least_voltage near its bound");
}

AllocationChoice readAllocation (const JsonValue& value)
{
    const auto object = value.object ({ "method", "voltage_limit_V", "guard_modes", "guard_weight", "window_ms",
                                        "displacement", "robust", "times_bound" });
    AllocationChoice allocation;

    if (const auto displacement = object.optional ("displacement"))
        allocation.isUndisplaced = displacement->choice (WordList<bool, 2> { { { "free", false }, { "zero", true } } });

    if (const auto method = object.optional ("method"))
        allocation = readMethod (*method, allocation);

    if (const auto guards = object.optional ("guard_modes"))
        allocation.guardModes = readGuardModes (*guards);

    allocation.voltageLimit = optionalNumber (object, "voltage_limit_V", ranges::voltage);
    allocation.guardWeight = optionalNumber (object, "guard_weight", guardWeight).value_or (allocation.guardWeight);
    allocation.window = optionalMilliseconds (object, "window_ms");

    if (const auto times = object.optional ("times_bound"))
        allocation.timesBound = readTimesBound (*times, allocation);

    if (const auto robust = object.optional ("robust"))
        allocation.robust = readRobustness (*robust);

    checkMethod (object, allocation);
    return allocation;
}

Finger readPlacedFinger (const JsonValue& value)
{
    std::vector<std::string_view> keys { "x_mm", "y_mm" };
    keys.insert (keys.end(), fingerKeys.begin(), fingerKeys.end());
    const auto object = value.object (keys);
    return readFinger (object, fromMillimetres (object.required ("x_mm").number (ranges::positionMillimetre)),
                       fromMillimetres (optionalNumber (object, "y_mm", ranges::positionMillimetre).value_or (0)));
}

std::vector<std::pair<double, double>> readPlaces (const JsonValue& value, std::size_t fewest, std::size_t most)
{
    std::vector<std::pair<double, double>> places;

    for (const auto& item : value.items (fewest, most))
    {
        const auto place = item.numbers (2, 2, ranges::positionMillimetre);
        places.emplace_back (fromMillimetres (place[0]), fromMillimetres (place[1]));
    }

    return places;
}

/** What else a focus asks for decides whether it can ask for this too. */
FeltChoice readFelt (const JsonValue& value, const FocusDescription& focus)
{
    const auto object = value.object ({ "at", "weight", "after_ms" });
    FeltChoice felt;

    if (! focus.allocation.isUpToLimits())
        value.fail ("is given without samples up to the limit; allowed only with \"method\": \"least_voltage\" and "
                    "\"times_bound\": \"limit\"");

    if (focus.transients.brake || focus.transients.brakeDuration)
        value.fail ("is given together with a brake; allowed: one of the two");

    if (const auto at = object.required ("at"); at.isList())
    {
        felt.at = FeltAt::places;
        felt.places = readPlaces (at, 1, maximumQuietPlaces);
    }
    else
        felt.at = at.choice (feltAtWords);

    felt.weight = optionalNumber (object, "weight", feltWeight).value_or (felt.weight);

    if (const auto after = optionalNumber (object, "after_ms", feltAfter))
        felt.after = fromMilliseconds (*after);

    return felt;
}
} // namespace

FocusDescription readFocus (const nlohmann::json& document, const std::string& source)
{
    const JsonValue value (document, source);
    value.requireSchema ("antinode.focus/1");
    const auto object = value.object ({ "schema", "name", "device", "targets", "focus_time_ms", "modes", "transients",
                                        "allocation", "edge_window", "probes_mm", "fingers", "felt" });
    FocusDescription focus;
    focus.threshold = findSkinThreshold ({});

    for (const auto& target : object.required ("targets").items (1, maximumTargets))
        focus.targets.push_back (readTarget (target));

    focus.focusTime = fromMilliseconds (object.required ("focus_time_ms").number (ranges::timeMillisecond));

    if (const auto name = object.optional ("name"))
        focus.name = name->text (ranges::maximumNameBytes);

    readNamedDevice (object.optional ("device"));

    if (const auto modes = object.optional ("modes"))
        focus.modes = readModeChoice (*modes);

    if (const auto transients = object.optional ("transients"))
        focus.transients = readTransients (*transients);

    if (const auto allocation = object.optional ("allocation"))
        focus.allocation = readAllocation (*allocation);

    if (const auto window = object.optional ("edge_window"))
        focus.edgeWindow = window->object ({ "tukey" }).required ("tukey").number (tukey);

    if (const auto probes = object.optional ("probes_mm"))
        focus.probes = readPlaces (*probes, 0, maximumProbes);

    if (const auto fingers = object.optional ("fingers"))
        for (const auto& finger : fingers->items (0, maximumFingers))
            focus.fingers.push_back (readPlacedFinger (finger));

    if (const auto felt = object.optional ("felt"))
        focus.felt = readFelt (*felt, focus);

    return focus;
}

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

    if (target.level)
        object["peak_level_dB_SL"] = *target.level;
    else
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

    if (allocation.isUpToLimits())
        object["times_bound"] = wordFor (timesBoundWords, upToLimits);
    else
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
