#include "CsvTable.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace antinode
{
namespace
{
using Cells = std::vector<std::string_view>;

struct Line
{
    std::string_view text;
    std::size_t number = 0; ///< From 1.
};

std::string_view stripped (std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\"";
    const auto begin = text.find_first_not_of (blanks);
    return begin == std::string_view::npos ? std::string_view {}
                                           : text.substr (begin, text.find_last_not_of (blanks) - begin + 1);
}

/** The lines that are not blank. */
std::vector<Line> linesOf (std::string_view text)
{
    std::vector<Line> lines;
    std::size_t number = 0;

    for (std::size_t begin = 0; begin < text.size();)
    {
        const auto end = std::min (text.find_first_of ("\n\r", begin), text.size());
        const auto line = text.substr (begin, end - begin);
        ++number;

        if (! stripped (line).empty())
            lines.push_back ({ line, number });

        begin = end + (text.substr (end).starts_with ("\r\n") ? 2 : 1);
    }

    return lines;
}

/** How many characters mark a comment. */
std::size_t commentMark (std::string_view line)
{
    const auto content = stripped (line);
    return content.starts_with ("//") ? 2 : content.find_first_of ("#%!") == 0 ? 1 : 0;
}

/** What separates cells, as a line of numbers shows. A comma that digits follow is the decimal sign where blanks separate. */
char separatorOf (std::string_view line)
{
    const auto content = stripped (line);

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

Cells cellsOf (std::string_view line, char separator)
{
    Cells cells;
    auto isQuoted = false;
    std::size_t begin = 0;
    const auto content = separator == ' ' ? stripped (line) : line;

    for (std::size_t i = 0; i <= content.size(); ++i)
    {
        const auto isEnd = i == content.size();
        isQuoted = isQuoted != (! isEnd && content[i] == '"');
        const auto separates =
            isEnd || (! isQuoted && (content[i] == separator || (separator == ' ' && content[i] == '\t')));

        if (! separates)
            continue;

        if (const auto cell = stripped (content.substr (begin, i - begin)); separator != ' ' || ! cell.empty())
            cells.push_back (cell);

        begin = i + 1;
    }

    return cells;
}

/** The number of a cell; NaN where it is empty or says so; nothing if it is something else. */
std::optional<double> numberOf (std::string_view cell, char separator)
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

bool isNumeric (const Cells& cells, char separator)
{
    const auto first = cells.empty() ? std::nullopt : numberOf (cells.front(), separator);
    return first && std::isfinite (*first);
}

void addHeadings (const Cells& cells, std::vector<std::string>& headings)
{
    headings.resize (cells.size());

    for (std::size_t c = 0; c < cells.size(); ++c)
        headings[c] += (headings[c].empty() ? "" : " ") + trimmedText (cells[c]);
}

Eigen::MatrixXd numbersOf (const std::vector<Line>& lines, std::size_t first, char separator, const std::string& source)
{
    const auto columns = cellsOf (lines[first].text, separator).size();
    std::vector<double> numbers;

    for (auto i = first; i < lines.size(); ++i)
    {
        const auto where = source + ": line " + std::to_string (lines[i].number);

        if (commentMark (lines[i].text) > 0)
            continue;

        const auto cells = cellsOf (lines[i].text, separator);

        if (cells.size() != columns)
            throw InputError (where, "has " + std::to_string (cells.size()) + " cells; allowed: "
                                         + std::to_string (columns) + " as in the first line of numbers");

        for (const auto cell : cells)
        {
            const auto number = numberOf (cell, separator);

            if (! number)
                throw InputError (where, "has " + inQuotes (cell) + "; allowed: numbers");

            numbers.push_back (*number);
        }
    }

    return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> (
        numbers.data(), static_cast<Eigen::Index> (numbers.size() / columns), static_cast<Eigen::Index> (columns));
}
} // namespace

CsvTable readCsvTable (std::string_view text, const std::string& source)
{
    constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
    text.remove_prefix (text.starts_with (byteOrderMark) ? byteOrderMark.size() : 0);

    if (text.find ('\0') != std::string_view::npos)
        throw InputError (source, "is not a text table");

    const auto lines = linesOf (text);
    const auto separator = lines.empty() ? ',' : separatorOf (lines.back().text);
    const auto isRow = [&] (const Line& line)
    { return commentMark (line.text) == 0 && isNumeric (cellsOf (line.text, separator), separator); };
    const auto first = static_cast<std::size_t> (std::find_if (lines.begin(), lines.end(), isRow) - lines.begin());

    if (first == lines.size())
        throw InputError (source, "has no line of numbers");

    const auto columns = cellsOf (lines[first].text, separator).size();
    CsvTable table;

    for (std::size_t i = 0; i < first; ++i)
    {
        const auto mark = commentMark (lines[i].text);
        const auto cells = cellsOf (lines[i].text, separator);

        if (mark == 0 && cells.size() == columns)
            addHeadings (cells, table.headings);
        else
            table.comments.push_back (trimmedText (stripped (lines[i].text).substr (mark)));
    }

    table.numbers = numbersOf (lines, first, separator, source);
    return table;
}
} // namespace antinode
