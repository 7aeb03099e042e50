#include "CsvTable.h"

#include "CsvText.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
using Cells = std::vector<std::string_view>;
constexpr std::string_view labViewMark = "***End_of_Header***";

/** The cells of a line; a date with its time in the next cell is left out. */
Cells cellsOf (std::string_view line, char separator)
{
    auto cells = csvCells (line, separator);

    if (cells.size() > 1 && isCsvDate (cells[0]) && cells[1].find (':') != std::string_view::npos)
        cells.erase (cells.begin());

    return cells;
}

/** How many cells there are without empty ones at the end. */
std::size_t usedCells (const Cells& cells)
{
    const auto last = std::find_if (cells.rbegin(), cells.rend(), [] (auto cell) { return ! cell.empty(); });
    return static_cast<std::size_t> (cells.rend() - last);
}

bool isNumeric (const Cells& cells, char separator)
{
    const auto first = cells.empty() ? std::nullopt : csvNumber (cells.front(), separator);
    return first && std::isfinite (*first);
}

/** What separates the cells of a line of numbers; nothing if it is none. */
std::optional<char> separatorOf (std::string_view line)
{
    const auto isNumber = [] (std::string_view cell, char separator)
    {
        const auto isSign = separator == ' ' && cell == "-"; // Of "1 - 2i".
        return ! isSign && (csvNumber (cell, separator) || csvComplex (cell, separator));
    };

    for (const auto separator : { csvSeparator (line), ',' })
    {
        const auto cells = cellsOf (line, separator);

        if (isNumeric (cells, separator)
            && std::all_of (cells.begin(), cells.end(), [&] (auto cell) { return isNumber (cell, separator); }))
            return separator;
    }

    return std::nullopt;
}

/** The lines of a text as a table. */
class TableText
{
public:
    TableText (std::string_view text, std::string file) : lines (csvLines (text)), source (std::move (file))
    {
        findSeparator();
        findRows();
        findColumns();
    }

    CsvTable table() const
    {
        CsvTable result;
        readHeader (result);

        for (auto i = end; i < lines.size(); ++i)
            result.comments.push_back (trimmedText (lines[i].text));

        readNumbers (result);
        return result;
    }

private:
    /** That of the last line of numbers: behind it there may be words. */
    void findSeparator()
    {
        for (auto line = lines.rbegin(); line != lines.rend(); ++line)
            if (const auto found = csvCommentMark (line->text) > 0 ? std::nullopt : separatorOf (line->text))
            {
                separator = *found;
                hasSeveralCells = usedCells (cellsOf (line->text, separator)) > 1;
                return;
            }

        if (! lines.empty())
            separator = csvSeparator (lines.back().text);
    }

    bool isRow (const CsvLine& line) const
    {
        const auto cells = cellsOf (line.text, separator);
        return csvCommentMark (line.text) == 0 && isNumeric (cells, separator)
               && (usedCells (cells) > 1 || ! hasSeveralCells);
    }

    /** Words, behind which no number comes. */
    bool isFooter (const CsvLine& line) const
    {
        const auto cells = cellsOf (line.text, separator);
        const auto begin = cells.empty() || cells[0].empty() ? ' ' : cells[0].front();
        return ! csvNumber (cells.empty() ? "" : cells[0], separator)
               && std::string_view ("0123456789+-.").find (begin) == std::string_view::npos;
    }

    void findRows()
    {
        const auto row = [this] (const CsvLine& line) { return isRow (line); };
        first = static_cast<std::size_t> (std::find_if (lines.begin(), lines.end(), row) - lines.begin());

        if (first == lines.size())
            throw InputError (source, "has no line of numbers");

        end = lines.size();

        while (isFooter (lines[end - 1]))
            --end;
    }

    void findColumns()
    {
        columns = 1;

        for (auto i = first; i < end; ++i)
            if (csvCommentMark (lines[i].text) == 0)
                columns = std::max (columns, usedCells (cellsOf (lines[i].text, separator)));

        columns = std::min (columns, cellsOf (lines[first].text, separator).size());
    }

    /** Whether cells are the headings of all columns; what is beyond them has no numbers. */
    bool areHeadings (const Cells& cells) const
    {
        const auto most = cellsOf (lines[first].text, separator).size();
        return cells.size() == columns
               || (cells.size() > columns
                   && (usedCells (cells) == columns || cells.size() <= most || cells.back() == "Comment"));
    }

    void readHeader (CsvTable& result) const
    {
        auto labels = first; // Before them there is nothing but LabVIEW's own header.

        while (labels > 0 && ! csvStripped (lines[labels - 1].text).starts_with (labViewMark))
            --labels;

        std::vector<std::string> units (columns);

        for (std::size_t i = 0; i < first; ++i)
        {
            const auto mark = csvCommentMark (lines[i].text);
            auto cells = csvCells (lines[i].text, separator);
            const auto name = cells.empty() ? std::string_view {} : cells[0];

            if (cells.size() > columns && (name == "Date" || name == "date"))
                cells.erase (cells.begin());

            if (i < labels && (name == "Y_Unit_Label" || name == "X_Dimension"))
                for (std::size_t c = 1; c < std::min (cells.size(), columns); ++c)
                    (name == "X_Dimension" ? units[0] : units[c]) = trimmedText (cells[c]);
            else if (i >= labels && mark == 0 && areHeadings (cells))
                addHeadings (cells, result.headings);
            else
                result.comments.push_back (trimmedText (csvStripped (lines[i].text).substr (mark)));
        }

        for (std::size_t c = 0; c < result.headings.size(); ++c)
            if (auto& heading = result.headings[c]; ! units[c].empty())
                c == 0 ? heading.insert (0, units[c] + " ") : heading.append (" (").append (units[c]).append (")");
    }

    void addHeadings (const Cells& cells, std::vector<std::string>& headings) const
    {
        headings.resize (columns);

        for (std::size_t c = 0; c < columns; ++c)
            headings[c].append (headings[c].empty() ? "" : " ").append (trimmedText (cells[c]));
    }

    std::string where (const CsvLine& line) const { return source + ": line " + std::to_string (line.number); }

    std::complex<double> numberIn (std::string_view cell, const CsvLine& line, bool& isComplex) const
    {
        if (const auto number = csvNumber (cell, separator))
            return *number;

        const auto number = csvComplex (cell, separator);
        isComplex = true;

        if (! number)
            throw InputError (where (line), "has " + inQuotes (cell) + "; allowed: numbers");

        return *number;
    }

    void readNumbers (CsvTable& result) const
    {
        std::vector<std::vector<double>> real (columns), imaginary (columns); // The latter empty where none is complex.

        for (auto i = first; i < end; ++i)
        {
            const auto cells = csvCommentMark (lines[i].text) > 0 ? Cells {} : cellsOf (lines[i].text, separator);
            const auto used = usedCells (cells), row = real[0].size();

            if (used > 0 && (cells.size() < columns || used > columns))
                throw InputError (where (lines[i]), "has " + std::to_string (cells.size())
                                                        + " cells; allowed: " + std::to_string (columns)
                                                        + " as in the first line of numbers");

            for (std::size_t c = 0; used > 0 && c < columns; ++c)
            {
                auto isComplex = ! imaginary[c].empty();
                const auto number = numberIn (cells[c], lines[i], isComplex);
                real[c].push_back (number.real());

                if (isComplex)
                {
                    imaginary[c].resize (row); // Those above were real.
                    imaginary[c].push_back (number.imag());
                }
            }
        }

        unwrapClock (real[0]);
        assemble (real, imaginary, result);
    }

    /** Times of the day go on after midnight. */
    void unwrapClock (std::vector<double>& times) const
    {
        constexpr double day = 86400;

        if (cellsOf (lines[first].text, separator)[0].find (':') != std::string_view::npos)
            for (std::size_t n = 1; n < times.size(); ++n)
                if (std::isfinite (times[n - 1]))
                    times[n] += day * std::round ((times[n - 1] - times[n]) / day);
    }

    static void assemble (const std::vector<std::vector<double>>& real,
                          const std::vector<std::vector<double>>& imaginary, CsvTable& result)
    {
        const auto parts =
            std::count_if (imaginary.begin(), imaginary.end(), [] (const auto& c) { return ! c.empty(); });
        const auto rows = static_cast<Eigen::Index> (real[0].size());
        result.numbers.resize (rows, std::ssize (real) + parts);
        std::vector<std::string> headings;
        Eigen::Index column = 0;

        for (std::size_t c = 0; c < real.size(); ++c)
        {
            const auto heading = result.headings.empty() ? std::string() : result.headings[c];
            result.numbers.col (column++) = Eigen::Map<const Eigen::VectorXd> (real[c].data(), rows);
            headings.push_back (imaginary[c].empty() ? heading : heading + " real");

            if (imaginary[c].empty())
                continue;

            result.numbers.col (column++) = Eigen::Map<const Eigen::VectorXd> (imaginary[c].data(), rows);
            headings.push_back (heading + " imag");
        }

        if (! result.headings.empty())
            result.headings = headings;
    }

    std::vector<CsvLine> lines;
    std::string source;
    char separator = ',';
    bool hasSeveralCells = false;
    std::size_t first = 0, end = 0, columns = 1; ///< Lines of numbers.
};
} // namespace

CsvTable readCsvTable (std::string_view bytes, const std::string& source)
{
    const auto text = csvText (bytes);

    if (text.find ('\0') != std::string::npos)
        throw InputError (source, "is not a text table");

    return TableText (text, source).table();
}
} // namespace antinode
