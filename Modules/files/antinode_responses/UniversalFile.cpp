#include "UniversalFile.h"

#include "UniversalFunctionSet.h"
#include "UniversalGeometrySets.h"
#include "UniversalHeaderSets.h"
#include "UniversalRecordText.h"
#include "UniversalResultSet.h"
#include "UniversalShapeSet.h"

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
} // namespace antinode
