#include "Support/RunProgram.h"
#include "Support/ScoreNumbers.h"

#include <antinode_text/OutputFolder.h>

#include <catch2/catch.hpp>

#include <regex>
#include <sstream>

using namespace antinode;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;
using test::scoreNumber;

namespace
{
/** The blocks of one language in a page, in their order. */
std::vector<std::string> blocksOf (const std::string& page, const std::string& language)
{
    const std::regex block ("```" + language + "\n([^`]*)```");
    std::vector<std::string> blocks;

    for (std::sregex_iterator found (page.begin(), page.end(), block); found != std::sregex_iterator(); ++found)
        blocks.push_back ((*found)[1]);

    return blocks;
}

ProgramArguments wordsOf (const std::string& command)
{
    std::istringstream stream (std::regex_replace (command, std::regex (R"(\\\n)"), " "));
    ProgramArguments words;
    std::string word;

    while (stream >> word)
        words.emplace_back (word);

    return words;
}

/** Names of files begin in a folder as long as it lives. */
class WorkingFolder
{
public:
    explicit WorkingFolder (const std::filesystem::path& folder) : before (std::filesystem::current_path())
    {
        std::filesystem::current_path (folder);
    }

    ~WorkingFolder() { std::filesystem::current_path (before); }
    WorkingFolder (const WorkingFolder&) = delete;
    WorkingFolder& operator= (const WorkingFolder&) = delete;

private:
    const std::filesystem::path before;
};
} // namespace

TEST_CASE ("The commands of the manual's page about a click lead to a decision", "[command line][manual]")
{
    const TemporaryFolder folder;
    const WorkingFolder working (folder.path());
    const auto page = readContent (std::filesystem::path (ANTINODE_MANUAL) / "click.md");
    CHECK (test::linesIn (page) <= 80);
    const auto contents = blocksOf (page, "json"), commands = blocksOf (page, "sh");
    REQUIRE (contents.size() == 1);
    REQUIRE (commands.size() == 4);
    writeWholeFile ("click.ahap", contents.front());

    for (const auto& command : commands)
    {
        auto words = wordsOf (command);
        REQUIRE (words.front().text == "antinode");
        words.erase (words.begin());
        const auto run = runProgram (words);
        CAPTURE (command, run.errors);
        REQUIRE (run.exitCode == 0);
    }

    // Half as many ceramics that are placed for the thumb need less energy than those along the edges.
    const auto scores = readContent ("decision/scores.csv");
    CHECK (test::linesIn (scores) == 4);
    const auto placed = scoreNumber (scores, "\"phone, 8", "energy_J");
    CHECK (placed > 0);
    CHECK (scoreNumber (scores, "phone: ", "energy_J") > placed);
    CHECK (std::filesystem::exists ("decision/report.html"));
    CHECK (std::filesystem::exists ("tolerance/tolerance.csv"));
}
