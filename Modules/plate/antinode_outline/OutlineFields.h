#pragma once

#include "Outline.h"

#include <antinode_base/StructFields.h>

namespace antinode
{
/** All fields of an outline, in the order of their declaration, to be written or read. [any] */
void fields (auto& stream, Struct<PathPiece> auto& piece)
{
    auto& [start, end, centre, cosine, sine, from, to, isStraight, edge] = piece;

    for (auto* const vector : { &start, &end, &centre, &cosine, &sine })
        stream ((*vector)[0], (*vector)[1]);

    stream (from, to, isStraight, edge);
}

void fields (auto& stream, Struct<Outline> auto& outline)
{
    auto& [paths] = outline;
    stream (paths);
}
} // namespace antinode
