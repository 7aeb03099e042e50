#pragma once

#include "DxfGroups.h"
#include "Stroke.h"

namespace antinode
{
/** What the readers of entities need to know. */
struct DxfSetting
{
    const std::string& source;
    double unit = 0;      ///< m of one unit of the drawing.
    double deviation = 0; ///< m: how far arcs may lie from free curves.
};

/** What an entity shows, in m.
    @param rest  what follows the entity, for the vertices of a POLYLINE
    @param edge  the number of the next edge, counted on
    @throws InputError  source, entity, what is wrong
    [worker] */
std::vector<PathPiece> dxfPieces (const DxfRecord&, const DxfRecord* rest, const DxfRecord* end, const DxfSetting&,
                                  int& edge);

/** Whether an entity is geometry that dxfPieces() reads. [any] */
bool isDxfCurve (std::string_view type);
} // namespace antinode
