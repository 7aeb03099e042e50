#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** The capacitance that an amplifier sees of a ceramic, or of a pair as it is wired. F.
    @return  what was measured, else from the material; 0 where its permittivity is not known
    [any] Docs/Theory.md, section 1.10. */
double capacitance (const CeramicDescription&);

/** The slew limit of a ceramic's voltage, V/s: that of its amplifier, or that of the current limit into the capacitance
   where that is less. 0: as fast as it likes.
    @param ceramic  its index
    @throws InputError  where the current is limited and the permittivity is not known
    [any] Docs/Theory.md, section 1.10. */
double slewLimit (const StructureCommon&, std::size_t ceramic);

/** The area of one electrode, m^2: of one face, of a bender less. [any] */
double faceArea (const CeramicDescription&);

/** Whether a ceramic is a rectangle along the axes. [any] */
bool fillsItsRectangle (const CeramicDescription&);

/** What a ceramic, or a bender's disc, covers, m: one path, of a ring two. Every side is an edge of its own. [any] */
Outline ceramicOutline (const CeramicDescription&);

/** The rectangle along the axes that holds a ceramic. [any] */
OutlineExtent ceramicExtent (const CeramicDescription&);
} // namespace antinode
