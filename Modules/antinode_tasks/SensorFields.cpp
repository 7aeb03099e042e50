#include "SensorFields.h"

#include <antinode_base/InputError.h>

namespace antinode
{
std::vector<Field> fields (SensorScale& scale)
{
    constexpr double least = 1e-9, most = 1e9;
    return { Field ("--sensitivity-mm-s-per-v", &scale.sensitivity, "Sensitivity of the sensor, mm/s per V")
                 .as ("sensitivity_mm_s_per_V")
                 .within (least, most)
                 .by ("none"),
             Field ("--input-full-scale-v", &scale.inputFullScale, "Input voltage of a recorded sample of 1, V")
                 .as ("input_full_scale_V")
                 .within (least, most) };
}

void requireSensitivity (const SensorScale& scale)
{
    if (! (scale.sensitivity > 0))
        throw InputError ("--sensitivity-mm-s-per-v", "is missing; give the sensitivity of the sensor in mm/s per V");
}
} // namespace antinode
