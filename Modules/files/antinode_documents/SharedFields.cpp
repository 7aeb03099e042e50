#include "SharedFields.h"

#include "FileUnits.h"

#include <antinode_model/ModalModel.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
InputLag readLag (const JsonValue& value)
{
    constexpr NumberRange degrees { -45, 45 };
    const NumberRange microsecond { 0, toMicroseconds (longestLag) };
    const auto object = value.object ({ "delay_us", "time_constant_us", "angle_deg" });
    const auto read = [&] (const char* key, NumberRange range)
    {
        const auto number = object.optional (key);
        return number ? number->number (range) : 0.0;
    };
    return { fromMicroseconds (read ("delay_us", microsecond)),
             fromMicroseconds (read ("time_constant_us", microsecond)), fromDegrees (read ("angle_deg", degrees)) };
}

nlohmann::ordered_json lagToJson (const InputLag& lag)
{
    return { { "delay_us", toMicroseconds (lag.delay) },
             { "time_constant_us", toMicroseconds (lag.timeConstant) },
             { "angle_deg", toDegrees (lag.angle) } };
}

namespace
{
constexpr std::string_view ratioKey = "damping_ratio";
constexpr std::string_view qualityKey = "quality_factor";

double ratioOfQuality (double qualityFactor)
{
    return 1 / (2 * qualityFactor);
}
} // namespace

std::vector<double> readDampingRatios (const JsonObject& object)
{
    const auto [key, value] = object.oneOf (ratioKey, qualityKey);

    if (key == ratioKey)
        return value.numberOrNumbers (ranges::maximumModes, ranges::dampingRatio);

    auto ratios = value.numberOrNumbers (ranges::maximumModes, ranges::qualityFactor);

    for (auto& ratio : ratios)
        ratio = ratioOfQuality (ratio);

    return ratios;
}

double readDampingRatio (const JsonObject& mode)
{
    const auto [key, value] = mode.oneOf (ratioKey, qualityKey);
    return key == ratioKey ? value.number (ranges::dampingRatio)
                           : ratioOfQuality (value.number (ranges::qualityFactor));
}

VoltageLimits readLimits (const JsonValue& value)
{
    const auto limits =
        value.object ({ "voltage_V", "full_scale_V", "slew_V_per_us", "current_mA", "requires_arming" });
    const auto voltage = limits.required ("voltage_V").number (ranges::voltage);
    const auto fullScale = limits.optional ("full_scale_V");
    const auto slew = limits.optional ("slew_V_per_us");
    const auto current = limits.optional ("current_mA");
    const auto arming = limits.optional ("requires_arming");
    return { voltage, fullScale ? fullScale->number (ranges::voltage) : voltage,
             slew ? fromVoltsPerMicrosecond (slew->number (ranges::slewVoltsPerMicrosecond)) : 0.0,
             current ? fromMilliamperes (current->number (ranges::currentMilliampere)) : 0.0,
             arming && arming->boolean() };
}

namespace
{
constexpr WordList<ModeSource, 4> sourceWords { { { "given", ModeSource::given },
                                                  { "drawn", ModeSource::drawn },
                                                  { "retuned", ModeSource::retuned },
                                                  { "measured", ModeSource::measured } } };
constexpr WordList<bool, 2> scaleWords { { { "known", true }, { "convention", false } } };
constexpr int mostPoints = 1000000;
constexpr double percent = 100;
} // namespace

ModeOrigin readOrigin (const JsonValue& value)
{
    const auto object = value.object ({ "modes", "points", "unexplained_percent", "scale" });
    ModeOrigin origin { object.required ("modes").choice (sourceWords) };

    if (const auto points = object.optional ("points"))
        origin.points = points->integer (0, mostPoints);

    if (const auto unexplained = object.optional ("unexplained_percent"))
        origin.unexplained = unexplained->number ({ 0, percent }) / percent;

    if (const auto scale = object.optional ("scale"))
        origin.scaleIsKnown = scale->choice (scaleWords);

    return origin;
}

nlohmann::ordered_json originToJson (const ModeOrigin& origin)
{
    nlohmann::ordered_json json { { "modes", wordFor (sourceWords, origin.source) } };

    if (origin.points > 0)
    {
        json["points"] = origin.points;
        json["unexplained_percent"] = percent * origin.unexplained;
    }

    if (! origin.scaleIsKnown)
        json["scale"] = wordFor (scaleWords, false);

    return json;
}

std::string readNamedDevice (const std::optional<JsonValue>& device)
{
    constexpr std::size_t longestPath = 4000; // bytes

    if (! device)
        return {};

    auto name = device->text (longestPath);

    if (name.empty())
        device->fail ("is empty; allowed: the name of a device, or a file that ends in .json");

    return name;
}
} // namespace antinode
