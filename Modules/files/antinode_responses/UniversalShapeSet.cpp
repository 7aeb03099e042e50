#include "UniversalShapeSet.h"

#include "UniversalRecordText.h"

#include <antinode_base/MessageText.h>

namespace antinode
{
namespace
{
constexpr int realData = 2, complexData = 5, maximumValuesPerNode = 1000;

/** Numbers of a group of records, up to the given count. */
std::vector<double> someNumbers (UniversalRecords& records, std::size_t count, std::size_t width)
{
    std::vector<double> numbers;

    while (numbers.size() < count)
        records.appendNumbers ({ width }, numbers);

    numbers.resize (count);
    return numbers;
}

void readAnalysis (UniversalShape& shape, UniversalRecords& records)
{
    constexpr double maximumNumbers = 100;
    auto integers = records.numbers ({ 10 });

    if (integers.size() < 2
        || ! (integers[0] >= 0 && integers[0] <= maximumNumbers && integers[1] >= 0 && integers[1] <= maximumNumbers))
        records.fail ("does not say how many integers and reals follow; allowed: 0 to 100 of each");

    const auto wanted = static_cast<std::size_t> (integers[0]), reals = static_cast<std::size_t> (integers[1]);

    while (integers.size() < 2 + wanted)
        records.appendNumbers ({ 10 }, integers);

    for (std::size_t i = 0; i < wanted; ++i)
        shape.integers.push_back (records.whole (integers[2 + i]));

    shape.reals = someNumbers (records, reals, 13);
}
} // namespace

UniversalShape readShapeSet (UniversalRecords& records)
{
    UniversalShape shape;

    for (auto& line : shape.lines)
        line = records.textRecord();

    const auto form = records.integers (6, 6);

    if (form[4] != realData && form[4] != complexData)
        records.fail ("has data of type " + std::to_string (form[4]) + "; allowed: 2 (real) or 5 (complex)");

    if (form[5] < 1 || form[5] > maximumValuesPerNode)
        records.fail ("has " + std::to_string (form[5]) + " values per node; allowed: 1 to "
                      + std::to_string (maximumValuesPerNode));

    shape.modelType = static_cast<int> (form[0]);
    shape.analysisType = static_cast<int> (form[1]);
    shape.dataCharacteristic = static_cast<int> (form[2]);
    shape.specificType = static_cast<int> (form[3]);
    shape.isComplex = form[4] == complexData;
    readAnalysis (shape, records);

    const auto values = static_cast<std::size_t> (form[5]), parts = values * (shape.isComplex ? 2 : 1);
    std::vector<double> numbers;

    while (! records.atEnd())
    {
        shape.nodes.push_back (records.integers (1, 1)[0]);
        const auto some = someNumbers (records, parts, 13);
        numbers.insert (numbers.end(), some.begin(), some.end());
    }

    shape.values.resize (static_cast<Eigen::Index> (shape.nodes.size()), static_cast<Eigen::Index> (values));
    auto number = numbers.begin();

    for (auto& value : shape.values.reshaped<Eigen::RowMajor>())
    {
        value.real (*number++);
        value.imag (shape.isComplex ? *number++ : 0);
    }

    return shape;
}

std::string encodeShapeSet (const UniversalShape& shape)
{
    constexpr std::size_t realsARecord = 6, integersARecord = 8;
    std::string text;

    for (const auto& line : shape.lines)
        text += textRecord (line);

    text += integerRecord ({ shape.modelType, shape.analysisType, shape.dataCharacteristic, shape.specificType,
                             shape.isComplex ? complexData : realData, shape.values.cols() });
    std::vector<UniversalLabel> integers { static_cast<UniversalLabel> (shape.integers.size()),
                                           static_cast<UniversalLabel> (shape.reals.size()) };
    integers.insert (integers.end(), shape.integers.begin(), shape.integers.end());
    appendRecords (text, integers, integersARecord, [] (auto& to, auto number) { appendInteger (to, number); });
    appendRecords (text, shape.reals, realsARecord, [] (auto& to, auto number) { appendReal (to, number); });

    for (std::size_t n = 0; n < shape.nodes.size(); ++n)
    {
        std::vector<double> numbers;
        text += integerRecord ({ shape.nodes[n] });

        for (const auto& value : shape.values.row (static_cast<Eigen::Index> (n)))
        {
            numbers.push_back (value.real());

            if (shape.isComplex)
                numbers.push_back (value.imag());
        }

        appendRecords (text, numbers, realsARecord, [] (auto& to, auto number) { appendReal (to, number); });
    }

    return text;
}
} // namespace antinode
