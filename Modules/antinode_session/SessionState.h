#pragma once

#include "Documents.h"
#include "FollowingSettings.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace antinode
{
/** All that a host, a preset or an undo keeps: the whole device and focus, never only a path. */
struct SessionState
{
    std::shared_ptr<const DeviceDocument> device;
    std::shared_ptr<const FocusDocument> focus;
    std::map<std::string, double> parameters; ///< By their identifiers, in the units of their texts.
    std::uint64_t mutes = 0;                  ///< Bit i: ceramic i + 1 is muted.
    bool isGraphOpen = false;                 ///< Whether it plays by separate nodes.
    FollowingSettings following = {};
};

/** A state as text: JSON of schema antinode.state/1; numbers come back to the bit. [worker] Docs/FileFormats.md */
std::string stateToText (const SessionState&);

/** @throws InputError  "state: ...", where the text is no state, or one of a version that this program does not know
    [worker] */
SessionState readState (std::string_view text);
} // namespace antinode
