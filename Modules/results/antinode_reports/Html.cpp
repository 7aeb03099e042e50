#include "Html.h"

#include "Utf8.h"

#include <juce_core/juce_core.h>

#include <algorithm>

namespace antinode
{
namespace
{
bool isAllowedInHtml (char32_t c)
{
    const auto isControl = (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || (c >= 0x7F && c < 0xA0);
    const auto isNonCharacter = (c & 0xFFFEU) == 0xFFFE || (c >= 0xFDD0 && c <= 0xFDEF);
    return ! isControl && ! isNonCharacter;
}

void appendEscaped (std::string& html, char32_t c)
{
    switch (c)
    {
        case '&':
            html += "&amp;";
            break;
        case '<':
            html += "&lt;";
            break;
        case '>':
            html += "&gt;";
            break;
        case '"':
            html += "&quot;";
            break;
        case '\'':
            html += "&#39;";
            break;
        default:
            appendUtf8 (html, isAllowedInHtml (c) ? c : U'\uFFFD');
    }
}
} // namespace

std::string escapeHtml (std::string_view utf8)
{
    std::string html;
    html.reserve (utf8.size() + 16);
    for (const auto c : decodeUtf8 (utf8))
        appendEscaped (html, c);
    return html;
}

std::string pngDataUri (std::string_view bytes)
{
    return "data:image/png;base64," + juce::Base64::toBase64 (bytes.data(), bytes.size()).toStdString();
}

bool looksLikeNumber (std::string_view utf8)
{
    constexpr std::u32string_view signs = U"+-−±≈<>≤≥ ", digits = U"0123456789", dashes = U"-–—";
    constexpr std::u32string_view numeral = U"0123456789.,+-−±×eE⁻⁰¹²³⁴⁵⁶⁷⁸⁹\u2009\u202F";
    constexpr std::size_t longestUnit = 8;
    const auto text = decodeUtf8 (utf8);
    const std::u32string_view cell = text;
    if (cell.size() == 1 && dashes.find (cell[0]) != std::u32string_view::npos)
        return true;
    const auto first = std::min (cell.find_first_not_of (signs), cell.size());
    if (first == cell.size() || digits.find (cell[first]) == std::u32string_view::npos)
        return false;
    const auto end = std::min (cell.find_first_not_of (numeral, first), cell.size());
    const auto unit = cell.substr (end);
    return unit.size() <= longestUnit + 1 && unit.find (U' ', 1) == std::u32string_view::npos;
}
} // namespace antinode
