#include <Standalone/StandaloneHost.h>
#include <Standalone/TouchHost.h>

#include "Support/JuceMessages.h"
#include "Support/TemporaryFolder.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <fstream>
#include <thread>

using namespace antinode;
using namespace std::string_literals;

namespace
{
/** A host without a device whose blocks are played by hand, and a sender. */
template <typename Host = StandaloneHost>
struct Rig
{
    explicit Rig (bool arms = false) : control (std::make_shared<RemoteControl> (host, host.remotePlayer(), arms))
    {
        host.processor().prepareToPlay (48000, 256);
        host.processor().session().waitUntilSettled();
        host.processor().parameters().arm().setValueNotifyingHost (1);
        play();
    }

    void play()
    {
        juce::AudioBuffer<float> buffer (80, 256);
        juce::MidiBuffer midi;
        buffer.clear();
        host.processor().processBlock (buffer, midi);
    }

    void say (const std::string& address, std::vector<OscArgument> arguments)
    {
        control->take ({ "/antinode/" + address, std::move (arguments) }, { "127.0.0.1", 5000 });
    }

    /** The arguments of the answer to a request, once it is there. */
    std::vector<OscArgument> hear (const std::string& id, const std::string& kind)
    {
        for (int i = 0; i < 6000; ++i)
        {
            for (const auto& answer : control->answers())
                heard.push_back (answer);

            for (const auto& [to, message] : heard)
                if (message.address == "/antinode/" + kind && message.arguments.at (0) == OscArgument (id))
                    return { message.arguments.begin() + 1, message.arguments.end() };

            while (test::answerNextMessage())
                ;
            play();
            std::this_thread::sleep_for (std::chrono::milliseconds (2));
        }

        FAIL ("no answer " << kind << " to " << id);
        return {};
    }

    std::string refused (const std::string& id) { return std::get<std::string> (hear (id, "refused").at (0)); }

    Host host { SettingsFile ({}), false };
    std::shared_ptr<RemoteControl> control;
    std::vector<OscAnswer> heard;
};
} // namespace

TEST_CASE ("A place is prepared and played, and every step is told")
{
    Rig<> rig;
    rig.say ("prepare", { "left"s, -24.0F, "#1"s });
    CHECK (rig.hear ("#1", "accepted").at (0) == OscArgument ("/antinode/prepare"s));
    const auto designed = rig.hear ("#1", "designed");
    CHECK (designed.at (0) == OscArgument ("left"s));
    CHECK (std::get<double> (designed.at (1)) > 5);   // V
    CHECK (std::get<double> (designed.at (2)) > 0.9); // captured
    CHECK (std::get<double> (designed.at (3)) > 10);  // dB SL
    CHECK (std::get<double> (designed.at (4)) == 0.025);
    rig.say ("play", { "left"s, 0.5F, "#2"s });
    const auto playing = rig.hear ("#2", "playing");
    CHECK (std::get<std::int64_t> (playing.at (2)) - std::get<std::int64_t> (playing.at (1))
           == Approx (1200).margin (3));
    const auto finished = rig.hear ("#2", "finished");
    CHECK (std::get<double> (finished.at (1)) == Approx (0.5 * std::get<double> (designed.at (1))).epsilon (0.02));
    CHECK (finished.at (4) == OscArgument ("finished"s));
}

TEST_CASE ("What cannot be done is refused by a sentence, with the request's own number")
{
    Rig<> rig;
    rig.say ("play", { "left"s, "#a"s });
    CHECK (rig.refused ("#a") == "/antinode/play: 'left': was not prepared; prepare it with '/antinode/prepare'");
    rig.say ("bogus", { "#b"s });
    CHECK_THAT (rig.refused ("#b"), Catch::StartsWith ("/antinode/bogus: is no command"));
    rig.say ("prepare", { "far"s, 1000.0, "#c"s });
    CHECK (rig.refused ("#c") == "focus: target 1 x: is 1000 mm, which is outside the surface; allowed: -75 to 75 mm");
    rig.say ("prepare", { "far"s, "text"s, 1, 2, "#d"s });
    CHECK_THAT (rig.refused ("#d"), Catch::Contains ("is no finite number"));
    rig.say ("prepare", { "x"s, 1.0, "width_mm"s, "wide"s, "#e"s });
    CHECK_THAT (rig.refused ("#e"), Catch::Contains ("width_mm"));
    rig.say ("load", { "nothere"s, "#f"s });
    CHECK_THAT (rig.refused ("#f"), Catch::StartsWith ("device 'nothere'"));
    rig.say ("play", {});
    CHECK (rig.refused ("#1") == "/antinode/play: has 0 arguments; allowed: 1 to 3");
    rig.say ("arm", { 1, "#g"s });
    CHECK_THAT (rig.refused ("#g"), Catch::Contains ("--allow-remote-arm"));
    rig.say ("play", { "x"s, std::numeric_limits<float>::quiet_NaN(), "#h"s });
    CHECK_THAT (rig.refused ("#h"), Catch::Contains ("is no finite number"));
}

TEST_CASE ("Outputs that are not armed play nothing for a script")
{
    Rig<> rig (true);
    rig.say ("prepare", { "left"s, -24.0F, "#1"s });
    rig.hear ("#1", "designed");
    rig.say ("arm", { 0, "#2"s });
    rig.hear ("#2", "accepted");
    CHECK_FALSE (rig.host.processor().parameters().arm().get());
    rig.say ("play", { "left"s, "#3"s });
    CHECK_THAT (rig.refused ("#3"), Catch::Contains ("not armed"));
    rig.say ("arm", { 1, "#4"s });
    rig.hear ("#4", "accepted");
    CHECK (rig.host.processor().parameters().arm().get());
}

TEST_CASE ("Keys of the focus and devices are set from outside, and told when they play")
{
    Rig<> rig;
    rig.say ("set", { "peak_velocity_mm_s"s, 20, "#1"s });
    rig.hear ("#1", "loaded");
    CHECK (rig.host.processor().session().snapshot()->focus.targets.front().peakVelocity == 0.02);
    rig.say ("set", { "targets.0.width_mm"s, -5, "#2"s });
    CHECK_FALSE (rig.refused ("#2").empty());
    rig.host.processor().parameters().find ("voltage_limit")->setValueNotifyingHost (0.01F);
    rig.say ("load", { "beam"s, "#3"s });
    CHECK (rig.hear ("#3", "loaded").at (0) == OscArgument ("beam"s));
    CHECK_FALSE (rig.host.processor().parameters().arm().get()); // Another device has other limits.
    CHECK (rig.host.processor().parameters().find ("voltage_limit")->getValue()
           == Approx (0.01F)); // The lower one stays.
    rig.say ("status", { "#4"s });
    const auto status = rig.hear ("#4", "status");
    CHECK (status.at (0) == OscArgument ("device"s));
    CHECK (status.at (1) == OscArgument ("beam"s));
}

TEST_CASE ("Subscribers hear of what changes, and answers go to the port that a sender names")
{
    Rig<> rig;
    rig.say ("reply", { 6000, "#1"s });
    rig.say ("subscribe", { "#2"s });
    rig.hear ("#2", "status");
    CHECK (rig.heard.back().to.port == 6000);
    rig.host.processor().parameters().arm().setValueNotifyingHost (0);
    const auto status = rig.hear ("#status", "status");
    CHECK (status.at (0) == OscArgument ("device"s));
}

TEST_CASE ("A stop ends what a script plays")
{
    Rig<> rig;
    rig.say ("prepare", { "left"s, -24.0F, "#1"s });
    rig.hear ("#1", "designed");
    rig.say ("play", { "left"s, 1.0, "#2"s });
    rig.hear ("#2", "playing");
    rig.host.stopAll();
    CHECK (rig.hear ("#2", "finished").at (4) == OscArgument ("stopped"s));
}

TEST_CASE ("The program that plays fingers takes the same commands: foci play on top of them")
{
    Rig<TouchHost> rig;
    rig.say ("prepare", { "left"s, -24.0F, "#1"s });
    CHECK_THAT (rig.refused ("#1"), Catch::Contains ("none is loaded"));
    rig.say ("load", { "staple"s, "demonstrator"s, "#2"s });
    CHECK (rig.hear ("#2", "loaded").at (1) == OscArgument ("demonstrator"s));
    CHECK_FALSE (rig.host.arm().get());
    rig.host.arm().setValueNotifyingHost (1);
    rig.say ("prepare", { "left"s, -24.0F, "peak_level_dB_SL"s, 20, "#3"s });
    CHECK (std::get<double> (rig.hear ("#3", "designed").at (3)) == Approx (20).margin (0.05));
    rig.say ("play", { "left"s, 1.0, "#4"s });
    rig.hear ("#4", "playing");
    rig.host.stopAll();
    CHECK (rig.hear ("#4", "finished").at (4) == OscArgument ("stopped"s));
}
