#include "WaveformsStudy.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_render/PerformedWaveforms.h>
#include <antinode_tracks/LiveTracks.h>

namespace antinode
{
WaveformsStudy::WaveformsStudy (const SweepInputs& inputs, bool usesCacheToUse)
    : given (inputs), usesCache (usesCacheToUse), devices (devicesToKeep), designs (designsToKeep)
{
    settings.sampleRate = inputs.plan.sampleRate;
    settings.latency = inputs.plan.latency;
    settings.threshold = findSkinThreshold ({});
}

WaveformsDescription WaveformsStudy::waveformsOf (const CaseKeys& all, const std::string& source) const
{
    return waveformsFromDocument (assigned (given.waveforms(), keysOf (all, "waveforms.")), source, "waveforms");
}

void WaveformsStudy::check (const CaseKeys& all) const
{
    readDevice (assigned (given.device(), keysOf (all, "device.")), "case 0: device");
    waveformsOf (all, "case 0: waveforms");
}

nlohmann::ordered_json WaveformsStudy::summary (const CaseKeys& all, const Deviation& deviation,
                                                std::uint64_t seed) const
{
    const auto deviceKeys = keysOf (all, "device.");
    const auto models =
        devices.get (textOf (deviceKeys), [&]
                     { return trackModels (readDevice (assigned (given.device(), deviceKeys), "device"), usesCache); });
    const auto make = [&]
    {
        const auto waveforms = waveformsOf (all, "waveforms");
        return settings.latency > 0 ? designLiveTracks (models->known, waveforms, settings)
                                    : designTracks (models->known, waveforms, settings);
    };
    const auto design = designs.get (textOf (deviceKeys) + "\n" + textOf (keysOf (all, "waveforms.")), make);

    if (deviation.isNone())
        return performedToJson (performDesigned (models->judge, *design, settings.threshold));

    requireRealModes (models->judge, "deviations");
    return performedToJson (performDesigned (deviated (models->judge, deviation, seed), *design, settings.threshold));
}
} // namespace antinode
