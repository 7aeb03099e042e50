#pragma once

#include "Documents.h"
#include "Following.h"

#include <antinode_text/JsonReader.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace antinode
{
/** What a plug-in plays, and what its states keep beside a device and parameters. */
struct SessionRole
{
    const char* schema;         ///< Of its states.
    bool takesVoltages = false; ///< Ceramics are channels of its input, not of its output.
    bool keepsFocus = false;    ///< A focus, with its design, and what follows the device.
    bool isOfFoci = false;      ///< It always has a focus; ceramics can be muted, and its graph be open.

    static const SessionRole foci, ///< Foci by notes: Antinode.
        fingers,                   ///< A waveform for each finger, and foci on top: Antinode Touch.
        plate;                     ///< The surface itself: Antinode Plate.
};

inline constexpr SessionRole SessionRole::foci { "antinode.state/1", false, true, true };
inline constexpr SessionRole SessionRole::fingers { "antinode.touch/1", false, true };
inline constexpr SessionRole SessionRole::plate { "antinode.plate/1", true };

/** All that a host, a preset or an undo keeps: the whole device and focus, never only a path. */
struct SessionState
{
    std::shared_ptr<const DeviceDocument> device;
    std::shared_ptr<const FocusDocument> focus; ///< Of fingers none: notes play nothing; a plate has none.
    std::map<std::string, double> parameters;   ///< By their identifiers, in the units of their texts.
    std::uint64_t mutes = 0;                    ///< Bit i: ceramic i + 1 is muted. Of foci only, as the next line.
    bool isGraphOpen = false;                   ///< Whether it plays by separate nodes.
    FollowingSettings following = {};           ///< A plate has none.
};

/** A state as text: JSON of schema antinode.state/1, antinode.touch/1 or antinode.plate/1; numbers come back to the
   bit. [worker] Docs/FileFormats.md */
std::string stateToText (const SessionState&, const SessionRole& = SessionRole::foci);

/** @throws InputError  "state: ...", where the text is no state of this role, or one of a version that this program
   does not know [worker] */
SessionState readState (std::string_view text, const SessionRole& = SessionRole::foci);

/** How a device is followed, as states keep it: JSON. Docs/FileFormats.md [worker] */
std::string followingToText (const FollowingSettings&);

/** @throws InputError  where it is none [worker] */
FollowingSettings followingFromJson (const JsonValue&);
} // namespace antinode
