#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** The word for a device's kind, as files and tables have it: "beam", "staple", "plate" or "modal"; of a measured one
   that of its drawing. [any]
 */
const char* deviceKind (const DeviceDescription&);
} // namespace antinode
