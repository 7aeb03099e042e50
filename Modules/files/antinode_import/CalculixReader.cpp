#include "CalculixReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_responses/UniversalNumbers.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace antinode
{
namespace
{
constexpr std::size_t valueWidth = 12, valuesOfLine = 6;

/** Lines of a file, one after the other, and its columns. */
class Lines
{
public:
    Lines (std::string_view textToRead, std::string name) : text (textToRead), source (std::move (name)) {}

    /** @return  false at the end */
    bool next()
    {
        if (position >= text.size())
            return false;

        const auto end = std::min (text.find ('\n', position), text.size());
        line = text.substr (position, end - position);
        position = end + 1;
        ++number;

        if (! line.empty() && line.back() == '\r')
            line.remove_suffix (1);

        return true;
    }

    std::string_view columns (std::size_t first, std::size_t count) const
    {
        return first < line.size() ? line.substr (first, count) : std::string_view {};
    }

    /** The key of a line: its first columns without blanks. */
    std::string_view key (std::size_t width) const { return stripped (columns (0, width)); }

    std::int64_t integer (std::size_t first, std::size_t width) const
    {
        const auto field = stripped (columns (first, width));
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars (field.data(), field.data() + field.size(), value);

        if (error != std::errc() || end != field.data() + field.size())
            fail ("has " + inQuotes (field) + " where a whole number must be");

        return value;
    }

    /** Numbers in columns of twelve characters. */
    void appendValues (std::size_t first, std::vector<double>& to) const
    {
        const auto field = columns (first, valueWidth * valuesOfLine);
        const auto before = to.size();
        const auto isRead = appendRecordNumbers (field, { valueWidth }, to);

        if (! isRead
            || ! std::all_of (to.begin() + static_cast<std::ptrdiff_t> (before), to.end(),
                              [] (double value) { return std::isfinite (value); }))
            fail ("has no numbers in " + inQuotes (field));
    }

    [[noreturn]] void fail (const std::string& wrong) const
    {
        throw InputError (source + ", line " + std::to_string (number), wrong);
    }

    static std::string_view stripped (std::string_view field)
    {
        const auto first = field.find_first_not_of (' ');
        return first == std::string_view::npos ? std::string_view {}
                                               : field.substr (first, field.find_last_not_of (' ') - first + 1);
    }

private:
    std::string_view text, line;
    std::string source;
    std::size_t position = 0, number = 0;
};

/** A block of nodal values, and the step that it is of. */
struct Block
{
    std::int64_t step = 0;
    bool isMode = false;
    double value = 0; ///< Hz of a mode.
    std::string name;
    Eigen::MatrixX3d values;
};

/** The file as it is read, block after block. */
class Reader
{
public:
    Reader (std::string_view bytes, const std::string& source) : lines (bytes, source) {}

    ElementResults read()
    {
        while (lines.next())
        {
            if (lines.key (6) == "2C")
                readNodes();
            else if (lines.key (6) == "3C")
                readElements();
            else if (lines.columns (4, 5) == "1PSTE")
                readStep();
            else if (lines.key (6) == "100C")
                readBlock();
        }

        if (results.labels.empty())
            lines.fail ("is the end, and there were no nodes; allowed: a results file (.frd) of CalculiX as text");

        sortBlocks();
        return std::move (results);
    }

private:
    /** How many characters a label has, by the number at the end of a block's first line. */
    std::size_t labelWidth (std::size_t column) const
    {
        const auto format = lines.integer (column, 2);

        if (format > 1)
            lines.fail (
                "begins a binary block; allowed: text (*NODE FILE, without OUTPUT=... and the format of ASCII)");

        return format == 0 ? 5 : 10;
    }

    bool nextRecord()
    {
        if (! lines.next())
            lines.fail ("is the end within a block");

        return lines.key (3) != "-3";
    }

    /** Of three numbers the last one is that of the analysis step. */
    void readStep()
    {
        std::vector<double> numbers;

        if (! appendRecordNumbers (lines.columns (10, 60), { 12 }, numbers) || numbers.size() != 3)
            lines.fail ("does not have the three numbers of a step");

        step = static_cast<std::int64_t> (std::clamp (numbers[2], 0.0, 1e15));
    }

    void readNodes()
    {
        const auto width = labelWidth (73);
        std::vector<double> values;

        if (! results.labels.empty())
            lines.fail ("begins a second block of nodes; allowed: one");

        while (nextRecord())
        {
            const auto before = values.size();
            results.labels.push_back (lines.integer (3, width));
            lines.appendValues (3 + width, values);

            if (values.size() != before + 3)
                lines.fail ("does not have three coordinates");

            if (! indices.emplace (results.labels.back(), indices.size()).second)
                lines.fail ("has node " + std::to_string (results.labels.back()) + " once more");
        }

        results.places = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> (
            values.data(), static_cast<Eigen::Index> (results.labels.size()), 3);
    }

    Eigen::Index indexOf (std::int64_t label) const
    {
        const auto found = indices.find (label);

        if (found == indices.end())
            lines.fail ("names node " + std::to_string (label) + ", which there is not");

        return static_cast<Eigen::Index> (found->second);
    }

    void readElements()
    {
        const auto width = labelWidth (73);

        while (nextRecord())
            if (lines.key (3) == "-1")
                results.elements.push_back ({ lines.integer (13 + width, 5), {} });
            else if (lines.key (3) == "-2" && ! results.elements.empty())
                for (std::size_t column = 3; ! Lines::stripped (lines.columns (column, width)).empty(); column += width)
                    results.elements.back().nodes.push_back (indexOf (lines.integer (column, width)));
            else
                lines.fail ("is not a line of an element");
    }

    void readBlock()
    {
        if (results.labels.empty())
            lines.fail ("begins results before the nodes; allowed: nodes first");

        Block block;
        block.step = step;
        std::vector<double> value;
        const auto isMode = lines.columns (58, 15).find ("MODAL") != std::string_view::npos;
        const auto width = labelWidth (73);

        if (! appendRecordNumbers (lines.columns (12, valueWidth), { valueWidth }, value) || value.size() != 1)
            lines.fail ("has no time or frequency");

        block.isMode = isMode;
        block.value = value[0];

        if (! nextRecord() || lines.key (3) != "-4")
            lines.fail ("is not the name of a block of results");

        block.name = std::string (Lines::stripped (lines.columns (5, 8)));
        readValues (block, width);

        if (block.name == "DISP" || block.name == "FORC")
            blocks.push_back (std::move (block));
        else if (block.name == "DISPI")
            lines.fail ("ends imaginary parts of displacements; allowed: real modes of *FREQUENCY, or complex ones in "
                        "a universal file");
    }

    void readValues (Block& block, std::size_t width)
    {
        block.values = Eigen::MatrixX3d::Zero (results.places.rows(), 3);
        std::vector<double> values;

        while (nextRecord())
            if (const auto key = lines.key (3); key == "-1")
            {
                values.clear();
                const auto node = indexOf (lines.integer (3, width));
                lines.appendValues (3 + width, values);

                if (block.name != "DISP" && block.name != "FORC")
                    continue;

                if (values.size() < 3)
                    lines.fail ("does not have three components");

                block.values.row (node) << values[0], values[1], values[2];
            }
            else if (key != "-5" && key != "-2")
                lines.fail ("is not a line of results");
    }

    /** Modes by themselves; static steps with motion are displacements, those without are held: their forces count. */
    void sortBlocks()
    {
        std::map<std::int64_t, bool> moves;

        for (const auto& block : blocks)
            if (! block.isMode && block.name == "DISP")
                moves[block.step] = block.values.cwiseAbs().maxCoeff() > 0;

        for (auto& block : blocks)
            if (block.isMode && block.name == "DISP")
                results.modes.push_back ({ block.value, 0, block.values.cast<std::complex<double>>() });
            else if (! block.isMode && block.name == "FORC" && ! moves[block.step])
                results.blockedForces.push_back (std::move (block.values));
            else if (! block.isMode && block.name == "DISP" && moves[block.step])
                results.staticDisplacements.push_back (std::move (block.values));
    }

    Lines lines;
    std::int64_t step = 0;
    std::map<std::int64_t, std::size_t> indices; ///< Of nodes, by their labels.
    std::vector<Block> blocks;
    ElementResults results;
};
} // namespace

ElementResults readCalculixResults (std::string_view bytes, const std::string& source)
{
    return Reader (bytes, source).read();
}

double calculixMass (std::string_view bytes)
{
    constexpr std::string_view heading = "T O T A L   E F F E C T I V E   M A S S";
    const auto found = bytes.find (heading);

    if (found == std::string_view::npos)
        return 0;

    Lines lines (bytes.substr (found), "");

    constexpr std::size_t firstWidth = 23, width = 16, translations = 3;

    for (int line = 0; line < 6 && lines.next(); ++line)
        if (std::vector<double> values;
            appendRecordNumbers (lines.columns (0, firstWidth + 2 * width), { firstWidth, width, width }, values)
            && values.size() == translations)
            return *std::max_element (values.begin(), values.end());

    return 0;
}
} // namespace antinode
