#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace antinode::test
{
/** A number of scores.csv. @param row  how its line begins @throws std::out_of_range  where it is not there */
inline double scoreNumber (const std::string& table, const std::string& row, const std::string& heading)
{
    std::istringstream lines (table);
    std::string headings, line, name, cell;
    std::getline (lines, headings);

    while (std::getline (lines, line))
        if (line.starts_with (row))
        {
            // The first cell may have commas in it.
            std::istringstream names (headings), cells (line.substr (line.front() == '"' ? line.find ('"', 1) + 1 : 0));

            while (std::getline (names, name, ',') && std::getline (cells, cell, ','))
                if (name == heading)
                    return std::stod (cell);
        }

    throw std::out_of_range (row + ", " + heading);
}
} // namespace antinode::test
