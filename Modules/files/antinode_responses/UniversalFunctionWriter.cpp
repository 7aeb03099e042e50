#include "UniversalFunctionSet.h"
#include "UniversalRecordText.h"

#include <bit>
#include <limits>

namespace antinode
{
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
