#pragma once

#include "DesignRequest.h"

#include <antinode_focus/FocusDesign.h>
#include <antinode_focus/SpillOver.h>

#include <memory>
#include <optional>
#include <string>

namespace antinode
{
/** Designs the places of a bank one after the other, and keeps what they share: the modes beyond the device's own,
   which only waveforms of samples need, and how many of these the first place had to guard. One thread at a time. */
class PlaceDesigner
{
public:
    /** The places that come belong to another request. Where only its voltage limit is another one, guards stay.
     * [worker] */
    void begin (const DesignRequest& request);

    /** A focus of the request, at one of its places or another one.
        @throws InputError, LimitError  as designFocus
        [worker] */
    FocusDesign design (const DesignRequest& request, const FocusDescription&);

private:
    FocusDesign designSamples (const DesignRequest&, const FocusDescription&);
    FocusDesign designKeepingGuards (const FocusDescription&, Playback);
    FocusDesign withAllGuards (FocusDesign, double share, const FocusDescription&, Playback) const;

    std::shared_ptr<const ModalModel> known; ///< What the wide model was made of.
    std::optional<WideModel> wide;
    std::string guardedFocus;          ///< As text, without its limit.
    std::optional<ModalModel> guarded; ///< With what the first place guards beyond; none: no place is designed yet.
    bool areGuardsSure = false;        ///< False: limits moved since they were found.
};
} // namespace antinode
