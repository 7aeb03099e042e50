#include "CommandLine.h"

#include "Commands.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/StandardStreams.h>
#include <antinode_base/Watch.h>
#include <antinode_tasks/FieldNames.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
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
        { "Study", { addMapCommand, addSweepCommand } },
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
} // namespace antinode
