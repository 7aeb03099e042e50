#pragma once

#include "DesignRequest.h"
#include "Documents.h"
#include "PlaySettings.h"

#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** What a session plays at the moment, for displays. Immutable. */
struct SessionSnapshot
{
    std::uint64_t generation = 0;                 ///< Grows with every snapshot.
    std::shared_ptr<const DeviceDocument> device; ///< The requested device, also while it is being solved.
    std::shared_ptr<const FocusDocument> focusDocument;
    std::shared_ptr<const ModalModel> model; ///< None before the first device is solved.
    PlaySettings settings;                   ///< The settings of the focus below.
    FocusDescription focus;                  ///< As it is designed: the document as the parameters changed it.
    std::vector<std::pair<double, double>> notePlaces; ///< x, y in m of the notes 0 to 127; empty if all play the spot.
    Playback playback;
    bool isAsWritten = false; ///< Whether the focus plays a design that was written before.
    bool isSolving = false;   ///< Whether a device is being solved.
    std::string error;        ///< Why the requested device cannot be played: then the previous one continues.
    std::string fingerError;  ///< Why fingers are left out.
};
} // namespace antinode
