#include "UniversalNumbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

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
} // namespace antinode
