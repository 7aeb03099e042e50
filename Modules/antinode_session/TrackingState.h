#pragma once

#include "TrackingSettings.h"

#include <antinode_text/JsonReader.h>

#include <string>

namespace antinode
{
/** How a device is tracked, as states keep it: JSON. Docs/FileFormats.md [worker] */
std::string trackingToText (const TrackingSettings&);

/** @throws InputError  where it is none [worker] */
TrackingSettings trackingFromJson (const JsonValue&);
} // namespace antinode
