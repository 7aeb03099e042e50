#pragma once

#include <string>
#include <string_view>

namespace antinode
{
/** The code points of a UTF-8 text. Each byte that does not belong to one becomes U+FFFD, so that a name from any file
   can be drawn and written. [any] */
std::u32string decodeUtf8 (std::string_view);

/** Appends one code point. [any] */
void appendUtf8 (std::string& text, char32_t codePoint);
} // namespace antinode
