#pragma once

#include "HapticContent.h"

namespace antinode
{
/** The interchange format of MPEG haptics, JSON: vibrotactile perceptions, the sum of their channels, with bands of
    vectorial waves, transients and curves as the reference software synthesises them. Wavelet bands and composite
   effects are refused, other perceptions left out.
    @throws InputError  source, JSON pointer, what is wrong, what is allowed
    [worker] ISO/IEC 23090-31 */
HapticContent readHjif (const nlohmann::json&, const std::string& source);
} // namespace antinode
