#include "UniversalFile.h"

#include "UniversalFunctionSet.h"
#include "UniversalModelSets.h"
#include "UniversalRecords.h"
#include "UniversalResultSets.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>

namespace antinode
{
namespace
{
constexpr std::string_view delimiter = "    -1\n";

/** The line of a set's number and its records. */
struct SetText
{
    std::string operator() (const UniversalFunction& set) const { return encodeFunctionSet (set); }
    std::string operator() (const UniversalShape& set) const { return numbered (55, encodeShapeSet (set)); }
    std::string operator() (const UniversalTrace& set) const { return numbered (82, encodeTraceSet (set)); }
    std::string operator() (const UniversalHeader& set) const { return numbered (151, encodeHeaderSet (set)); }
    std::string operator() (const UniversalUnits& set) const { return numbered (164, encodeUnitSet (set)); }
    std::string operator() (const UniversalElements& set) const { return numbered (2412, encodeElementSet (set)); }
    std::string operator() (const UniversalResults& set) const { return numbered (2414, encodeResultSet (set)); }
    std::string operator() (const UnknownUniversalSet& set) const { return numbered (set.number, set.records); }

    std::string operator() (const UniversalNodes& set) const
    {
        return numbered (set.isDouble ? 2411 : 15, encodeNodeSet (set));
    }

    static std::string numbered (int number, const std::string& records)
    {
        std::string text;
        appendInteger (text, number, 6);
        return text + '\n' + records;
    }
};

UniversalSet readSet (const UniversalSection& section, const std::string& source)
{
    UniversalRecords records (section.records, source, section.firstLine);

    switch (section.number)
    {
        case 15:
            return readNodeSet (records, false);
        case 55:
            return readShapeSet (records);
        case 58:
            return readFunctionSet (section, source);
        case 82:
            return readTraceSet (records);
        case 151:
            return readHeaderSet (records);
        case 164:
            return readUnitSet (records);
        case 2411:
            return readNodeSet (records, true);
        case 2412:
            return readElementSet (records);
        case 2414:
            return readResultSet (records);
        default:
            return UnknownUniversalSet { section.number, std::string (section.records) };
    }
}
} // namespace

std::vector<UniversalSet> readUniversalFile (std::string_view bytes, const std::string& source)
{
    std::vector<UniversalSet> sets;

    for (const auto& section : universalSections (bytes, source))
        sets.push_back (readSet (section, source));

    return sets;
}

std::string encodeUniversalFile (const std::vector<UniversalSet>& sets)
{
    std::string file;

    for (const auto& set : sets)
    {
        file += delimiter;
        file += std::visit (SetText {}, set);
        file += delimiter;
    }

    return file;
}

namespace
{
constexpr std::size_t functionLines = 11; ///< Text of a 58b.

/** A file that is read line by line, or by bytes. */
struct Cursor
{
    std::string_view file;
    std::size_t position = 0, line = 0; ///< The line that was read last, from 1.

    bool atEnd() const { return position >= file.size(); }

    std::string_view next()
    {
        const auto end = std::min (file.find ('\n', position), file.size());
        const auto found = file.substr (position, end - position);
        position = std::min (end + 1, file.size());
        ++line;
        return found;
    }
};

/** Whether a line is the -1 between sets: alone, in columns 5 and 6. Numbers of a set may be -1 elsewhere. */
bool isDelimiter (std::string_view line)
{
    constexpr std::string_view mark = "    -1";
    return line.starts_with (mark) && line.find_first_not_of (" \t\r\f", mark.size()) == std::string_view::npos;
}

/** Where the -1 behind binary data begins, when it is at this place or behind the line's end there. */
std::optional<std::size_t> closingAt (std::string_view file, std::size_t place)
{
    if (place > file.size())
        return std::nullopt;

    for (const std::string_view lineEnd : { "", "\n", "\r\n", "\r" })
        if (file.substr (place).starts_with (lineEnd))
        {
            const auto begin = place + lineEnd.size();
            const auto line = file.substr (begin, file.find ('\n', begin) - begin);

            if (isDelimiter (line))
                return begin;
        }

    return std::nullopt;
}

/** What the header of a 58b says of its data. */
struct BinaryHeader
{
    bool isBigEndian = false;
    std::size_t bytes = 0;
};

BinaryHeader binaryHeader (std::string_view line, const Cursor& at, const std::string& source)
{
    constexpr double littleEndian = 1, bigEndian = 2, ieee = 2;
    std::vector<double> numbers;
    const auto where = source + ": line " + std::to_string (at.line);

    if (! appendRecordNumbers (line, { 6, 6, 12, 12, 6, 6, 12, 12 }, numbers) || numbers.size() < 2)
        throw InputError (where,
                          "the header of binary data cannot be read; allowed: byte order, number format and counts");

    if (numbers[0] != littleEndian && numbers[0] != bigEndian)
        throw InputError (where, "has the byte order " + numberText (numbers[0])
                                     + "; allowed: 1 (little endian) or 2 (big endian)");

    if (numbers[1] != ieee)
        throw InputError (where, "has the number format " + numberText (numbers[1]) + "; allowed: 2 (IEEE 754)");

    const auto isCount = numbers.size() > 3 && numbers[3] >= 0 && numbers[3] <= static_cast<double> (at.file.size());
    return { numbers[0] == bigEndian, isCount ? static_cast<std::size_t> (numbers[3]) : 0 };
}

/** How many bytes the record of a 58b that tells type, count and spacing stands for; a second guess where an uneven
   abscissa may have single precision with double values. */
std::array<std::size_t, 2> bytesOfCount (std::string_view record, std::size_t largest)
{
    std::vector<double> numbers;
    appendRecordNumbers (record, { 10, 10, 10, 13, 13, 13 }, numbers);

    if (numbers.size() < 3 || ! (numbers[1] >= 0 && numbers[1] <= static_cast<double> (largest)))
        return { 0, 0 };

    const auto isComplex = numbers[0] >= 5, isDouble = numbers[0] == 4 || numbers[0] == 6, isUneven = numbers[2] == 0;
    const std::size_t number = isDouble ? 8 : 4, values = (isComplex ? 2 : 1) * number;
    const auto count = static_cast<std::size_t> (numbers[1]);
    return { count * (values + (isUneven ? number : 0)), count * (values + (isUneven ? 4 : 0)) };
}

std::size_t endOfBinary (const Cursor& at, std::string_view countRecord, std::size_t headerBytes)
{
    const auto left = at.file.size() - at.position;
    const auto counted = bytesOfCount (countRecord, left);

    for (const auto bytes : { counted[0], counted[1], headerBytes })
        if (bytes <= left && bytes > 0)
            if (const auto closing = closingAt (at.file, at.position + bytes))
                return *closing;

    for (auto place = at.file.find ("    -1", at.position); place != std::string_view::npos;
         place = at.file.find ("    -1", place + 1))
        if (const auto closing = closingAt (at.file, place))
            return *closing;

    return std::string_view::npos;
}

[[noreturn]] void failUnclosed (const UniversalSection& section, const std::string& source)
{
    throw InputError (source + ": line " + std::to_string (section.firstLine - 1),
                      "data set " + std::to_string (section.number)
                          + " is not closed by a line of -1: the file ends too early");
}

void readBinary (UniversalSection& section, std::string_view header, Cursor& at, const std::string& source)
{
    const auto said = binaryHeader (header, at, source);
    const auto begin = at.position;
    std::string_view countRecord;

    for (std::size_t line = 0; line < functionLines; ++line)
    {
        constexpr std::size_t countLine = 6;
        const auto found = at.next();
        countRecord = line == countLine ? found : countRecord;
    }

    section.records = at.file.substr (begin, at.position - begin);
    section.isBigEndian = said.isBigEndian;
    const auto end = endOfBinary (at, countRecord, said.bytes);

    if (end == std::string_view::npos)
        failUnclosed (section, source);

    section.data = at.file.substr (at.position, end - at.position);
    at.position = end;
    at.next();
}

void readText (UniversalSection& section, Cursor& at, const std::string& source)
{
    const auto begin = at.position;

    while (! at.atEnd())
    {
        const auto end = at.position;

        if (isDelimiter (at.next()))
        {
            section.records = at.file.substr (begin, end - begin);
            return;
        }
    }

    failUnclosed (section, source);
}

/** The line behind a -1: the set's number, with a b where its data are binary. */
UniversalSection readSection (std::string_view head, Cursor& at, const std::string& source)
{
    constexpr double largestNumber = 999999;
    constexpr std::size_t numberWidth = 6;
    UniversalSection section;
    std::vector<double> numbers;
    const auto letter = head.find_first_of ("bB");
    const auto width = std::min (letter, numberWidth);

    if (! appendRecordNumbers (head.substr (0, width), { numberWidth }, numbers) || numbers.size() != 1
        || ! (numbers[0] >= 0 && numbers[0] <= largestNumber))
        throw InputError (source + ": line " + std::to_string (at.line),
                          "has " + inQuotes (head) + " after a line of -1; allowed: the number of a data set");

    section.number = static_cast<int> (numbers[0]);
    section.firstLine = at.line + 1;

    if (section.number == 58 && letter <= numberWidth)
        readBinary (section, head.substr (letter + 1), at, source);
    else
        readText (section, at, source);

    return section;
}
} // namespace

std::vector<UniversalSection> universalSections (std::string_view file, const std::string& source)
{
    std::vector<UniversalSection> sections;
    Cursor at { file };

    while (! at.atEnd())
    {
        if (! isDelimiter (at.next()))
            continue;

        auto head = at.next();

        while (! at.atEnd() && isDelimiter (head)) // One -1 too many.
            head = at.next();

        if (head.find_first_not_of (" \t\r") != std::string_view::npos && ! isDelimiter (head))
            sections.push_back (readSection (head, at, source));
    }

    if (sections.empty())
        throw InputError (source, "is not a universal file: it has no data set between lines of -1");

    return sections;
}
} // namespace antinode
