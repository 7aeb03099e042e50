#include "UniversalHeaderSets.h"

#include "UniversalRecordText.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
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
