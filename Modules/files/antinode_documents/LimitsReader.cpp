#include "LimitsReader.h"

#include "FileUnits.h"

#include <antinode_text/PhysicalRanges.h>

namespace antinode
{
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
} // namespace antinode
