#pragma once

#include "Outline.h"

#include <string>

namespace antinode
{
/** The largest number of lines and arcs of an outline. */
inline constexpr std::size_t maximumPieces = 20000;

/** Whether an outline is one: finite, closed paths that enclose something, neither cross nor touch, and holes that lie
   in the first path and not in each other. A tenth of a second for 10^5 lines.
    @param name  how the error names it, for example "plate.json: /outline"
    @throws InputError  one sentence: where, what is wrong, in mm
    [any] */
void checkOutline (const Outline&, const std::string& name);

/** A part that lies on a plate, such as a ceramic. */
struct OutlinePart
{
    std::string name; ///< How errors name it, for example "plate.json: /ceramics/3".
    Outline outline;
};

/** Whether parts lie on a plate and not on each other; they may be flush with its edges and with each other.
    @param plate  that checkOutline() lets pass
    @throws InputError  one sentence: which part, what it crosses, in mm
    [any] */
void checkParts (const Outline& plate, const std::vector<OutlinePart>& parts);
} // namespace antinode
