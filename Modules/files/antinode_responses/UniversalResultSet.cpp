#include "UniversalResultSet.h"

#include "UniversalRecordText.h"

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
} // namespace antinode
