#pragma once

#include <antinode_fingers/Sensation.h>

#include <string>
#include <string_view>

namespace antinode
{
/** What skin feels by frequency: the table of a file, or the embedded one.
    @param file  CSV of Hz and um; empty: the embedded table
    @throws InputError  when the file cannot be read or is not such a table
    [worker] Docs/FileFormats.md. */
SkinThreshold findSkinThreshold (const std::string& file);

/** A threshold from a CSV table of two columns, Hz and um.
    @param source  how errors name the file
    @throws InputError  source, what is wrong, what is allowed
    [worker] Docs/FileFormats.md. */
SkinThreshold readSkinThreshold (std::string_view text, const std::string& source);
} // namespace antinode
