#pragma once

#include "Library.h"

#include <antinode_focus/WideDesign.h>
#include <antinode_model/Playback.h>

namespace antinode
{
/** A device as foci are played on it, solved once. */
struct Setup
{
    ModalModel known; ///< The device's own modes.
    WideModel wide;   ///< With modes to widePlay times its own.
    WidenModel widen; ///< How more are found.
    Playback playback;
};

/** A device solved with the modes beyond its own that voltages of a sample rate excite.
    @throws InputError  for anything that cannot be solved [worker] Docs/Theory.md, section 5.2. */
Setup setUp (const DeviceDescription&, Playback, bool usesCache);

/** The same modes of a device whose own are known. @throws InputError  as setUp [worker] */
WideModel widened (const DeviceDescription&, const ModalModel& known, double sampleRate, bool usesCache);
} // namespace antinode
