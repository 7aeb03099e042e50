#include "Standalone.h"

#include "ApplyOptions.h"
#include "HeadlessRun.h"
#include "WindowRun.h"

#include <antinode_audio/Interruption.h>
#include <antinode_audio/QuietLibraries.h>
#include <antinode_base/InputError.h>

#include <cstdio>
#include <exception>
#include <iostream>

namespace antinode
{
namespace
{
constexpr int done = 0, badInput = 1, wrongUsage = 2;

int complain (const std::string& text)
{
    std::fprintf (stderr, "antinode-standalone: %s\n", text.c_str());
    return badInput;
}

void listDevices()
{
    juce::AudioDeviceManager manager;

    for (const auto& type : deviceTypes (manager))
    {
        const auto names = outputDevices (manager, type);

        for (const auto& name : names)
            std::printf ("%s: %s\n", type.c_str(), name.c_str());

        if (names.empty())
            std::printf ("%s: none\n", type.c_str());
    }
}

void runHeadless (const StandaloneOptions& options)
{
    auto notes = readNotes (options);
    StandaloneHost host (chooseSettingsFile (options), false);

    if (const auto warning = host.warning(); warning.isNotEmpty())
        complain (warning.toStdString());

    loadDocuments (host, options);
    const auto settings = withOptions (host.settings(), options);
    HeadlessRun headless (host, std::move (notes), options.duration, options.isArmed);
    host.setTouch (settings.touch);
    host.setMidi (settings.midi);
    host.openAudio (settings.audio);
    headless.run();
}

void runWindow (const StandaloneOptions& options)
{
    StandaloneHost host (chooseSettingsFile (options), true);
    loadDocuments (host, options);
    host.openAll (withOptions (host.settings(), options));
    runWithWindow (host);
}

void run (const StandaloneOptions& options)
{
    const juce::ScopedJuceInitialiser_GUI juce;
    catchInterruptions();
    silenceAudioLibraries();

    if (options.listsDevices)
        listDevices();
    else if (options.isHeadless)
        runHeadless (options);
    else
        runWindow (options);
}
} // namespace

int runStandalone (int argumentCount, const char* const* arguments)
{
    CLI::App app ("Antinode as a standalone program: plays foci on the ceramics of any audio device.",
                  "antinode-standalone");
    app.footer ("It starts disarmed: all outputs stay at 0 V until they are armed.");
    StandaloneOptions options;
    addStandaloneOptions (app, options);

    try
    {
        app.parse (argumentCount, arguments);
        run (options);
        return done;
    }
    catch (const CLI::Success& success) // --help
    {
        return app.exit (success);
    }
    catch (const CLI::ParseError& error)
    {
        app.exit (error, std::cout, std::cerr);
        return wrongUsage;
    }
    catch (const std::exception& error)
    {
        return complain (error.what());
    }
}
} // namespace antinode
