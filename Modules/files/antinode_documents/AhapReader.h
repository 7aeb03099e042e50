#pragma once

#include "HapticContent.h"

namespace antinode
{
/** Apple's haptic and audio patterns. As Core Haptics does it, missing keys have their defaults, values out of range
   are clamped, unknown keys are ignored; audio events are left out and counted.
    @throws InputError  source, JSON pointer, what is wrong, what is allowed
    [worker] https://developer.apple.com/documentation/corehaptics/representing-haptic-patterns-in-ahap-files */
HapticContent readAhap (const nlohmann::json&, const std::string& source);
} // namespace antinode
