#pragma once

#include <antinode_outline/Outline.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace antinode
{
/** The outline of a drawing that a device file names: { "file":, "layer"?:, "unit"?: }. An OutlineFileReader.
    @throws InputError  as readOutlineFile(), and where the keys are wrong [worker] Docs/FileFormats.md */
Outline readDrawnOutline (const std::filesystem::path& drawing, const nlohmann::json& keys);
} // namespace antinode
