#pragma once

#include <antinode_fingers/SkinThreshold.h>

#include <string>

namespace antinode
{
/** What skin feels by frequency: the table of a file, or the embedded one.
    @param file  CSV of Hz and um; empty: the embedded table
    @throws InputError  when the file cannot be read or is not such a table
    [worker] Docs/FileFormats.md. */
SkinThreshold findSkinThreshold (const std::string& file);
} // namespace antinode
