#include "ElementReaders.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_responses/UniversalRecords.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <variant>

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

namespace
{
constexpr int normalMode = 2, complexModes[] = { 3, 7 }, staticCase = 1;
constexpr int displacement = 8, reactionForce = 9;

/** Sets of one universal file, put together. */
class Collector
{
public:
    explicit Collector (std::string name) : source (std::move (name)) {}

    void operator() (const UniversalUnits& set) { units = set; }

    void operator() (const UniversalNodes& set)
    {
        if (! results.labels.empty())
            throw InputError (source, "has two sets of nodes; allowed: one of type 15 or 2411");

        results.labels = set.labels;
        results.places = set.places;

        for (std::size_t n = 0; n < set.labels.size(); ++n)
            indices.emplace (set.labels[n], static_cast<Eigen::Index> (n));
    }

    void operator() (const UniversalElements& set)
    {
        for (const auto& element : set.elements)
        {
            MeshElement found { element.head[3], {} };

            for (const auto label : element.nodes)
                found.nodes.push_back (indexOf (label));

            results.elements.push_back (std::move (found));
        }
    }

    void operator() (const UniversalShape& set)
    {
        take ({ set.analysisType, set.specificType, set.reals }, set.isComplex, vectors (set.nodes, set.values));
    }

    void operator() (const UniversalResults& set)
    {
        constexpr int atNodes = 1, firstComplex = 5;

        if (set.location != atNodes || set.results.empty())
            return;

        std::vector<UniversalLabel> nodes;
        Eigen::MatrixXcd values (static_cast<Eigen::Index> (set.results.size()), set.results.front().values.size());

        for (std::size_t n = 0; n < set.results.size(); ++n)
        {
            if (set.results[n].head.empty() || set.results[n].values.size() != values.cols())
                throw InputError (
                    source, "has a set 2414 with nodes of different numbers of values; allowed: one number for all");

            nodes.push_back (set.results[n].head.front());
            values.row (static_cast<Eigen::Index> (n)) = set.results[n].values.transpose();
        }

        take ({ set.kind[1], set.kind[3], realsOf (set) }, set.kind[4] >= firstComplex, vectors (nodes, values));
    }

    void operator() (const auto&) {}

    ElementResults finish()
    {
        if (units)
            toSi();

        return std::move (results);
    }

private:
    /** What a set says of its values. */
    struct Head
    {
        int analysis, quantity;
        std::vector<double> reals;
    };

    Eigen::Index indexOf (UniversalLabel label) const
    {
        const auto found = indices.find (label);

        if (found == indices.end())
            throw InputError (source,
                              "has values at node " + std::to_string (label)
                                  + ", which it does not define; allowed: nodes of a set 15 or 2411 before them");

        return found->second;
    }

    Eigen::MatrixX3cd vectors (const std::vector<UniversalLabel>& nodes, const Eigen::MatrixXcd& values) const
    {
        if (results.labels.empty())
            throw InputError (source, "has results before its nodes; allowed: a set 15 or 2411 first");

        Eigen::MatrixX3cd result = Eigen::MatrixX3cd::Zero (results.places.rows(), 3);

        if (values.cols() < 3)
            return result;

        for (std::size_t n = 0; n < nodes.size(); ++n)
            result.row (indexOf (nodes[n])) = values.row (static_cast<Eigen::Index> (n)).head (3);

        return result;
    }

    /** In a set 2414 of a normal mode: 4 unused reals behind time, frequency, eigenvalue and modal mass; as in a
     * set 55. */
    static std::vector<double> realsOf (const UniversalResults& set)
    {
        if (set.kind[1] == normalMode)
            return { set.reals[1], set.reals[3], set.reals[4], set.reals[5] };

        return { set.reals[6], set.reals[7], set.reals[8], set.reals[9] };
    }

    void take (const Head& head, bool isComplex, const Eigen::MatrixX3cd& values)
    {
        const auto isMotion = head.quantity == displacement || head.quantity == 0;

        if (head.analysis == normalMode && isMotion)
            addNormalMode (head.reals, values);
        else if ((head.analysis == complexModes[0] || head.analysis == complexModes[1]) && isMotion && isComplex)
            addComplexMode (head.reals, values);
        else if (head.analysis == staticCase && head.quantity == reactionForce)
            results.blockedForces.emplace_back (values.real());
        else if (head.analysis == staticCase && isMotion)
            results.staticDisplacements.emplace_back (values.real());
    }

    void addNormalMode (const std::vector<double>& reals, const Eigen::MatrixX3cd& values)
    {
        if (reals.size() < 2 || ! (reals[1] > 0))
            throw InputError (source, "has a mode without modal mass; allowed: above 0, 1 for mass-normalised shapes");

        const auto damping = reals.size() > 2 ? reals[2] : 0;
        results.modes.push_back ({ reals[0], damping, values / std::sqrt (reals[1]) });
    }

    /** Scaled so that modal A is 2 j Im (eigenvalue), as that of a real mode of mass 1 is. */
    void addComplexMode (const std::vector<double>& reals, const Eigen::MatrixX3cd& values)
    {
        if (reals.size() < 4)
            throw InputError (source, "has a complex mode without modal A; allowed: eigenvalue and modal A");

        const std::complex<double> pole (reals[0], reals[1]), modalA (reals[2], reals[3]);

        if (pole.imag() < 0)
            return; // Its conjugate is there.

        if (! (std::abs (modalA) > 0) || ! (std::abs (pole) > 0))
            throw InputError (source, "has a complex mode whose eigenvalue or modal A is 0; allowed: other numbers");

        const auto factor = std::sqrt (std::complex<double> (0, 2 * pole.imag()) / modalA);
        results.modes.push_back (
            { std::abs (pole) / (2 * std::numbers::pi), -pole.real() / std::abs (pole), factor * values });
    }

    /** Lengths and forces by their factors; masses follow from N s^2 / m. */
    void toSi()
    {
        const auto length = units->length, force = units->force;
        results.places /= length;

        for (auto& forces : results.blockedForces)
            forces /= force;

        for (auto& displacements : results.staticDisplacements)
            displacements /= length;

        for (auto& mode : results.modes)
            mode.shape *= std::sqrt (force / length);
    }

    std::string source;
    std::optional<UniversalUnits> units;
    std::map<UniversalLabel, Eigen::Index> indices;
    ElementResults results;
};
} // namespace

ElementResults universalResults (const std::vector<UniversalSet>& sets, const std::string& source)
{
    Collector collector (source);

    for (const auto& set : sets)
        std::visit (collector, set);

    return collector.finish();
}
} // namespace antinode
