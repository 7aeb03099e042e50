#pragma once

#include <antinode_text/JsonReader.h>

namespace antinode
{
/** The limits of a device's ceramics. */
struct VoltageLimits
{
    double voltage = 0;   ///< U_max of every ceramic, V.
    double fullScale = 0; ///< The voltage of a sample of 1.0, V.
    double slew = 0;      ///< Of every amplifier, V/s; 0: none.
    double current = 0;   ///< Of every amplifier, A; 0: none.
    bool requiresArming =
        false; ///< A program that loads the device or a state with it stays silent until its user arms it.
};

/** The object "limits" of a device; the full scale is the limit if it is not given. @throws InputError [worker] */
VoltageLimits readLimits (const JsonValue&);
} // namespace antinode
