#include "CsvText.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace antinode
{
std::string csvField (const std::string& text)
{
    if (text.find_first_of (",\"\r\n") == std::string::npos)
        return text;

    std::string quotedText = "\"";

    for (const auto character : text)
        quotedText += character == '"' ? std::string ("\"\"") : std::string (1, character);

    return quotedText + '"';
}

void appendCsvNumber (std::string& text, double value, int significantDigits)
{
    std::array<char, 32> buffer {};

    if (! std::isfinite (value))
        throw InputError ("CSV", "has a value that is not finite");

    const auto written = std::to_chars (buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general,
                                        significantDigits);
    text.append (buffer.data(), written.ptr);
}

namespace
{
/** The number of a text with a point. */
std::optional<double> plainNumber (std::string_view text)
{
    double value = 0;
    text.remove_prefix (text.starts_with ('+') ? 1 : 0);
    const auto read = std::from_chars (text.data(), text.data() + text.size(), value);
    return read.ec == std::errc {} && read.ptr == text.data() + text.size() ? std::optional (value) : std::nullopt;
}

std::string lowerCase (std::string_view text)
{
    std::string lower (text);
    std::transform (lower.begin(), lower.end(), lower.begin(),
                    [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });
    return lower;
}

/** Seconds of "12:34:56.789", "2026-11-28T12:34:56", "12:34:56 PM" or "34:56.7". */
std::optional<double> clockSeconds (std::string_view cell)
{
    constexpr double base = 60, halfDay = 43200;
    auto text = lowerCase (cell);
    const auto isAfternoon = text.ends_with ("pm"), isTwelveHours = isAfternoon || text.ends_with ("am");
    text = text.substr (0, text.size() - (isTwelveHours ? 2 : text.ends_with ("z") ? 1 : 0));

    if (const auto date = text.find_first_of (" t"); date != std::string::npos && isCsvDate (text.substr (0, date)))
        text.erase (0, date + 1);

    std::string_view rest = csvStripped (text);
    double seconds = 0;
    int parts = 0;

    for (; ! rest.empty(); ++parts)
    {
        const auto colon = std::min (rest.find (':'), rest.size());
        const auto part = plainNumber (rest.substr (0, colon));

        if (! part || ! (*part >= 0) || parts == 3)
            return std::nullopt;

        seconds = base * seconds + *part;
        rest.remove_prefix (std::min (rest.size(), colon + 1));
    }

    const auto isTwelve = isTwelveHours && seconds >= halfDay;
    return parts < 2 ? std::nullopt : std::optional (seconds + (isAfternoon ? halfDay : 0) - (isTwelve ? halfDay : 0));
}

/** What programs write where there is no number. */
bool saysNoNumber (std::string_view cell)
{
    constexpr std::array<std::string_view, 12> words { "",   "na",     "n/a",     "null",    "none",    "-",
                                                       "--", "1.#inf", "-1.#inf", "-1.#ind", "#div/0!", "#n/a" };
    return std::find (words.begin(), words.end(), lowerCase (cell)) != words.end();
}

void appendUtf8 (std::string& text, unsigned code)
{
    const auto append = [&text] (unsigned byte) { text += static_cast<char> (byte); };

    if (code < 0x80)
        return append (code);

    if (code < 0x800)
        append (0xc0 | code >> 6);
    else
    {
        append (0xe0 | code >> 12);
        append (0x80 | (code >> 6 & 0x3f));
    }

    append (0x80 | (code & 0x3f));
}
} // namespace

std::string csvText (std::string_view bytes)
{
    const auto isBig = bytes.starts_with ("\xfe\xff");

    if (! isBig && ! bytes.starts_with ("\xff\xfe"))
        return std::string (bytes);

    std::string text;

    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2)
    {
        const unsigned first = static_cast<unsigned char> (bytes[i]),
                       second = static_cast<unsigned char> (bytes[i + 1]);
        appendUtf8 (text, isBig ? first << 8 | second : second << 8 | first);
    }

    return text;
}

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
    const auto areBalanced =
        separator == ','
        && std::count (content.begin(), content.end(), '(') == std::count (content.begin(), content.end(), ')');
    auto depth = 0;

    for (std::size_t i = 0; i <= content.size(); ++i)
    {
        const auto isEnd = i == content.size();
        isQuoted = isQuoted != (! isEnd && content[i] == '"');
        depth += isEnd || ! areBalanced ? 0 : content[i] == '(' ? 1 : content[i] == ')' ? -1 : 0;
        const auto separates =
            isEnd
            || (! isQuoted && depth <= 0 && (content[i] == separator || (separator == ' ' && content[i] == '\t')));

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
    const auto nan = std::numeric_limits<double>::quiet_NaN();

    if (cell.size() > longest)
        return std::nullopt;

    std::array<char, longest> buffer {};
    std::transform (cell.begin(), cell.end(), buffer.begin(),
                    [&] (char character) { return character == ',' && separator != ',' ? '.' : character; });
    const std::string_view text (buffer.data(), cell.size());
    auto value = plainNumber (text);

    if (! value && text.find (':') != std::string_view::npos)
        value = clockSeconds (text);

    if (! value && saysNoNumber (cell))
        return nan;

    return ! value || std::isfinite (*value) ? value : std::optional (nan);
}

std::optional<std::complex<double>> csvComplex (std::string_view cell, char separator)
{
    constexpr std::size_t longest = 120;
    constexpr std::string_view units = "ij";
    auto text = lowerCase (cell.substr (0, longest));
    std::erase_if (text, [] (char c) { return c == ' ' || c == '*'; });

    if (text.starts_with ('(') && text.ends_with (')'))
    {
        text = text.substr (1, text.size() - 2);

        if (const auto comma = text.find (','); comma != std::string::npos && text.find_first_of (units) == text.npos)
            text = text.substr (0, comma) + (text.find_first_of ("+-", comma) == comma + 1 ? "" : "+")
                   + text.substr (comma + 1) + "i";
    }

    // The sign between the two parts: the last one that belongs to no exponent.
    auto sign = text.size();

    while (sign > 0 && ! ((text[sign - 1] == '+' || text[sign - 1] == '-') && (sign == 1 || text[sign - 2] != 'e')))
        --sign;

    const auto begin = sign > 0 ? sign - 1 : 0;
    auto part = text.substr (begin);
    const auto hasUnit = [&part, units] (std::size_t at)
    { return at < part.size() && units.find (part[at]) != std::string_view::npos && part.find ("inf") != at; };
    const std::size_t first = sign > 0 ? 1 : 0;

    if (part.empty() || (! hasUnit (part.size() - 1) && ! hasUnit (first)))
        return std::nullopt;

    part.erase (hasUnit (part.size() - 1) ? part.size() - 1 : first, 1);
    const auto imaginary =
        part.size() == first ? std::optional (part == "-" ? -1.0 : 1.0) : csvNumber (part, separator);
    const auto real = begin == 0 ? std::optional (0.0) : csvNumber (text.substr (0, begin), separator);
    return real && imaginary ? std::optional (std::complex<double> (*real, *imaginary)) : std::nullopt;
}

bool isCsvDate (std::string_view cell)
{
    constexpr std::size_t shortest = 6, longest = 10;
    const auto marks =
        std::count_if (cell.begin(), cell.end(), [] (char c) { return c == '-' || c == '.' || c == '/'; });
    const auto isPart = [] (char c) { return (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '/'; };
    return cell.size() >= shortest && cell.size() <= longest && marks == 2 && cell.find_first_of ("-./") != 0
           && std::all_of (cell.begin(), cell.end(), isPart);
}
} // namespace antinode
