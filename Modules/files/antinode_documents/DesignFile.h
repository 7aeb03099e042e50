#pragma once

#include <antinode_focus/FocusDesign.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** A design as design.json: the focus, what is played, its certificate, what was chosen and why. Docs/FileFormats.md.
    Modes are numbered from 1 in the order of the model. [worker] */
nlohmann::ordered_json designToJson (const FocusDesign&, const ModalModel&);

/** A design that was written as design.json, to be played on the device that it was made for: what is played, what is
    wanted and what is known of it. Voltages stay within the device's limits as well as within those of the design.
    @param model   with the modes that the design knew: the device's own, or those under the fingers it knew
    @param source  how errors name it
    @throws InputError  source, JSON pointer, what is wrong, what is allowed; where it was made for another device
    [worker] */
FocusDesign readDesign (const nlohmann::json&, const std::string& source, const ModalModel& model);

/** What a design was made for. */
struct DesignOrigin
{
    std::string device; ///< Its name.
    Playback playback;
    bool isSampled = false; ///< It can be played so only.
    FocusDescription focus;
};

/** Whether a document says that it is a design, of whatever version. [any] */
bool isDesignFile (const nlohmann::json&);

/** @throws InputError  as readDesign [worker] */
DesignOrigin readDesignOrigin (const nlohmann::json&, const std::string& source);
} // namespace antinode
