#include "CsvLines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace antinode
{
std::string_view csvStripped (std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\"";
    const auto begin = text.find_first_not_of (blanks);
    return begin == std::string_view::npos ? std::string_view {}
                                           : text.substr (begin, text.find_last_not_of (blanks) - begin + 1);
}

std::vector<CsvLine> csvLines (std::string_view text)
{
    constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
    text.remove_prefix (text.starts_with (byteOrderMark) ? byteOrderMark.size() : 0);
    std::vector<CsvLine> lines;
    std::size_t number = 0;

    for (std::size_t begin = 0; begin < text.size();)
    {
        const auto end = std::min (text.find_first_of ("\n\r", begin), text.size());
        const auto line = text.substr (begin, end - begin);
        ++number;

        if (! csvStripped (line).empty())
            lines.push_back ({ line, number });

        begin = end + (text.substr (end).starts_with ("\r\n") ? 2 : 1);
    }

    return lines;
}

std::size_t csvCommentMark (std::string_view line)
{
    const auto content = csvStripped (line);
    return content.starts_with ("//") ? 2 : content.find_first_of ("#%!") == 0 ? 1 : 0;
}

char csvSeparator (std::string_view line)
{
    const auto content = csvStripped (line);

    for (const auto separator : { ';', '\t' })
        if (content.find (separator) != std::string_view::npos)
            return separator;

    if (content.find (',') == std::string_view::npos)
        return ' ';

    const auto blank = content.find (' ');
    return blank != std::string_view::npos && content.find (", ") == std::string_view::npos
                   && content.find (" ,") == std::string_view::npos
               ? ' '
               : ',';
}

std::vector<std::string_view> csvCells (std::string_view line, char separator)
{
    std::vector<std::string_view> cells;
    auto isQuoted = false;
    std::size_t begin = 0;
    const auto content = separator == ' ' ? csvStripped (line) : line;

    for (std::size_t i = 0; i <= content.size(); ++i)
    {
        const auto isEnd = i == content.size();
        isQuoted = isQuoted != (! isEnd && content[i] == '"');
        const auto separates =
            isEnd || (! isQuoted && (content[i] == separator || (separator == ' ' && content[i] == '\t')));

        if (! separates)
            continue;

        if (const auto cell = csvStripped (content.substr (begin, i - begin)); separator != ' ' || ! cell.empty())
            cells.push_back (cell);

        begin = i + 1;
    }

    return cells;
}

std::optional<double> csvNumber (std::string_view cell, char separator)
{
    constexpr std::size_t longest = 60;
    std::array<char, longest> buffer {};
    const auto nan = std::numeric_limits<double>::quiet_NaN();

    if (cell.empty() || cell == "NaN" || cell == "nan" || cell == "NA")
        return nan;

    cell.remove_prefix (cell.front() == '+' ? 1 : 0);

    if (cell.size() > longest)
        return std::nullopt;

    std::transform (cell.begin(), cell.end(), buffer.begin(),
                    [&] (char character) { return character == ',' && separator != ',' ? '.' : character; });
    double value = 0;
    const auto read = std::from_chars (buffer.data(), buffer.data() + cell.size(), value);

    if (read.ptr != buffer.data() + cell.size() || (read.ec == std::errc {} && ! std::isfinite (value)))
        return std::nullopt;

    return read.ec == std::errc {} ? std::optional (value) : std::nullopt;
}
} // namespace antinode
