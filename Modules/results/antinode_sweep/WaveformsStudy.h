#pragma once

#include "CaseStudy.h"
#include "SharedValues.h"
#include "SweepInputs.h"

#include <antinode_documents/TrackModels.h>
#include <antinode_tracks/TrackDesign.h>

namespace antinode
{
/** Waveforms at fingers on a device, as `antinode perform` plays them. A device that several cases share is solved
   once, and waveforms that they share are designed once; what deviates is the surface that plays. */
class WaveformsStudy : public CaseStudy
{
public:
    /** @param inputs  live as long as the study @param usesCache  of solved devices */
    WaveformsStudy (const SweepInputs&, bool usesCache);

    void check (const CaseKeys&) const override;
    nlohmann::ordered_json summary (const CaseKeys&, const Deviation&, std::uint64_t seed) const override;

private:
    WaveformsDescription waveformsOf (const CaseKeys&, const std::string& source) const;

    const SweepInputs& given;
    TrackSettings settings;
    bool usesCache;
    mutable SharedValues<TrackModels> devices;
    mutable SharedValues<TrackDesign> designs;
};
} // namespace antinode
