#pragma once

#include <antinode_outline/Outline.h>
#include <antinode_text/JsonReader.h>

#include <string>
#include <vector>

namespace antinode
{
/** An outline from a file, with the names by which the file calls its edges. */
struct NamedOutline
{
    Outline outline;                ///< m
    std::vector<std::string> edges; ///< By their numbers.
};

/** A place as a list of x and y in mm: m. @throws InputError [worker] */
Eigen::Vector2d readPlaneMillimetres (const JsonValue&);

/** The outline of a plate or of an area on it: a shape with holes. Docs/FileFormats.md.
    @throws InputError  as JsonValue, and where it is no outline [worker] */
NamedOutline readOutline (const JsonValue&);

/** What outlineToJson() calls the edge of a piece of the outer path. [any] */
std::string writtenEdgeName (const PathPiece&);

/** An outline as a path with holes, which readOutline() understands; its edges are numbered from 1. [worker] */
nlohmann::json outlineToJson (const Outline&);
} // namespace antinode
