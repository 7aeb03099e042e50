#include "Setup.h"

#include <antinode_focus/SpillOver.h>

#include <utility>

namespace antinode
{
Setup setUp (const DeviceDescription& device, Playback playback, bool usesCache)
{
    auto known = solveDevice (device, {}, usesCache);
    auto wide = widened (device, known, playback.sampleRate, usesCache);
    const WidenModel widen = [device, usesCache] (const ModalModel& model, double frequency)
    { return solveWide (device, model, frequency, usesCache); };
    return { std::move (known), std::move (wide), widen, playback };
}

WideModel widened (const DeviceDescription& device, const ModalModel& known, double sampleRate, bool usesCache)
{
    return solveWide (device, known, frequencyBeyond (known, sampleRate), usesCache);
}
} // namespace antinode
