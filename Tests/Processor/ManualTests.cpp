#include <Processor/AntinodeProcessor.h>

#include <catch2/catch.hpp>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

using namespace antinode;

namespace
{
using Cells = std::vector<std::string>;

std::string trimmed (const std::string& text)
{
    const auto first = text.find_first_not_of (" `"), last = text.find_last_not_of (" `");
    return first == std::string::npos ? "" : text.substr (first, last - first + 1);
}

/** The rows of the manual's tables whose first cell is an identifier in backquotes. */
std::map<std::string, Cells> documentedParameters()
{
    std::ifstream page (std::string (ANTINODE_MANUAL) + "/parameters.md");
    std::map<std::string, Cells> rows;

    for (std::string line; std::getline (page, line);)
    {
        if (! line.starts_with ("| `"))
            continue;

        Cells cells;
        std::istringstream stream (line.substr (1));

        for (std::string cell; std::getline (stream, cell, '|');)
            cells.push_back (trimmed (cell));

        rows[cells.front()] = cells;
    }

    return rows;
}

std::string number (float value)
{
    std::ostringstream stream;
    stream << value;
    return stream.str();
}

/** Identifier, name, range, value at first: as the manual's row must begin. */
Cells manualRow (const juce::RangedAudioParameter& parameter)
{
    const auto& range = parameter.getNormalisableRange();
    const auto identifier = parameter.getParameterID().toStdString();
    return { identifier, parameter.getName (100).toStdString(), number (range.start) + " to " + number (range.end),
             parameter.getText (parameter.getDefaultValue(), 100).toStdString() };
}
} // namespace

TEST_CASE ("The manual lists every parameter with its name, range and first value, and no other", "[plugin][manual]")
{
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
    auto documented = documentedParameters();

    for (auto* const any : processor.getParameters())
    {
        const auto& parameter = *dynamic_cast<juce::RangedAudioParameter*> (any);
        const auto wanted = manualRow (parameter);
        INFO (wanted.front());
        REQUIRE (documented.contains (wanted.front()));
        const auto row = documented.extract (wanted.front()).mapped();
        REQUIRE (row.size() == 6);
        CHECK (Cells (row.begin(), row.begin() + 3) == Cells (wanted.begin(), wanted.begin() + 3));

        // The first value of a place depends on the device; in the table it is a percentage.
        if (! row[4].starts_with ("%"))
            CHECK (row[3] == wanted[3]);

        if (parameter.isDiscrete() && parameter.getNumSteps() <= 5)
            for (int i = 0; i < parameter.getNumSteps(); ++i)
            {
                const auto share = static_cast<float> (i) / static_cast<float> (parameter.getNumSteps() - 1);
                CHECK_THAT (row[5], Catch::Contains (parameter.getText (share, 100).toStdString()));
            }
    }

    for (const auto& [identifier, row] : documented)
        FAIL_CHECK (identifier << " is in the manual, but is no parameter");
}
