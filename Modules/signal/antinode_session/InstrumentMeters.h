#pragma once

#include "FingerMeters.h"
#include "LevelMeters.h"
#include "ProbeTrace.h"

namespace antinode
{
/** What the audio thread tells of an instrument; goes on from path to path. */
struct InstrumentMeters
{
    LevelMeters levels;
    ProbeTrace trace; ///< Of the first probe of the monitor.
    FingerMeters fingers;
};
} // namespace antinode
