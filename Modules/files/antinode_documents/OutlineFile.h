#pragma once

#include <antinode_outline/Outline.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <functional>

namespace antinode
{
/** Reads an outline from a drawing: its file, and the object of the device file that names it, with further keys. */
using OutlineFileReader = std::function<Outline (const std::filesystem::path&, const nlohmann::json&)>;

/** Puts the paths of drawings in place of the outlines that name them, { "file": "outline.svg", ... }, of a plate and
   of its areas: then the document depends on no other file, as sessions of hosts need it.
    @param folder  where the names of files begin: that of the device file
    @throws InputError  as the reader [worker] Docs/FileFormats.md */
void embedOutlineFiles (nlohmann::json& device, const std::filesystem::path& folder, const OutlineFileReader&);
} // namespace antinode
