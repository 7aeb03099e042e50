#include "UniversalFunctionSet.h"

#include "UniversalRecords.h"

#include <antinode_base/MessageText.h>

#include <bit>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
/** The part of a record in these columns. */
std::string_view columns (std::string_view record, std::size_t first, std::size_t width)
{
    return first < record.size() ? record.substr (first, width) : std::string_view {};
}

/** A whole number in a column that leaves a blank before it; 0 where it is blank or something else, as for unused
    fields. */
UniversalLabel integerIn (std::string_view record, std::size_t first, std::size_t width)
{
    std::vector<double> numbers;
    const auto isNumber =
        appendRecordNumbers (columns (record, first, width), { width }, numbers) && numbers.size() == 1;
    const auto isShort = isNumber && std::abs (numbers[0]) < std::pow (10.0, static_cast<double> (width) - 1);
    return isShort ? static_cast<UniversalLabel> (numbers[0]) : 0;
}

int smallIntegerIn (std::string_view record, std::size_t first, std::size_t width)
{
    return static_cast<int> (integerIn (record, first, width));
}

UniversalPlace placeIn (std::string_view record, std::size_t first)
{
    return { trimmedText (columns (record, first, 11)), integerIn (record, first + 11, 10),
             smallIntegerIn (record, first + 21, 4) };
}

void readPlaces (UniversalFunction& function, std::string_view record)
{
    function.functionType = smallIntegerIn (record, 0, 5);
    function.identification = integerIn (record, 5, 10);
    function.version = integerIn (record, 15, 5);
    function.loadCase = integerIn (record, 20, 10);
    function.response = placeIn (record, 30);
    function.reference = placeIn (record, 55);
}

void readForm (UniversalFunction& function, UniversalRecords& records)
{
    const auto numbers = records.numbers ({ 10, 10, 10, 13, 13, 13 });

    if (numbers.size() < 3)
        records.fail ("has " + std::to_string (numbers.size())
                      + " numbers in the record of the data form; allowed: at least type, count and spacing");

    if (numbers[0] != 2 && numbers[0] != 4 && numbers[0] != 5 && numbers[0] != 6)
        records.fail ("has data of type " + numberText (numbers[0]) + "; allowed: 2, 4 (real), 5 or 6 (complex)");

    if (! (numbers[1] >= 0 && numbers[1] <= 1e15 && numbers[1] == std::floor (numbers[1])))
        records.fail ("has " + numberText (numbers[1]) + " values; allowed: a whole number");

    if (numbers[2] != 0 && numbers[2] != 1)
        records.fail ("has the spacing " + numberText (numbers[2]) + "; allowed: 0 (uneven) or 1 (even)");

    function.ordinateType = static_cast<int> (numbers[0]);
    function.statedCount = static_cast<UniversalLabel> (numbers[1]);
    function.isEven = numbers[2] == 1;
    function.first = numbers.size() > 3 ? numbers[3] : 0;
    function.step = numbers.size() > 4 ? numbers[4] : 0;
    function.z = numbers.size() > 5 ? numbers[5] : 0;
}

UniversalAxis axisIn (std::string_view record)
{
    constexpr std::size_t labels = 25, labelWidth = 21;
    UniversalAxis axis;
    axis.quantity = smallIntegerIn (record, 0, 10);

    for (std::size_t i = 0; i < axis.exponents.size(); ++i)
        axis.exponents[i] = smallIntegerIn (record, 10 + 5 * i, 5);

    axis.label = trimmedText (columns (record, labels, labelWidth));
    axis.unit = trimmedText (columns (record, labels + labelWidth, record.size())); // Some are longer than their field.
    return axis;
}

/** Numbers of binary data, all of one precision; those of an uneven abscissa may have single precision with double
    values. */
std::vector<double> binaryNumbers (const UniversalSection& section, const UniversalFunction& function)
{
    const auto data = *section.data;
    const auto count = static_cast<std::size_t> (function.statedCount);
    const std::size_t values = function.isComplex() ? 2 : 1, period = values + (function.isEven ? 0 : 1);
    const auto hasSingleAbscissa = ! function.isEven && function.isDouble() && data.size() < 8 * period * count
                                   && data.size() / (8 * values + 4) >= count;
    const auto width = [&] (std::size_t i) -> std::size_t
    { return function.isDouble() && ! (hasSingleAbscissa && i % period == 0) ? 8 : 4; };
    std::vector<double> numbers;
    numbers.reserve (data.size() / 4);

    for (std::size_t at = 0; at + width (numbers.size()) <= data.size();)
    {
        const auto bytes = width (numbers.size());
        std::uint64_t bits = 0;

        for (std::size_t i = 0; i < bytes; ++i)
            bits |= static_cast<std::uint64_t> (static_cast<unsigned char> (data[at + i]))
                    << 8 * (section.isBigEndian ? bytes - 1 - i : i);

        numbers.push_back (bytes == 8 ? std::bit_cast<double> (bits)
                                      : static_cast<double> (std::bit_cast<float> (static_cast<std::uint32_t> (bits))));
        at += bytes;
    }

    return numbers;
}

std::vector<double> textNumbers (const UniversalFunction& function, UniversalRecords& records)
{
    std::vector<double> numbers;

    while (! records.atEnd())
        if (! function.isDouble())
            records.appendNumbers ({ 13 }, numbers);
        else if (function.isEven)
            records.appendNumbers ({ 20 }, numbers);
        else if (function.isComplex())
            records.appendNumbers ({ 13, 20, 20 }, numbers);
        else
            records.appendNumbers ({ 13, 20 }, numbers);

    return numbers;
}

/** Puts numbers where they belong: as many values as the header says, or as are there. */
void distribute (const std::vector<double>& numbers, UniversalFunction& function)
{
    const std::size_t parts = function.isComplex() ? 2 : 1, offset = function.isEven ? 0 : 1, period = parts + offset;
    const auto count = std::min (static_cast<std::size_t> (function.statedCount), numbers.size() / period);
    function.values.resize (static_cast<Eigen::Index> (count));
    function.abscissae.resize (static_cast<Eigen::Index> (function.isEven ? 0 : count));

    for (std::size_t i = 0; i < count; ++i)
    {
        const auto at = i * period;
        const auto index = static_cast<Eigen::Index> (i);
        function.values[index] = { numbers[at + offset], parts == 2 ? numbers[at + offset + 1] : 0.0 };

        if (! function.isEven)
            function.abscissae[index] = numbers[at];
    }
}
} // namespace

UniversalFunction readFunctionSet (const UniversalSection& section, const std::string& source)
{
    UniversalRecords records (section.records, source, section.firstLine);
    UniversalFunction function;

    if (section.data)
        function.encoding = section.isBigEndian ? UniversalEncoding::bigEndian : UniversalEncoding::littleEndian;

    for (auto& line : function.lines)
        line = records.textRecord();

    readPlaces (function, records.record());
    readForm (function, records);

    for (auto* const axis : { &function.abscissa, &function.ordinate, &function.denominator, &function.zAxis })
        *axis = axisIn (records.record());

    distribute (section.data ? binaryNumbers (section, function) : textNumbers (function, records), function);

    if (! function.values.allFinite() || ! function.abscissae.allFinite())
        records.fail ("has data that are not finite");

    return function;
}

namespace
{
void appendLeft (std::string& text, std::string_view field, std::size_t width)
{
    const auto plain = plainText (field, width);
    text += plain;
    text.append (width - plain.size(), ' ');
}

void appendPlace (std::string& text, const UniversalPlace& place)
{
    text += ' ';
    appendLeft (text, place.entity, 10);
    appendInteger (text, place.node);
    appendInteger (text, place.direction, 4);
}

std::string axisRecord (const UniversalAxis& axis)
{
    std::string text;
    appendInteger (text, axis.quantity);

    for (const auto exponent : axis.exponents)
        appendInteger (text, exponent, 5);

    text += ' ';
    appendLeft (text, axis.label, 20);
    text += ' ';
    appendLeft (text, axis.unit, 20);
    return text + '\n';
}

std::string headRecords (const UniversalFunction& function)
{
    std::string text;

    for (const auto& line : function.lines)
        text += textRecord (line);

    appendInteger (text, function.functionType, 5);
    appendInteger (text, function.identification);
    appendInteger (text, function.version, 5);
    appendInteger (text, function.loadCase);
    appendPlace (text, function.response);
    appendPlace (text, function.reference);
    text += '\n';
    appendInteger (text, function.ordinateType);
    appendInteger (text, function.values.size());
    appendInteger (text, function.isEven ? 1 : 0);
    text += realRecord ({ function.first, function.step, function.z });

    for (const auto* const axis : { &function.abscissa, &function.ordinate, &function.denominator, &function.zAxis })
        text += axisRecord (*axis);

    return text;
}

/** Numbers in the order of the file: abscissa where it is uneven, real part, imaginary part where there is one. */
template <typename Append>
void forNumbers (const UniversalFunction& function, Append&& append)
{
    for (Eigen::Index i = 0; i < function.values.size(); ++i)
    {
        if (! function.isEven)
            append (function.abscissae[i], true);

        append (function.values[i].real(), false);

        if (function.isComplex())
            append (function.values[i].imag(), false);
    }
}

/** 6E13.5, 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12. */
std::string textData (const UniversalFunction& function)
{
    const std::size_t numbersALine = ! function.isDouble() ? 6 : ! function.isEven && function.isComplex() ? 3 : 4;
    std::string text;
    std::size_t count = 0;

    forNumbers (function,
                [&] (double number, bool isAbscissa)
                {
                    const auto isLong = function.isDouble() && ! isAbscissa;
                    appendReal (text, number, isLong ? 20 : 13, isLong ? 12 : 5, 'E');
                    text += ++count % numbersALine == 0 ? "\n" : "";
                });

    return count % numbersALine != 0 ? text + '\n' : text;
}

std::string binaryData (const UniversalFunction& function)
{
    const std::size_t bytes = function.isDouble() ? 8 : 4;
    std::string data;

    forNumbers (function,
                [&] (double number, bool)
                {
                    const auto bits = bytes == 8 ? std::bit_cast<std::uint64_t> (number)
                                                 : std::bit_cast<std::uint32_t> (static_cast<float> (number));

                    for (std::size_t i = 0; i < bytes; ++i)
                        data += static_cast<char> (
                            bits >> 8 * (function.encoding == UniversalEncoding::bigEndian ? bytes - 1 - i : i) & 0xff);
                });

    return data;
}
} // namespace

std::string encodeFunctionSet (const UniversalFunction& function)
{
    std::string text = "    58";

    if (function.encoding == UniversalEncoding::text)
        return text + '\n' + headRecords (function) + textData (function);

    constexpr int ieee = 2, textLines = 11;
    const auto data = binaryData (function);
    text += 'b';
    appendInteger (text, function.encoding == UniversalEncoding::bigEndian ? 2 : 1, 6);
    appendInteger (text, ieee, 6);
    appendInteger (text, textLines, 12);
    appendInteger (text, static_cast<std::int64_t> (data.size()), 12);
    appendInteger (text, 0, 6);
    appendInteger (text, 0, 6);
    appendInteger (text, 0, 12);
    appendInteger (text, 0, 12);
    return text + '\n' + headRecords (function) + data + '\n';
}
} // namespace antinode
