#include "CsvTable.h"

#include "CsvLines.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
bool isNumeric (const std::vector<std::string_view>& cells, char separator)
{
    const auto first = cells.empty() ? std::nullopt : csvNumber (cells.front(), separator);
    return first && std::isfinite (*first);
}

void addHeadings (const std::vector<std::string_view>& cells, std::vector<std::string>& headings)
{
    headings.resize (cells.size());

    for (std::size_t c = 0; c < cells.size(); ++c)
        headings[c] += (headings[c].empty() ? "" : " ") + trimmedText (cells[c]);
}

Eigen::MatrixXd readNumbers (const std::vector<CsvLine>& lines, std::size_t first, char separator,
                             const std::string& source)
{
    const auto columns = csvCells (lines[first].text, separator).size();
    std::vector<double> numbers;

    for (auto i = first; i < lines.size(); ++i)
    {
        const auto where = source + ": line " + std::to_string (lines[i].number);

        if (csvCommentMark (lines[i].text) > 0)
            continue;

        const auto cells = csvCells (lines[i].text, separator);

        if (cells.size() != columns)
            throw InputError (where, "has " + std::to_string (cells.size()) + " cells; allowed: "
                                         + std::to_string (columns) + " as in the first line of numbers");

        for (const auto cell : cells)
        {
            const auto number = csvNumber (cell, separator);

            if (! number)
                throw InputError (where, "has " + inQuotes (cell) + "; allowed: numbers");

            numbers.push_back (*number);
        }
    }

    return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> (
        numbers.data(), static_cast<Eigen::Index> (numbers.size() / columns), static_cast<Eigen::Index> (columns));
}
} // namespace

CsvTable readCsvTable (std::string_view text, const std::string& source)
{
    if (text.find ('\0') != std::string_view::npos)
        throw InputError (source, "is not a text table");

    const auto lines = csvLines (text);
    const auto separator = lines.empty() ? ',' : csvSeparator (lines.back().text);
    const auto isRow = [&] (const CsvLine& line)
    { return csvCommentMark (line.text) == 0 && isNumeric (csvCells (line.text, separator), separator); };
    const auto first = static_cast<std::size_t> (std::find_if (lines.begin(), lines.end(), isRow) - lines.begin());

    if (first == lines.size())
        throw InputError (source, "has no line of numbers");

    const auto columns = csvCells (lines[first].text, separator).size();
    CsvTable table;

    for (std::size_t i = 0; i < first; ++i)
    {
        const auto mark = csvCommentMark (lines[i].text);
        const auto cells = csvCells (lines[i].text, separator);

        if (mark == 0 && cells.size() == columns)
            addHeadings (cells, table.headings);
        else
            table.comments.push_back (trimmedText (csvStripped (lines[i].text).substr (mark)));
    }

    table.numbers = readNumbers (lines, first, separator, source);
    return table;
}
} // namespace antinode
