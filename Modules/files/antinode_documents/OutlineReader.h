#pragma once

#include <antinode_outline/Outline.h>
#include <antinode_text/JsonReader.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <functional>
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

/** Reads an outline from a drawing: its file, and the object of the device file that names it, with further keys. */
using OutlineFileReader = std::function<Outline (const std::filesystem::path&, const nlohmann::json&)>;

/** Puts the paths of drawings in place of the outlines that name them, { "file": "outline.svg", ... }, of a plate and
   of its areas: then the document depends on no other file, as sessions of hosts need it.
    @param folder  where the names of files begin: that of the device file
    @throws InputError  as the reader [worker] Docs/FileFormats.md */
void embedOutlineFiles (nlohmann::json& device, const std::filesystem::path& folder, const OutlineFileReader&);

/** The outline of a drawing that a device file names: { "file":, "layer"?:, "unit"?: }. An OutlineFileReader.
    @throws InputError  as readOutlineFile(), and where the keys are wrong [worker] Docs/FileFormats.md */
Outline readDrawnOutline (const std::filesystem::path& drawing, const nlohmann::json& keys);
} // namespace antinode
