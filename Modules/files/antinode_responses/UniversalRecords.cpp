#include "UniversalRecords.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::size_t longestNumber = 60;
constexpr std::string_view blanks = " \t\r\f\v";

bool isDigit (char character)
{
    return character >= '0' && character <= '9';
}

bool isSign (char character)
{
    return character == '+' || character == '-';
}

bool isExponentLetter (char character)
{
    return character == 'e' || character == 'E' || character == 'd' || character == 'D';
}

std::string_view trimmed (std::string_view text)
{
    const auto begin = text.find_first_not_of (blanks);
    return begin == std::string_view::npos ? std::string_view {}
                                           : text.substr (begin, text.find_last_not_of (blanks) - begin + 1);
}

/** The number of leading characters that form one number, judged without columns. */
std::size_t numberLength (std::string_view text)
{
    constexpr std::size_t exponentDigits = 3;
    std::size_t at = ! text.empty() && isSign (text[0]) ? 1 : 0;
    const auto skipDigits = [&] (std::size_t maximum)
    {
        const auto begin = at;

        while (at < text.size() && isDigit (text[at]) && at - begin < maximum)
            ++at;

        return at - begin;
    };
    auto digits = skipDigits (longestNumber);

    if (at < text.size() && text[at] == '.')
    {
        ++at;
        digits += skipDigits (longestNumber);
    }

    if (digits == 0)
        return 0;

    const auto mantissa = at;
    const auto hasLetter = at < text.size() && isExponentLetter (text[at]);
    at += hasLetter ? 1 : 0;
    const auto hasSign = at < text.size() && isSign (text[at]);
    at += hasSign ? 1 : 0;
    const auto shown = hasLetter ? skipDigits (exponentDigits) : hasSign ? skipDigits (exponentDigits) : 0;

    // "1.5-105" has an exponent of three digits without its letter; "1-2" are two integers.
    if (shown == 0 || (! hasLetter && shown < exponentDigits))
        return mantissa;

    return at < text.size() && text[at] == '.' ? at - 1 : at; // The digit before a point belongs to the next number.
}

/** The value of a field that is one number. */
std::optional<double> parseField (std::string_view field)
{
    std::array<char, longestNumber + 2> buffer {};
    std::size_t length = 0;
    bool hasExponent = false;

    if (field.empty() || field.size() > longestNumber || numberLength (field) != field.size())
        return std::nullopt;

    for (std::size_t i = field[0] == '+' ? 1 : 0; i < field.size(); ++i)
    {
        if (! hasExponent && i > 0 && (isExponentLetter (field[i]) || isSign (field[i])))
        {
            hasExponent = true;
            buffer[length++] = 'e';

            if (isExponentLetter (field[i]))
                continue;
        }

        if (! (hasExponent && field[i] == '+'))
            buffer[length++] = field[i];
    }

    double value = 0;
    const auto read = std::from_chars (buffer.data(), buffer.data() + length, value);

    if (read.ec == std::errc::result_out_of_range)
        return std::string_view (buffer.data(), length).find ("e-") != std::string_view::npos ? std::optional (0.0)
                                                                                              : std::nullopt;

    return read.ec == std::errc {} && read.ptr == buffer.data() + length ? std::optional (value) : std::nullopt;
}

/** Whether two columns may meet between these fields: not in the middle of a number. */
bool isBoundary (std::string_view left, std::string_view right)
{
    if (left.empty() || right.empty() || ! isDigit (right.front()) || ! isDigit (left.back()))
        return true;

    return left.size() > 4 && right.find ('.') == 1
           && isSign (left[left.size() - 3]); // Before it an exponent of two digits ends.
}

bool readColumns (std::string_view record, ColumnWidths widths, std::vector<double>& numbers)
{
    const auto end = std::min (record.find_last_not_of (blanks), record.size() - 1) + 1;
    const auto* width = widths.begin();

    for (std::size_t at = 0; at < end; at += *width, width = width + 1 == widths.end() ? widths.begin() : width + 1)
    {
        const auto field = record.substr (at, std::min (*width, end - at));
        const auto value = parseField (trimmed (field));

        if (! value || ! isBoundary (record.substr (0, at), field))
            return false;

        numbers.push_back (*value);
    }

    return true;
}

bool readFreely (std::string_view record, std::vector<double>& numbers)
{
    for (auto rest = trimmed (record); ! rest.empty();)
    {
        const auto length = numberLength (rest);
        const auto value = parseField (rest.substr (0, length));

        if (! value)
            return false;

        numbers.push_back (*value);
        rest = trimmed (rest.substr (length));
        rest.remove_prefix (! rest.empty() && rest.front() == ',' ? 1 : 0);
        rest = trimmed (rest);
    }

    return true;
}
} // namespace

bool appendRecordNumbers (std::string_view record, ColumnWidths widths, std::vector<double>& numbers)
{
    if (record.find_first_not_of (blanks) == std::string_view::npos)
        return true;

    const auto before = numbers.size();

    if (readColumns (record, widths, numbers))
        return true;

    numbers.resize (before);
    return readFreely (record, numbers);
}

UniversalRecords::UniversalRecords (std::string_view recordText, std::string sourceName, std::size_t firstLine)
    : text (recordText), source (std::move (sourceName)), line (firstLine - 1)
{
}

bool UniversalRecords::atEnd() const
{
    return text.find_first_not_of (" \t\r\n", position) == std::string_view::npos;
}

std::string_view UniversalRecords::record()
{
    if (position >= text.size())
        fail ("the set ends too early: a record is missing");

    const auto end = std::min (text.find ('\n', position), text.size());
    auto found = text.substr (position, end - position);
    position = end + 1;
    ++line;

    if (found.ends_with ('\r'))
        found.remove_suffix (1);

    return found;
}

std::string UniversalRecords::textRecord()
{
    return trimmedText (record());
}

void UniversalRecords::appendNumbers (ColumnWidths widths, std::vector<double>& numbers)
{
    const auto found = record();

    if (! appendRecordNumbers (found, widths, numbers))
        fail ("has " + inQuotes (found) + "; allowed here: numbers");
}

std::vector<double> UniversalRecords::numbers (ColumnWidths widths)
{
    std::vector<double> found;
    appendNumbers (widths, found);
    return found;
}

std::int64_t UniversalRecords::whole (double number) const
{
    constexpr double largest = 999999999;

    if (! (std::abs (number) <= largest && number == std::floor (number)))
        fail ("has " + numberText (number) + "; allowed here: whole numbers of at most nine digits");

    return static_cast<std::int64_t> (number);
}

std::vector<std::int64_t> UniversalRecords::integers (std::size_t fewest, std::size_t count, std::size_t width)
{
    const auto found = numbers ({ width });
    std::vector<std::int64_t> integers (count);

    if (found.size() < fewest)
        fail ("has " + std::to_string (found.size()) + " numbers; allowed here: at least " + std::to_string (fewest));

    std::transform (found.begin(), found.begin() + static_cast<std::ptrdiff_t> (std::min (count, found.size())),
                    integers.begin(), [&] (double number) { return whole (number); });
    return integers;
}

void UniversalRecords::fail (const std::string& wrong) const
{
    throw InputError (source + ": line " + std::to_string (line), wrong);
}

namespace
{
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> spellings { {
    { "\xc2\xb9", "^1" },
    { "\xc2\xb2", "^2" },
    { "\xc2\xb3", "^3" },
    { "\xe2\x81\xbb", "^-" },
    { "\xe2\x88\x92", "-" },
    { "\xe2\x80\x99", "'" },
    { "\xe2\x8b\x85", "*" },
    { "\xe2\x88\x99", "*" },
    { "\xc3\x97", "*" },
    { "\xc2\xa0", " " },
    { "\xc2\xba", "deg" },
    { "\xc2\xb5", "u" },
    { "\xce\xbc", "u" },
    { "\xc2\xb7", "*" },
    { "\xc2\xb0", "deg" },
} };

constexpr std::size_t realWidth = 13;
constexpr int realDigits = 5;
constexpr double smallestReal = 1e-99; // An exponent of three digits leaves no space between two columns.

double parsed (const std::string& field)
{
    double value = 0;
    std::from_chars (field.data(), field.data() + field.size(), value);
    return value;
}

/** At most so many characters, with as many digits as they hold: any form with a point may stand in a column of E13.5.
 */
std::string closest (double number, std::size_t characters)
{
    constexpr double fixedFrom = 1e-3, fixedTo = 1e9;
    constexpr int mostDigits = 11;
    const auto isFixed = std::abs (number) >= fixedFrom && std::abs (number) < fixedTo;
    const auto fewestDigits = isFixed ? 1 : realDigits;
    std::array<char, 48> buffer {};

    if (! std::isfinite (number) || std::abs (number) < smallestReal)
        return {};

    for (auto digits = mostDigits; digits >= fewestDigits; --digits)
    {
        const auto written = std::to_chars (buffer.data(), buffer.data() + buffer.size(), number,
                                            isFixed ? std::chars_format::fixed : std::chars_format::scientific, digits);
        std::string field (buffer.data(), written.ptr);

        if (const auto exponent = field.find ("e-0"); exponent != std::string::npos)
            field.erase (exponent + 2, 1);
        else if (const auto positive = field.find ("e+"); positive != std::string::npos)
            field.erase (positive + 1, field[positive + 2] == '0' ? 2 : 1);

        if (field.size() <= characters)
            return field;
    }

    return {};
}
} // namespace

void appendRight (std::string& text, std::string_view field, std::size_t width)
{
    text.append (width - std::min (width, field.size()), ' ');
    text += field;
}

void appendInteger (std::string& text, std::int64_t number, std::size_t width)
{
    appendRight (text, std::to_string (number), width);
}

void appendReal (std::string& text, double number)
{
    const auto longer = closest (number, realWidth - 1);
    std::string standard;
    appendReal (standard, longer.empty() ? number : parsed (longer), realWidth, realDigits, 'E');
    const auto isExact =
        longer.empty() || parsed (standard.substr (standard.find_first_not_of (' '))) == parsed (longer);

    if (isExact)
        text += standard;
    else
    {
        auto field = longer;
        std::replace (field.begin(), field.end(), 'e', 'E');
        appendRight (text, field, realWidth);
    }
}

void appendReal (std::string& text, double number, std::size_t width, int digits, char letter)
{
    std::array<char, 48> buffer {};

    if (! std::isfinite (number))
        throw InputError ("universal file", "has a value that is not finite");

    const auto written =
        std::to_chars (buffer.data(), buffer.data() + buffer.size(), std::abs (number) < smallestReal ? 0.0 : number,
                       std::chars_format::scientific, digits);
    std::string field (buffer.data(), written.ptr);
    std::replace (field.begin(), field.end(), 'e', letter);
    appendRight (text, field, width);
}

std::string integerRecord (const std::vector<std::int64_t>& numbers)
{
    std::string text;

    for (const auto number : numbers)
        appendInteger (text, number);

    return text + '\n';
}

std::string realRecord (const std::vector<double>& numbers)
{
    std::string text;

    for (const auto number : numbers)
        appendReal (text, number);

    return text + '\n';
}

std::string plainText (std::string_view text, std::size_t length)
{
    std::string plain;

    while (! text.empty())
    {
        const auto spelling = std::find_if (spellings.begin(), spellings.end(),
                                            [&] (const auto& pair) { return text.starts_with (pair.first); });

        if (spelling != spellings.end())
        {
            plain += spelling->second;
            text.remove_prefix (spelling->first.size());
            continue;
        }

        const auto byte = static_cast<unsigned char> (text.front());
        const auto isContinuation = byte >= 0x80 && byte < 0xc0;
        text.remove_prefix (1);

        if (! isContinuation)
            plain += byte >= ' ' && byte < 0x7f ? static_cast<char> (byte) : '?';
    }

    if (plain.size() > length) // What blanks are left at its end would not be read again.
        plain.resize (plain.find_last_not_of (' ', length - 1) + 1);

    return plain;
}

std::string textRecord (std::string_view text)
{
    const auto plain = plainText (text);
    return (plain == "    -1" ? "-1" : plain) + '\n'; // In these columns it would close the set.
}
} // namespace antinode
