#pragma once

#include <antinode_fingers/SkinThreshold.h>

#include <string>
#include <string_view>

namespace antinode
{
/** A threshold from a CSV table of two columns, Hz and um.
    @param source  how errors name the file
    @throws InputError  source, what is wrong, what is allowed
    [worker] Docs/FileFormats.md. */
SkinThreshold readSkinThreshold (std::string_view text, const std::string& source);
} // namespace antinode
