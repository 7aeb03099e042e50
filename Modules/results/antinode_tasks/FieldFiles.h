#pragma once

#include <antinode_render/RenderedFocus.h>
#include <antinode_text/OutputFolder.h>

namespace antinode
{
/** Writes the fields of all foci as tables: field.csv at the points of the surface and, of a plate, section.csv along x
   and y through the first target. Wanted, represented by the controlled modes, reached. [worker] Docs/FileFormats.md.
 */
void writeFields (OutputFolder&, const RenderedFocus&);
} // namespace antinode
