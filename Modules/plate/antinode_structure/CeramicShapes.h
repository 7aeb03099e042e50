#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** The area of one electrode, m^2: of one face, of a bender less. [any] */
double faceArea (const CeramicDescription&);

/** Whether a ceramic is a rectangle along the axes. [any] */
bool fillsItsRectangle (const CeramicDescription&);

/** What a ceramic, or a bender's disc, covers, m: one path, of a ring two. Every side is an edge of its own. [any] */
Outline ceramicOutline (const CeramicDescription&);

/** The rectangle along the axes that holds a ceramic. [any] */
OutlineExtent ceramicExtent (const CeramicDescription&);
} // namespace antinode
