#include "Utf8.h"

namespace antinode
{
namespace
{
constexpr char32_t replacement = 0xFFFD;

struct Decoded
{
    char32_t codePoint = replacement;
    std::size_t bytes = 1;
};

bool isAllowed (char32_t codePoint, std::size_t bytes)
{
    const char32_t minimum = bytes == 2 ? 0x80 : bytes == 3 ? 0x800 : 0x10000;
    const auto isSurrogate = codePoint >= 0xD800 && codePoint < 0xE000;
    return codePoint >= minimum && codePoint <= 0x10FFFF && ! isSurrogate;
}

Decoded decodeFirst (std::string_view text)
{
    const auto lead = static_cast<unsigned char> (text[0]);
    if (lead < 0x80)
        return { lead, 1 };
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes)
        return {};
    char32_t codePoint = lead & (0xFFU >> (bytes + 1));
    for (std::size_t k = 1; k < bytes; ++k)
    {
        const auto next = static_cast<unsigned char> (text[k]);
        if ((next & 0xC0U) != 0x80)
            return {};
        codePoint = (codePoint << 6) | (next & 0x3FU);
    }
    return isAllowed (codePoint, bytes) ? Decoded { codePoint, bytes } : Decoded {};
}
} // namespace

std::u32string decodeUtf8 (std::string_view text)
{
    std::u32string codePoints;
    while (! text.empty())
    {
        const auto [codePoint, bytes] = decodeFirst (text);
        codePoints += codePoint;
        text.remove_prefix (bytes);
    }
    return codePoints;
}

void appendUtf8 (std::string& text, char32_t codePoint)
{
    const auto tail = [&] (int shift) { text += static_cast<char> (0x80U | ((codePoint >> shift) & 0x3FU)); };
    if (codePoint < 0x80)
    {
        text += static_cast<char> (codePoint);
    }
    else if (codePoint < 0x800)
    {
        text += static_cast<char> (0xC0U | (codePoint >> 6));
        tail (0);
    }
    else if (codePoint < 0x10000)
    {
        text += static_cast<char> (0xE0U | (codePoint >> 12));
        tail (6);
        tail (0);
    }
    else
    {
        text += static_cast<char> (0xF0U | (codePoint >> 18));
        tail (12);
        tail (6);
        tail (0);
    }
}
} // namespace antinode
