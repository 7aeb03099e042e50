#include "CommandLine.h"

#include <Eigen/Core>
#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/System.h>
#include <antinode_base/Watch.h>
#include <antinode_base/WholeFile.h>
#include <antinode_tasks/Field.h>
#include <juce_core/juce_core.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <vector>

namespace antinode
{
namespace
{
constexpr int done = 0, badInput = 1, wrongUsage = 2;

/** @return  the exit code of a program that a signal ended, as shells have it */
int sayInterrupted()
{
    constexpr int bySignal = 128;
    std::fputs ("Interrupted\n", stderr);
    return bySignal + interruptingSignal();
}

/** Commands, or the options of one, that may be meant by a word. */
std::vector<std::string> knownWords (const CLI::App& app, bool areOptions)
{
    std::vector<std::string> words;

    if (areOptions)
        for (const auto* const option : app.get_options())
            for (const auto& name : option->get_lnames())
                words.push_back ("--" + name);
    else
        for (const auto* const command : app.get_subcommands ([] (const CLI::App*) { return true; }))
            words.push_back (command->get_name());

    return words;
}

/** Where a command or an option is none, but near to one: a sentence, else empty. */
std::string meantInstead (const CLI::App& app)
{
    const auto chosen = app.get_subcommands();
    const auto* const command = chosen.empty() ? &app : chosen.front();

    for (const auto& word : command->remaining())
    {
        const auto given = word.substr (0, word.find ('='));
        const auto known = knownWords (*command, given.starts_with ("--"));

        if (const auto near = didYouMean (given, { known.begin(), known.end() }); ! near.empty())
            return inQuotes (given) + " is unknown" + near;
    }

    return {};
}

int complain (const char* text)
{
    std::fprintf (stderr, "antinode: %s\n", text);
    return badInput;
}

/** All commands, in the groups of --help. */
void addCommands (CLI::App& app)
{
    using Add = void (*) (CLI::App&);
    const std::vector<std::pair<std::string, std::vector<Add>>> groups {
        { "Design and play", { addRenderCommand, addDesignCommand, addPerformCommand } },
        { "Devices", { addDevicesCommand, addModesCommand, addPlaceCommand, addImportCommand } },
        { "Measure",
          { addExciteCommand, addMeasureCommand, addFrfCommand, addCalibrateCommand, addIdentifyCommand,
            addRetuneCommand, addHysteresisCommand } },
        { "Learn from plays", { addSensorsCommand, addLearnCommand, addFollowCommand } },
        { "Study", { addCompareCommand, addMapCommand, addSweepCommand } },
        { "About", { addVersionCommand } },
    };

    for (const auto& [name, commands] : groups)
        for (const auto add : commands)
        {
            add (app);
            app.get_subcommands ([] (const CLI::App*) { return true; }).back()->group (name);
        }

    addManualPageCommand (app);
}

int runCommand (int argumentCount, const char* const* arguments)
{
    CLI::App app ("Antinode: the voltages that focus the vibration of a surface at a chosen position and instant.",
                  "antinode");
    app.require_subcommand (1);
    app.footer ("Every command has --help. `antinode render` without arguments renders the embedded demonstrator.");
    addCommands (app);

    const WatchScope scope ([] { return ! isInterrupted(); });

    try
    {
        app.parse (argumentCount, arguments);
        return done;
    }
    catch (const Cancelled&)
    {
        return sayInterrupted();
    }
    catch (const CLI::Success& success) // --help
    {
        return app.exit (success);
    }
    catch (const CLI::ValidationError& error)
    {
        std::fprintf (stderr, "antinode: %s\n", error.what());
        return wrongUsage;
    }
    catch (const CLI::ParseError& error)
    {
        if (const auto meant = meantInstead (app); ! meant.empty())
            std::fprintf (stderr, "antinode: %s\n", meant.c_str());
        else
            app.exit (error, std::cout, std::cerr);

        return wrongUsage;
    }
    catch (const std::filesystem::filesystem_error& error)
    {
        return complain ((printable (error.path1().string(), 300) + ": " + error.code().message()).c_str());
    }
    catch (const std::bad_alloc&)
    {
        return complain ("not enough memory; choose a shorter duration, a lower sample rate or fewer modes");
    }
    catch (const std::exception& error)
    {
        return complain (withKeysAndOptions (error.what()).c_str());
    }
}
} // namespace

int runCommandLine (int argumentCount, const char* const* arguments)
{
    const auto code = runCommand (argumentCount, arguments);

    try
    {
        requireWholeOutput();
    }
    catch (const InputError& error)
    {
        return code == done ? complain (error.what()) : code;
    }

    return code;
}

namespace
{
/** Text as roff takes it. */
std::string roff (const std::string& text)
{
    std::string escaped;

    for (const auto letter : text)
        escaped += letter == '-' ? "\\-" : letter == '\\' ? "\\e" : std::string (1, letter);

    return escaped.starts_with ('.') || escaped.starts_with ('\'') ? "\\&" + escaped : escaped;
}

std::string optionInRoff (const CLI::Option& option)
{
    const auto name = roff ("--" + option.get_lnames().front());
    auto text = roff (option.get_description());

    if (! option.get_default_str().empty())
        text += "; default: " + roff (option.get_default_str());

    const auto head =
        option.get_expected_max() == 0 ? ".B " + name : ".BI " + name + " \" " + roff (option.get_type_name()) + "\"";
    return ".TP\n" + head + "\n" + text + ".\n";
}

/** A page in which each command has its prose, ".SS antinode NAME ...", with the options behind it, in the order of
   --help.
    @throws InputError  where one has no prose */
std::string wholePage (const CLI::App& app, const std::string& page)
{
    std::map<std::string, std::string> prose;
    std::istringstream lines (page);
    std::string line, head, tail, *part = &head;
    const std::string begin = ".SS antinode ";

    while (std::getline (lines, line))
    {
        if (line.starts_with (begin))
            part = &prose[line.substr (begin.size(), line.find (' ', begin.size()) - begin.size())];
        else if (line.starts_with (".SH") && part != &head)
            part = &tail;

        *part += line + "\n";
    }

    for (const auto* const command :
         app.get_subcommands ([] (const CLI::App* each) { return ! each->get_group().empty(); }))
    {
        if (! prose.contains (command->get_name()))
            throw InputError ("manual page", "does not describe the command '" + command->get_name() + "'");

        head += prose[command->get_name()];

        for (const auto* const option : command->get_options())
            if (! option->get_lnames().empty() && option->get_lnames().front() != "help")
                head += optionInRoff (*option);
    }

    return head + tail;
}
} // namespace

void addManualPageCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("manual-page", "Adds the options of all commands to a page for man")->group ({});
    auto file = std::make_shared<std::string>();
    command->add_option ("file", *file, "Page that describes each command")->required();
    command->callback ([&app, file]
                       { std::fputs (wholePage (app, readWholeFile (*file, { "a page for man" })).c_str(), stdout); });
}

void addVersionCommand (CLI::App& app)
{
    app.add_subcommand ("version", "Prints the version and the versions of the libraries")
        ->callback (
            []
            {
                std::printf ("antinode %s (JUCE %d.%d.%d, Eigen %d.%d.%d)\n", ANTINODE_VERSION, JUCE_MAJOR_VERSION,
                             JUCE_MINOR_VERSION, JUCE_BUILDNUMBER, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                             EIGEN_MINOR_VERSION);
            });
}
} // namespace antinode
