#pragma once

#include <Eigen/Core>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace antinode::test
{
using Lines = std::vector<std::string>;

inline Lines splitLines (const std::string& text)
{
    Lines lines;
    std::istringstream stream (text);

    for (std::string line; std::getline (stream, line);)
        lines.push_back (line);

    return lines;
}

struct DataSet
{
    int number = 0;
    Lines records;
};

/** The data sets of a file, each between two lines of -1. */
inline std::vector<DataSet> readSets (const std::string& text)
{
    std::vector<DataSet> sets;
    const auto lines = splitLines (text);

    for (auto line = lines.begin(); line != lines.end();)
    {
        REQUIRE (*line == "    -1");
        const auto end = std::find (line + 1, lines.end(), "    -1");
        REQUIRE (end - line >= 2);
        REQUIRE (end != lines.end());
        CHECK ((line + 1)->size() == 6);
        sets.push_back ({ std::stoi (*(line + 1)), { line + 2, end } });
        line = end + 1;
    }

    return sets;
}

inline std::vector<DataSet> readSets (const std::string& text, int number)
{
    auto sets = readSets (text);
    sets.erase (std::remove_if (sets.begin(), sets.end(), [&] (const auto& set) { return set.number != number; }),
                sets.end());
    return sets;
}

/** The numbers of a record whose columns have these widths: a reader by columns, not by spaces, as Fortran is. */
inline std::vector<double> splitColumns (const std::string& record, const std::vector<std::size_t>& widths)
{
    std::vector<double> numbers;
    std::size_t at = 0;

    for (const auto width : widths)
    {
        REQUIRE (at + width <= record.size());
        std::size_t read = 0;
        const auto field = record.substr (at, width);
        numbers.push_back (std::stod (field, &read));
        CHECK (read == width); // Right-justified, so nothing stands behind the number.
        at += width;
    }

    CHECK (at == record.size());
    return numbers;
}

inline std::vector<double> integers (const std::string& record)
{
    return splitColumns (record, std::vector<std::size_t> (record.size() / 10, 10));
}

inline std::vector<double> reals (const std::string& record)
{
    return splitColumns (record, std::vector<std::size_t> (record.size() / 13, 13));
}

/** N x 3: the places of the nodes, whose labels must count from 1. */
inline Eigen::MatrixX3d readNodes (const std::string& text)
{
    const auto sets = readSets (text, 15);
    REQUIRE (sets.size() == 1);
    Eigen::MatrixX3d nodes (static_cast<Eigen::Index> (sets[0].records.size()), 3);

    for (Eigen::Index p = 0; p < nodes.rows(); ++p)
    {
        const auto numbers =
            splitColumns (sets[0].records[static_cast<std::size_t> (p)], { 10, 10, 10, 10, 13, 13, 13 });
        CHECK (numbers[0] == static_cast<double> (p + 1));
        CHECK ((numbers[1] == 0 && numbers[2] == 0));
        nodes.row (p) << numbers[4], numbers[5], numbers[6];
    }

    return nodes;
}

/** N x modes: the displacements along z; those along x and y must be 0. */
inline Eigen::MatrixXd readShapes (const std::string& text, Eigen::Index nodes)
{
    const auto sets = readSets (text, 55);
    Eigen::MatrixXd shapes (nodes, static_cast<Eigen::Index> (sets.size()));

    for (std::size_t k = 0; k < sets.size(); ++k)
    {
        const auto& records = sets[k].records;
        REQUIRE (records.size() == 8 + 2 * static_cast<std::size_t> (nodes));

        for (Eigen::Index p = 0; p < nodes; ++p)
        {
            const auto at = 8 + 2 * static_cast<std::size_t> (p);
            const auto values = reals (records[at + 1]);
            CHECK (integers (records[at]) == std::vector<double> { static_cast<double> (p + 1) });
            REQUIRE (values.size() == 3);
            CHECK ((values[0] == 0 && values[1] == 0));
            shapes (p, static_cast<Eigen::Index> (k)) = values[2];
        }
    }

    return shapes;
}

/** All pairs of nodes that a line joins. */
inline std::set<std::pair<int, int>> readEdges (const std::string& text)
{
    std::set<std::pair<int, int>> edges;

    for (const auto& set : readSets (text, 82))
    {
        const auto head = integers (set.records[0]);
        std::vector<int> nodes;

        for (std::size_t line = 2; line < set.records.size(); ++line)
            for (const auto node : integers (set.records[line]))
                nodes.push_back (static_cast<int> (node));

        REQUIRE (head.size() == 3);
        CHECK (head[1] == static_cast<double> (nodes.size()));
        CHECK (nodes.size() <= 125);
        CHECK_FALSE (set.records[1].empty());

        for (std::size_t i = 1; i < nodes.size(); ++i)
            edges.emplace (std::minmax (nodes[i - 1], nodes[i]));
    }

    return edges;
}
} // namespace antinode::test
