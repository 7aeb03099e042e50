#include "UniversalRecords.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
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
} // namespace antinode
