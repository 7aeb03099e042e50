#pragma once

#include "FingerInputs.h"
#include "OutputRouting.h"

#include <antinode_audio/AudioChoice.h>
#include <antinode_session/SessionState.h>
#include <antinode_touch/TouchPorts.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** The selected MIDI inputs. */
struct MidiChoice
{
    bool all = true;                 ///< Including inputs plugged in later.
    std::vector<std::string> inputs; ///< By identifier, where not all.

    bool operator== (const MidiChoice&) const = default;
};

/** All that the standalone program keeps from one time to the next. */
struct StandaloneSettings
{
    AudioChoice audio;
    OutputRouting routing = straightRouting();
    MidiChoice midi;
    TouchPorts touch;
    bool isDark = true;                ///< Else the window is light.
    double scale = 0;                  ///< Of what the window shows; 0: as large as suits it.
    std::optional<SessionState> state; ///< Device, focus and parameters; none: the demonstrator.
    FingerInputs inputs;               ///< Of Antinode Touch, as the next line.
    std::optional<SessionState> touchState;
};

/** JSON of schema antinode.standalone/1; numbers come back to the bit. [worker] Docs/FileFormats.md */
std::string settingsToText (const StandaloneSettings&);

/** @throws InputError  where the text is no settings, or those of a version that this program does not know [worker] */
StandaloneSettings readSettings (std::string_view text);
} // namespace antinode
