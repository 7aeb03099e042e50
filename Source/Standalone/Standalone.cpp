#include "Standalone.h"

#include "HeadlessRun.h"
#include "MainWindow.h"
#include "StandaloneOptions.h"

#include <antinode_audio/Interruption.h>
#include <antinode_audio/QuietLibraries.h>
#include <antinode_base/InputError.h>
#include <antinode_base/System.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <utility>

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

/** @param load     takes what the options say over the settings
    @param makeRun  makes a run of a host whose device is not open yet */
template <typename Host, typename Load, typename MakeRun>
void runHeadless (const StandaloneOptions& options, const Load& load, const MakeRun& makeRun)
{
    Host host (chooseSettingsFile (options), false);

    if (const auto warning = host.warning(); warning.isNotEmpty())
        complain (warning.toStdString());

    load (host, options);
    const auto settings = withOptions (host.settings(), options);
    auto headless = makeRun (host);
    host.setTouch (settings.touch);

    if (host.playsFoci())
        host.setMidi (settings.midi);

    host.openAudio (settings.audio);
    headless->run();
}

void runFociHeadless (const StandaloneOptions& options)
{
    auto notes = readNotes (options);
    runHeadless<StandaloneHost> (
        options, loadDocuments,
        [&] (StandaloneHost& host)
        { return std::make_unique<FociRun> (host, std::move (notes), options.duration, options.isArmed); });
}

void runTouchHeadless (const StandaloneOptions& options)
{
    runHeadless<TouchHost> (options, loadFingers,
                            [&] (TouchHost& host)
                            { return std::make_unique<TouchRun> (host, options.duration, options.isArmed); });
}

/** @param load  takes what the options say over the settings */
template <typename Host, typename Load>
void runWindow (const StandaloneOptions& options, const Load& load)
{
    Host host (chooseSettingsFile (options), true);
    load (host, options);
    host.openAll (withOptions (host.settings(), options));
    runWithWindow ([&host] { return std::make_unique<MainComponent> (host); });
}

void run (const StandaloneOptions& options)
{
    const juce::ScopedJuceInitialiser_GUI juce;
    catchInterruptions();
    protectRamps();
    silenceAudioLibraries();

    if (options.listsDevices)
        listDevices();
    else if (options.isHeadless)
        options.playsTouch ? runTouchHeadless (options) : runFociHeadless (options);
    else if (options.playsTouch)
        runWindow<TouchHost> (options, loadFingers);
    else
        runWindow<StandaloneHost> (options, loadDocuments);
}
} // namespace

int runStandalone (int argumentCount, const char* const* arguments)
{
    CLI::App app (
        "Antinode as a standalone program: plays foci, or with --touch a waveform for each finger, on the ceramics "
        "of any audio device.",
        "antinode-standalone");
    app.footer ("It starts disarmed: all outputs stay at 0 V until they are armed.");
    StandaloneOptions options;
    addStandaloneOptions (app, options);

    try
    {
        app.parse (argumentCount, arguments);
        run (options);
        requireWholeOutput();
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
