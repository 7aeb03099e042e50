#include "UniversalResultSets.h"

#include "UniversalRecords.h"

#include <antinode_base/MessageText.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int integerData = 1, firstComplex = 5;
constexpr UniversalLabel maximumValues = 1000000;

/** How the numbers of one place stand in records. */
struct NumberForm
{
    std::size_t width, aRecord;
    int digits; ///< Behind the point; 0: integers.
};

NumberForm numberForm (int dataType)
{
    if (dataType == integerData)
        return { 10, 8, 0 };

    return dataType == 4 || dataType == 6 ? NumberForm { 20, 4, 12 } : NumberForm { 13, 6, 5 };
}

/** How many integers tell where values stand, by the location. */
std::size_t headSize (int location)
{
    return location == 1 ? 1 : location == 3 ? 4 : 2;
}

/** How many values follow the integers that tell where. */
UniversalLabel valueCount (UniversalRecords& records, const UniversalResults& results,
                           const std::vector<UniversalLabel>& head)
{
    constexpr UniversalLabel atAllNodes = 1;
    const auto limited = [&] (UniversalLabel count)
    {
        if (count < 0 || count > maximumValues || static_cast<std::size_t> (count) > records.bytesLeft())
            records.fail ("has " + std::to_string (count) + " values at a location, more than the file contains");

        return count;
    };

    if (results.location == 1)
        return limited (results.kind[5]);

    if (results.location != 3)
        return limited (head[1]);

    return limited (limited (head[3]) * (head[1] == atAllNodes ? limited (head[2]) : 1));
}

UniversalResult readResult (UniversalRecords& records, const UniversalResults& results)
{
    const auto size = headSize (results.location);
    const auto form = numberForm (results.kind[4]);
    UniversalResult result { records.integers (size, size), {} };
    const auto count = valueCount (records, results, result.head);
    const auto isComplex = results.kind[4] >= firstComplex;
    std::vector<double> numbers;

    while (numbers.size() < static_cast<std::size_t> (count) * (isComplex ? 2 : 1))
        records.appendNumbers ({ form.width }, numbers);

    result.values.resize (count);
    auto number = numbers.begin();

    for (auto& value : result.values)
    {
        value.real (form.digits == 0 ? static_cast<double> (records.whole (*number)) : *number);
        ++number;
        value.imag (isComplex ? *number++ : 0);
    }

    return result;
}

template <typename Numbers>
void copyInto (Numbers& target, const auto& source)
{
    std::copy_n (source.begin(), std::min (source.size(), target.size()), target.begin());
}
} // namespace

UniversalResults readResultSet (UniversalRecords& records)
{
    UniversalResults results;
    results.label = records.integers (1, 1)[0];
    results.name = records.textRecord();
    results.location = static_cast<int> (records.integers (1, 1)[0]);

    for (auto& line : results.lines)
        line = records.textRecord();

    const auto kind = records.integers (6, 6);
    std::transform (kind.begin(), kind.end(), results.kind.begin(),
                    [&] (auto number)
                    { return static_cast<int> (std::clamp<UniversalLabel> (number, -1, maximumValues)); });

    if (results.kind[4] < 1 || results.kind[4] > 6 || results.kind[4] == 3)
        records.fail ("has data of type " + std::to_string (results.kind[4]) + "; allowed: 1, 2, 4, 5 or 6");

    const auto firstIntegers = records.integers (1, 8), lastIntegers = records.integers (1, 2);
    copyInto (results.integers, firstIntegers);
    std::copy (lastIntegers.begin(), lastIntegers.end(), results.integers.begin() + 8);
    auto reals = records.numbers ({ 13 });
    reals.resize (6);
    records.appendNumbers ({ 13 }, reals);
    copyInto (results.reals, reals);

    while (! records.atEnd())
        results.results.push_back (readResult (records, results));

    return results;
}

std::string encodeResultSet (const UniversalResults& results)
{
    const auto form = numberForm (results.kind[4]);
    auto text = integerRecord ({ results.label }) + textRecord (results.name) + integerRecord ({ results.location });

    for (const auto& line : results.lines)
        text += textRecord (line);

    text += integerRecord ({ results.kind.begin(), results.kind.end() });
    text += integerRecord ({ results.integers.begin(), results.integers.begin() + 8 });
    text += integerRecord ({ results.integers.begin() + 8, results.integers.end() });
    appendRecords (text, results.reals, 6, [] (auto& to, auto number) { appendReal (to, number); });

    for (const auto& result : results.results)
    {
        std::vector<double> numbers;
        text += integerRecord (result.head);

        for (const auto& value : result.values)
        {
            numbers.push_back (value.real());

            if (results.kind[4] >= firstComplex)
                numbers.push_back (value.imag());
        }

        appendRecords (text, numbers, form.aRecord,
                       [&] (auto& to, auto number)
                       {
                           if (form.digits == 0)
                               appendInteger (to, static_cast<UniversalLabel> (number));
                           else
                               appendReal (to, number, form.width, form.digits, 'E');
                       });
    }

    return text;
}

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
