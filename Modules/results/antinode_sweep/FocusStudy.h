#pragma once

#include "CaseStudy.h"
#include "SharedValues.h"
#include "SweepInputs.h"

#include <antinode_documents/Library.h>
#include <antinode_focus/FieldPeak.h>

#include <memory>

namespace antinode
{
/** A focus on a device: by a render, or by formula. A device that several cases share is solved once, and a focus that
    they share is designed once. */
class FocusStudy : public CaseStudy
{
public:
    /** @param inputs  live as long as the study @param usesCache  of solved devices */
    FocusStudy (const SweepInputs&, bool usesCache);

    void check (const CaseKeys&) const override;
    nlohmann::ordered_json summary (const CaseKeys&, const Deviation&, std::uint64_t seed) const override;

private:
    struct MadeDesign
    {
        WideDesign made;
        ModalModel modes; ///< Of the played model, without shapes.
        FieldPeak wantedPeak, truncatedPeak;
    };

    std::shared_ptr<const Setup> deviceOf (const CaseKeys&) const;
    std::shared_ptr<const MadeDesign> designOf (const CaseKeys&) const;
    nlohmann::ordered_json closedForm (const MadeDesign&, const Deviation&, std::uint64_t seed) const;
    nlohmann::ordered_json rendered (const MadeDesign&, const Deviation&, std::uint64_t seed) const;

    const SweepInputs& given;
    Playback playback;
    DesignExtent extent;
    bool usesCache;
    mutable SharedValues<Setup> devices;
    mutable SharedValues<MadeDesign> designs;
};
} // namespace antinode
