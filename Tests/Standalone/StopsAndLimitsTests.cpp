#include "Touch/OscWriter.h"
#include "TouchPlugin/PlayedTouch.h"

#include <Standalone/StandaloneHost.h>
#include <antinode_audio/Interruption.h>
#include <antinode_documents/DeviceFile.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

using namespace antinode;
using test::OscWriter;
using namespace std::string_literals;

// What drives ceramics stops when it is told to and stays below every limit that was stated: all ways to stop and all
// ways to sum, by what comes out.
namespace
{
constexpr double drivenRate = 48000;
constexpr int drivenBlock = 256, drivenOutputs = 8, fadeSamples = 97; // 2 ms

/** V; 0: it says nothing. */
struct StatedLimits
{
    const char* lowestOf = "";
    double focus = 50, parameter = 0, ceramic = 150, device = 150, amplifier = 0;
};

juce::MidiMessage drivenNote (int number = 60)
{
    return juce::MidiMessage::noteOn (1, number, juce::uint8 (127));
}

/** The demonstrator as a device of modes, whose ceramics have limits of their own. */
std::shared_ptr<const DeviceDocument> deviceWith (const StatedLimits& limits)
{
    const auto staple = readDevice (loadDocument (LibraryKind::device, "staple"), "staple");
    auto json = nlohmann::json (modalDeviceToJson (solveDevice (staple, {}, true), ""));
    json["limits"] = { { "voltage_V", limits.device }, { "full_scale_V", 150 } };

    for (auto& ceramic : json["ceramics"])
        ceramic["voltage_limit_V"] = std::min (limits.ceramic, limits.device);

    return std::make_shared<const DeviceDocument> (readDeviceDocument (json, "device"));
}

std::shared_ptr<const FocusDocument> focusWith (const std::string& name, double limit)
{
    auto json = loadDocument (LibraryKind::focus, name);
    json["allocation"]["voltage_limit_V"] = limit;
    return std::make_shared<const FocusDocument> (readFocusDocument (json, name));
}

/** The program without an audio device, played block by block. */
struct DrivenProgram
{
    explicit DrivenProgram (const StatedLimits& limits = {}, std::vector<TimedNote> file = {})
        : fullScale (limits.amplifier > 0 ? limits.amplifier : 150)
    {
        auto& parameters = host.processor().parameters();
        host.processor().load (deviceWith (limits), focusWith ("demonstrator", limits.focus));
        parameters.find ("notes")->setValueNotifyingHost (1); // All play the focus at its own place.
        auto* const limit = parameters.find ("voltage_limit");
        limit->setValueNotifyingHost (limit->convertTo0to1 (static_cast<float> (limits.parameter)));
        auto routing = straightRouting();

        for (int i = 0; i < drivenOutputs; ++i)
            routing.chains[static_cast<std::size_t> (i)].voltsPerFullScale = limits.amplifier;

        host.setRouting (routing);
        juce::BigInteger open;
        open.setRange (0, drivenOutputs, true);
        callback.setSchedule (EventSchedule (std::move (file)));
        callback.prepare (drivenRate, drivenBlock, open, {});
        session().waitUntilSettled();
        parameters.arm().setValueNotifyingHost (1);
        play (2 * drivenBlock); // The ramp of arming.
    }

    Session& session() { return host.processor().session(); }
    std::int64_t triggered() { return session().meters().triggered(); }

    /** Samples that were clamped, of all ceramics. */
    std::int64_t limited()
    {
        std::int64_t all = 0;

        for (int i = 0; i < drivenOutputs; ++i)
            all += session().meters().limitedSamples (i);

        return all;
    }

    void send (const test::Packet& packet)
    {
        for (const auto& touch : messages.read (packet, {}, counters))
            host.touch().play (touch);
    }

    void sendFoci (int count)
    {
        for (int i = 0; i < count; ++i)
            send (OscWriter::message ("/antinode/focus", 24.0F - static_cast<float> (i) / 8));
    }

    /** @return  the largest voltage of all outputs, V */
    double play (int samples)
    {
        double largest = 0;

        for (int done = 0; done < samples; done += drivenBlock)
        {
            const auto count = std::min (drivenBlock, samples - done);
            std::array<std::array<float, drivenBlock>, drivenOutputs> played;
            std::array<float*, drivenOutputs> channels;
            std::transform (played.begin(), played.end(), channels.begin(), [] (auto& each) { return each.data(); });
            callback.audioDeviceIOCallbackWithContext (nullptr, 0, channels.data(), drivenOutputs, count, {});

            for (const auto& channel : played)
                for (int n = 0; n < count; ++n)
                    largest =
                        std::max (largest, std::abs (static_cast<double> (channel[static_cast<std::size_t> (n)])));
        }

        return largest * fullScale;
    }

    /** Until so many foci have begun, sample by sample, so that what is being designed begins almost at once.
        @return  as play() until just before the last of them */
    double playUntil (std::int64_t triggers)
    {
        double largest = 0;

        for (int look = 0; look < 5000; ++look)
        {
            const auto now = play (1);

            if (triggered() >= triggers)
                return largest;

            largest = std::max (largest, now);
            std::this_thread::sleep_for (std::chrono::milliseconds (2));
        }

        FAIL ("too few foci have begun");
        return largest;
    }

    StandaloneHost host { SettingsFile ({}), false };
    MidiQueue queue { session().stops() };
    AudioCallback callback { host.processor(), host.router(), queue,
                             PlayedLevels { [this] { return session().fullScaleVolts(); }, [] { return true; } } };
    TouchMessages messages;
    TouchCounters counters;
    double fullScale; ///< V of a sample of 1.0 at the outputs.
};

struct WayToStop
{
    std::string name;
    std::function<void (DrivenProgram&)> stop;
    bool isCommand = true; ///< Else it is a note, which comes with the next block and ends no file.
};

std::vector<WayToStop> waysToStop()
{
    const auto midi = [] (std::vector<juce::uint8> bytes)
    {
        return [bytes] (DrivenProgram& program)
        { program.queue.push (juce::MidiMessage (bytes.data(), static_cast<int> (bytes.size())), 0); };
    };
    return {
        { "/antinode/stop", [] (auto& program) { program.send (OscWriter::message ("/antinode/stop")); } },
        { "/antinode/stop now", [] (auto& program)
          { program.send (test::toPacket (std::string_view ("/antinode/stop\0\0,S\0\0now\0", 24))); } },
        { "Escape", [] (auto& program) { program.host.stopAll(); } },
        { "STOP", [] (auto& program) { program.session().stopAll(); } },
        { "MUTE ALL",
          [] (auto& program)
          {
              program.host.muteAll();
              program.host.router().release();
          } },
        { "reset", [] (auto& program) { program.host.processor().reset(); } },
        { "all notes off", midi ({ 0xb0, 123, 0 }), false },
        { "all sound off", midi ({ 0xb5, 120, 0 }), false },
        { "all notes off behind a full queue",
          [] (auto& program)
          {
              while (program.queue.push (drivenNote(), 0))
              {
              }

              program.queue.push (juce::MidiMessage::allNotesOff (1), 0);
          },
          false },
        { "system reset", midi ({ 0xff }), false },
    };
}
} // namespace

TEST_CASE ("Every way to stop voids all that was asked for before it, and what is asked for after it plays")
{
    const auto way = GENERATE (from_range (waysToStop()));
    INFO (way.name);
    std::vector<TimedNote> file;

    for (int i = 0; i < 20; ++i)
        file.push_back ({ 0.01 * i, drivenNote() });

    DrivenProgram program ({}, file);

    if (way.isCommand)
        program.callback.startSchedule();

    // Some play, others are at every place on the way to the outputs.
    for (int i = 0; i < 8; ++i)
        program.queue.push (drivenNote(), 0);

    CHECK (program.play (1000) > 1);
    program.queue.push (drivenNote(), 0);
    program.session().fire (1);
    program.sendFoci (16);
    way.stop (program);

    if (! way.isCommand)
        program.play (1);

    // As many may be asked for at once as if nothing had waited.
    const auto before = program.triggered();
    program.sendFoci (16);
    program.play (fadeSamples);
    REQUIRE (program.triggered() <= before + 16);

    if (program.triggered() == before)
        CHECK (program.playUntil (before + 1) == 0);

    program.playUntil (before + 16);
    CHECK (program.play (1500) > 1);
    CHECK (program.triggered() == before + 16);
    CHECK (program.host.touch().unplayed().notAccepted == 0);

    // Nor does a file go on.
    program.session().stopAll();
    program.play (fadeSamples);
    CHECK (program.play (static_cast<int> (0.25 * drivenRate)) == 0);
}

TEST_CASE ("A file of notes ends what it plays where it says so, and goes on")
{
    DrivenProgram program (
        {}, { { 0, drivenNote() }, { 0.01, juce::MidiMessage::allNotesOff (1) }, { 0.1, drivenNote() } });
    program.callback.startSchedule();
    CHECK (program.play (480) > 0.1);
    program.play (fadeSamples);
    CHECK (program.play (4800 - 480 - fadeSamples) == 0);
    CHECK (program.play (1500) > 1);
}

TEST_CASE ("The lowest of all stated limits holds at the outputs, whatever sums there, and what it cuts is counted")
{
    constexpr double lowest = 12; // V
    const auto limits = GENERATE (
        StatedLimits { "focus", 12, 0, 150, 150, 0 }, StatedLimits { "focus below the parameter", 12, 30, 150, 150, 0 },
        StatedLimits { "parameter", 50, 12, 150, 150, 0 }, StatedLimits { "ceramic", 50, 40, 12, 150, 0 },
        StatedLimits { "device", 50, 40, 150, 12, 0 }, StatedLimits { "amplifier", 50, 40, 150, 150, 12 });
    INFO (limits.lowestOf);
    std::vector<TimedNote> file;

    for (int i = 0; i < 24; ++i)
        file.push_back ({ 0.0001 * i, drivenNote (30 + i) });

    DrivenProgram program (limits, file);
    const auto tuio = [] (int session)
    {
        const auto message = [] (const auto&... arguments) { return OscWriter::message ("/tuio/2Dcur", arguments...); };
        return OscWriter::bundle ({ message ("alive"s, session),
                                    message ("set"s, session, 0.65F, 0.5F, 0.0F, 0.0F, 0.0F),
                                    message ("fseq"s, session) });
    };
    const std::vector<std::pair<std::string, std::function<void()>>> waysToSum {
        { "notes",
          [&]
          {
              for (int i = 0; i < 24; ++i)
                  program.queue.push (drivenNote (30 + i), 0);
          } },
        { "a file of notes", [&] { program.callback.startSchedule(); } },
        { "FIRE",
          [&]
          {
              for (int i = 0; i < 24; ++i)
                  program.session().fire (1);
          } },
        { "OSC", [&] { program.sendFoci (16); } },
        { "TUIO",
          [&]
          {
              for (int i = 1; i <= 16; ++i)
                  program.send (tuio (i));
          } }
    };
    std::int64_t counted = 0;

    for (const auto& [name, sum] : waysToSum)
    {
        INFO (name);
        const auto before = program.triggered();
        sum();
        auto largest = program.playUntil (before + 16);
        largest = std::max (largest, program.play (2000));
        CHECK (largest <= lowest * (1 + 1e-6));
        CHECK (largest >= lowest * (1 - 1e-6));
        const auto limited = program.limited();
        CHECK (limited > std::exchange (counted, limited));
        program.session().stopAll();
        program.play (fadeSamples);
        CHECK (program.play (1000) == 0);
    }

    // Counts are of the run: another path, as for another device or a finger, begins none of them again.
    const auto before = program.triggered();
    program.host.processor().load (deviceWith ({}), nullptr);
    program.session().waitUntilSettled();
    program.play (2000);
    CHECK (program.triggered() == before);
    CHECK (program.limited() >= counted);
    program.queue.push (drivenNote(), 0);
    program.play (1000);
    CHECK (program.triggered() == before + 1);
}

TEST_CASE (
    "Tracks and foci of Antinode Touch keep the focus's limit, and foci that wait for their time are void by a stop")
{
    constexpr int ceramics = 12, latency = 960;
    constexpr double limit = 20; // V
    const auto isLoud = GENERATE (true, false);
    auto parameters = test::threeFingers();
    parameters["finger1_level"] = 100;
    const auto processor = test::offlineTouch (ceramics, drivenRate, drivenBlock, parameters);
    processor->loadFocus (focusWith ("aluminium-centre", limit));
    const auto play = [&] (int samples, const std::vector<test::PlayedNote>& notes)
    {
        const Eigen::MatrixXd inputs =
            isLoud ? test::fingerTones (2, samples, drivenRate) : Eigen::MatrixXd (Eigen::MatrixXd::Zero (2, samples));
        return 150 * test::voltagesOf (*processor, inputs, drivenBlock, notes).cwiseAbs().maxCoeff();
    };
    const auto model = processor->session().snapshot()->model;
    REQUIRE (model->fullScaleVoltage == 150);
    std::vector<test::PlayedNote> notes;

    for (int i = 0; i < 24; ++i)
        notes.push_back ({ i, 60, 127 });

    const auto largest = play (4800, notes);
    CHECK (largest <= limit * (1 + 1e-6));
    CHECK (largest >= limit * (1 - 1e-6));

    if (isLoud)
        return;

    const auto midi = [&] (const juce::MidiMessage& message)
    {
        juce::AudioBuffer<double> buffer (std::max (processor->getTotalNumInputChannels(), ceramics), 1);
        buffer.clear();
        juce::MidiBuffer messages (message);
        processor->processBlock (buffer, messages);
    };
    const std::vector<std::pair<std::string, std::function<void()>>> ways {
        { "all notes off", [&] { midi (juce::MidiMessage::allNotesOff (1)); } },
        { "all sound off", [&] { midi (juce::MidiMessage::allSoundOff (1)); } },
        { "reset", [&] { processor->reset(); } },
        { "/antinode/stop", [&] { processor->network().take ({ TouchKind::stopAll }); } },
        { "Escape", [&] { processor->stopAll(); } }
    };

    for (const auto& [name, stop] : ways)
    {
        INFO (name);
        play (2 * latency, notes);
        play (latency / 2, notes);
        stop();
        play (drivenBlock, {}); // The fade.
        CHECK (play (4 * latency, {}) == 0);
        play (latency, notes);
        CHECK (play (2 * latency, {}) > 1);
    }
}

TEST_CASE ("A device that stops to call is seen after three seconds, and when it calls again")
{
    DeviceWatch watch;
    CHECK_FALSE (watch.look (0, 100000)); // None is open.
    watch.begin (4294966000U);            // The clock wraps on the way.
    CHECK_FALSE (watch.look (256, 4294966500U));
    CHECK_FALSE (watch.look (256, 2204));
    CHECK_FALSE (watch.hasStopped());
    CHECK (watch.look (256, 2205));
    CHECK (watch.hasStopped());
    CHECK_FALSE (watch.look (256, 9000));
    CHECK (watch.look (512, 9001));
    CHECK_FALSE (watch.hasStopped());
    CHECK (watch.look (512, 12002));
    watch.end();
    CHECK_FALSE (watch.hasStopped());
}

TEST_CASE (
    "Each signal that would end the program is only noted, so that outputs ramp first, and what nohup ignores stays "
    "ignored")
{
    const auto noted = [] (int signal, bool isIgnored)
    {
        const auto child = fork();

        if (child == 0)
        {
            sigset_t none;
            sigemptyset (&none);
            sigprocmask (SIG_SETMASK, &none, nullptr); // Libraries of audio block some.
            std::signal (signal, isIgnored ? SIG_IGN : SIG_DFL);
            catchInterruptions();
            protectRamps();
            raise (signal);
            _exit (isInterrupted() && interruptingSignal() == signal ? 0 : 1);
        }

        int status = 0;
        waitpid (child, &status, 0);
        return WIFEXITED (status) && WEXITSTATUS (status) == 0;
    };

    for (const auto signal : { SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGUSR1, SIGUSR2, SIGALRM })
    {
        INFO (signal);
        CHECK (noted (signal, false));
    }

    CHECK_FALSE (noted (SIGHUP, true));
    CHECK (noted (SIGINT, true)); // As the shell has it for programs in the background, where a person sends it.
}
