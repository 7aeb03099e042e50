#include "CeramicLag.h"

#include "FileUnits.h"

#include <antinode_model/LongestLag.h>

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
} // namespace antinode
