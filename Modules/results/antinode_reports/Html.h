#pragma once

#include <string>
#include <string_view>

namespace antinode
{
/** A text as HTML, for content and for quoted attributes: markup escaped, malformed UTF-8 and characters that HTML
    does not
    allow replaced by U+FFFD. [any] */
std::string escapeHtml (std::string_view utf8);

/** Bytes as a PNG data URI. [any] */
std::string pngDataUri (std::string_view bytes);

/** Whether a table cell reads as a number, with or without sign, unit, thin spaces, a power of ten: such cells are
    aligned at the right. [any] */
bool looksLikeNumber (std::string_view utf8);
} // namespace antinode
