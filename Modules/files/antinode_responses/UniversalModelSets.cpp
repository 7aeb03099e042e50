#include "UniversalModelSets.h"

#include "UniversalRecords.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr std::size_t integersARecord = 8;

void appendIntegers (std::string& text, const std::vector<UniversalLabel>& numbers)
{
    appendRecords (text, numbers, integersARecord, [] (auto& to, auto number) { appendInteger (to, number); });
}

/** Node numbers, in as many records as they need. */
std::vector<UniversalLabel> readNodeList (UniversalRecords& records, std::size_t count)
{
    std::vector<double> numbers;

    if (count > records.bytesLeft()) // Each takes a byte at least.
        records.fail ("has " + std::to_string (count) + " nodes, more than the file contains");

    while (numbers.size() < count)
        records.appendNumbers ({ 10 }, numbers);

    std::vector<UniversalLabel> nodes (count);
    std::transform (numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t> (count), nodes.begin(),
                    [&] (double number) { return records.whole (number); });
    return nodes;
}

std::size_t toCount (UniversalRecords& records, UniversalLabel number)
{
    if (number < 0)
        records.fail ("has a count of " + std::to_string (number) + "; allowed: 0 or more");

    return static_cast<std::size_t> (number);
}

bool isBeam (UniversalLabel kind)
{
    return kind == 11 || (kind >= 21 && kind <= 24);
}
} // namespace

UniversalNodes readNodeSet (UniversalRecords& records, bool isDouble)
{
    UniversalNodes nodes;
    nodes.isDouble = isDouble;
    std::vector<double> numbers, places;

    while (! records.atEnd())
    {
        constexpr std::size_t integers = 4, coordinates = 3;
        numbers.clear();

        if (isDouble)
        {
            records.appendNumbers ({ 10 }, numbers);
            records.appendNumbers ({ 25 }, numbers);
        }
        else
            records.appendNumbers ({ 10, 10, 10, 10, 13, 13, 13 }, numbers);

        if (numbers.size() != integers + coordinates)
            records.fail ("has " + std::to_string (numbers.size())
                          + " numbers for a node; allowed: 7 (number, two systems, colour, three coordinates)");

        const auto whole = [&] (std::size_t i) { return records.whole (numbers[i]); };
        nodes.labels.push_back (whole (0));
        nodes.systems.push_back ({ whole (1), whole (2), whole (3) });
        places.insert (places.end(), numbers.begin() + integers, numbers.end());
    }

    nodes.places = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> (
        places.data(), static_cast<Eigen::Index> (nodes.labels.size()), 3);
    return nodes;
}

UniversalTrace readTraceSet (UniversalRecords& records)
{
    UniversalTrace trace;
    const auto head = records.integers (2, 3);
    trace.number = head[0];
    trace.colour = head[2];
    trace.text = records.textRecord();
    trace.nodes = readNodeList (records, toCount (records, head[1]));
    return trace;
}

UniversalElements readElementSet (UniversalRecords& records)
{
    UniversalElements elements;

    while (! records.atEnd())
    {
        const auto head = records.integers (6, 6);
        UniversalElement element;
        std::copy_n (head.begin(), element.head.size(), element.head.begin());

        if (isBeam (element.head[1]))
            element.beam = records.integers (1, 3);

        element.nodes = readNodeList (records, toCount (records, head[5]));
        elements.elements.push_back (std::move (element));
    }

    return elements;
}

std::string encodeNodeSet (const UniversalNodes& nodes)
{
    std::string text;

    for (std::size_t n = 0; n < nodes.labels.size(); ++n)
    {
        appendInteger (text, nodes.labels[n]);

        for (const auto number : nodes.systems[n])
            appendInteger (text, number);

        text += nodes.isDouble ? "\n" : "";

        for (const auto coordinate : nodes.places.row (static_cast<Eigen::Index> (n)))
            if (nodes.isDouble)
                appendReal (text, coordinate, 25, 16, 'D');
            else
                appendReal (text, coordinate);

        text += '\n';
    }

    return text;
}

std::string encodeTraceSet (const UniversalTrace& trace)
{
    auto text = integerRecord ({ trace.number, static_cast<UniversalLabel> (trace.nodes.size()), trace.colour });
    text += textRecord (trace.text);
    appendIntegers (text, trace.nodes);
    return text;
}

std::string encodeElementSet (const UniversalElements& elements)
{
    std::string text;

    for (const auto& element : elements.elements)
    {
        std::vector<UniversalLabel> head (element.head.begin(), element.head.end());
        head.push_back (static_cast<UniversalLabel> (element.nodes.size()));
        text += integerRecord (head);

        if (! element.beam.empty())
            text += integerRecord (element.beam);

        appendIntegers (text, element.nodes);
    }

    return text;
}

UniversalHeader readHeaderSet (UniversalRecords& records)
{
    UniversalHeader header;

    while (records.bytesLeft() > 0)
    {
        const auto record = records.record();
        const auto blanks = std::min (record.find_first_not_of (' '), record.size());
        header.lines.push_back (std::string (blanks, ' ')
                                + trimmedText (record.substr (blanks))); // Blanks are columns of dates.
    }

    return header;
}

UniversalUnits readUnitSet (UniversalRecords& records)
{
    constexpr std::size_t codeWidth = 10, descriptionWidth = 20, factorWidth = 25;
    UniversalUnits units;
    const auto head = records.record();
    std::vector<double> code, mode, factors;

    if (! appendRecordNumbers (head.substr (0, codeWidth), { codeWidth }, code) || code.size() != 1)
        records.fail ("has " + inQuotes (head) + "; allowed: the code of a system of units");

    units.code = static_cast<int> (std::clamp (code[0], -1e6, 1e6));

    if (head.size() > codeWidth)
        units.description = trimmedText (head.substr (codeWidth, descriptionWidth));

    if (head.size() > codeWidth + descriptionWidth
        && appendRecordNumbers (head.substr (codeWidth + descriptionWidth), { codeWidth }, mode) && mode.size() == 1)
        units.temperatureMode = static_cast<int> (std::clamp (mode[0], -1e6, 1e6));

    records.appendNumbers ({ factorWidth }, factors);

    if (! records.atEnd())
        records.appendNumbers ({ factorWidth }, factors);

    if (factors.size() < 3
        || ! (factors[0] > 0 && factors[1] > 0 && std::isnormal (factors[0]) && std::isnormal (factors[1])))
        records.fail ("has unusable unit factors; allowed: factors of length, force and temperature above 0");

    units.length = factors[0];
    units.force = factors[1];
    units.temperature = factors[2];
    units.temperatureOffset = factors.size() > 3 ? factors[3] : 0;
    return units;
}

std::string encodeHeaderSet (const UniversalHeader& header)
{
    std::string text;

    for (const auto& line : header.lines)
        text += textRecord (line);

    return text;
}

std::string encodeUnitSet (const UniversalUnits& units)
{
    std::string text;
    appendInteger (text, units.code);
    auto description = plainText (units.description, 20);
    description.resize (20, ' ');
    text += description;
    appendInteger (text, units.temperatureMode);
    text += '\n';

    for (const auto factor : { units.length, units.force, units.temperature })
        appendReal (text, factor, 25, 17, 'D');

    text += '\n';
    appendReal (text, units.temperatureOffset, 25, 17, 'D');
    return text + '\n';
}
} // namespace antinode
