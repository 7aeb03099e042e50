#include "LimitsReader.h"

#include "PhysicalRanges.h"

namespace antinode
{
VoltageLimits readLimits (const JsonValue& value)
{
    const auto limits = value.object ({ "voltage_V", "full_scale_V", "requires_arming" });
    const auto voltage = limits.required ("voltage_V").number (ranges::voltage);
    const auto fullScale = limits.optional ("full_scale_V");
    const auto arming = limits.optional ("requires_arming");
    return { voltage, fullScale ? fullScale->number (ranges::voltage) : voltage, arming && arming->boolean() };
}
} // namespace antinode
