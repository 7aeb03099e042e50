#include <Standalone/Standalone.h>
#include <Standalone/StandaloneOptions.h>

#include "Support/ErrorText.h"

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
int run (std::vector<const char*> arguments)
{
    arguments.insert (arguments.begin(), "antinode-standalone");
    return runStandalone (static_cast<int> (arguments.size()), arguments.data());
}

std::string noteError (const std::string& note)
{
    StandaloneOptions options;
    options.notes = { note };
    return errorText ([&] { readNotes (options); });
}
} // namespace

TEST_CASE ("wrong usage of the standalone program ends with 2")
{
    CHECK (run ({ "--no-such-option" }) == 2);
    CHECK (run ({ "--note", "60" }) == 2);
    CHECK (run ({ "--headless", "--at", "1" }) == 2);
    CHECK (run ({ "--headless", "--rate", "12" }) == 2);
    CHECK (run ({ "--headless", "--channels", "0" }) == 2);
    CHECK (run ({ "--headless", "--no-settings", "--settings", "a.json" }) == 2);
    CHECK (run ({ "--help" }) == 0);
    CHECK (run ({ "--finger", "1:2" }) == 2);
    CHECK (run ({ "--inputs", "1" }) == 2);
    CHECK (run ({ "--touch", "--latency-ms", "7" }) == 2);
    CHECK (run ({ "--touch", "glass-148x210", "--focus", "glass-two" }) == 2);
    CHECK (run ({ "--headless", "--touch", "--note", "60" }) == 2);
    CHECK (run ({ "--headless", "--sensor-input", "0" }) == 2);
}

TEST_CASE ("the help of the standalone program names the types of audio devices of this system")
{
    CLI::App app;
    StandaloneOptions options;
    addStandaloneOptions (app, options);
    juce::AudioDeviceManager manager;
    juce::OwnedArray<juce::AudioIODeviceType> made;
    manager.createAudioDeviceTypes (made);
    REQUIRE (made.size() > 0);

    for (const auto* const type : made)
        CHECK (app.get_option ("--type")->get_description().find (type->getTypeName().toStdString())
               != std::string::npos);
}

TEST_CASE ("what the standalone program cannot have ends with 1")
{
    CHECK (run ({ "--headless", "--no-settings", "--note", "x" }) == 1);
    CHECK (run ({ "--headless", "--no-settings", "--midi-file", "/no/such/file" }) == 1);
    CHECK (run ({ "--headless", "--no-settings", "--focus", "no such focus" }) == 1);
    CHECK (run ({ "--headless", "--no-settings", "--osc-port", "0", "--tuio-port", "0", "--type", "OSS" }) == 1);
    CHECK (run ({ "--headless", "--no-settings", "--follow", "ear" }) == 1);
    CHECK (run ({ "--headless", "--no-settings", "--touch", "no such device" }) == 1);
    CHECK (run ({ "--headless", "--no-settings", "--touch", "--finger", "x" }) == 1);
    CHECK (run ({ "--headless", "--no-settings", "--touch", "--inputs", "1,2," }) == 1);
    CHECK (run ({ "--headless", "--no-settings", "--touch", "--follow", "velocity:0:0" }) == 1); // no --sensor-input
}

TEST_CASE ("notes are numbers with a velocity or without, at their times")
{
    StandaloneOptions options;
    options.notes = { "60", "127:1" };
    options.times = { 0.25 };
    const auto notes = readNotes (options);
    REQUIRE (notes.size() == 2);
    CHECK (notes[0].seconds == 0.25);
    CHECK (notes[0].message.getNoteNumber() == 60);
    CHECK (notes[0].message.getVelocity() == 127);
    CHECK (notes[1].seconds == 0);
    CHECK (notes[1].message.getVelocity() == 1);

    for (const auto* const wrong : { "", "x", "128", "-1", "60:", "60:0", "60:128", "60:1x", "60.5", "99999999999" })
        CHECK (noteError (wrong).find (std::string ("--note ") + wrong + ": ") == 0);
}

TEST_CASE ("fingers of options are places in mm, with a level in um or without")
{
    const auto finger = readFinger ("-24.5:7");
    CHECK (finger.x == Approx (-0.0245));
    CHECK (finger.y == Approx (0.007));
    CHECK (finger.level == 5e-6);
    CHECK (readFinger ("1:2:0").level == 0);
    CHECK (readFinger ("1:2:12.5").level == Approx (12.5e-6));

    for (const std::string wrong :
         { "", "1", "1:", ":1", "1:2:", "1:2:3:4", "1:2x", "nan:1", "inf:1", "1:2:-1", "1:2:101" })
        CHECK (errorText ([&] { readFinger (wrong); }).find ("--finger " + wrong + ": ") == 0);
}

TEST_CASE ("inputs of fingers are a list that counts from 1")
{
    const auto inputs = readFingerInputs ("3,0,128").inputs;
    CHECK (inputs[0] == 2);
    CHECK (inputs[1] == FingerInputs::none);
    CHECK (inputs[2] == 127);
    CHECK (inputs[3] == FingerInputs::none);
    CHECK (readFingerInputs ("1,2,3,4,5,6,7,8") == FingerInputs());

    for (const std::string wrong : { "", "x", "1,", ",1", "1;2", "-1", "129", "1,2,3,4,5,6,7,8,9", "1 ,2" })
        CHECK (errorText ([&] { readFingerInputs (wrong); }).find ("--inputs " + wrong + ": ") == 0);
}

TEST_CASE ("what tracks is a word with a place in mm, or with a ceramic that counts from 1")
{
    const auto place = readFollowing ("velocity:-24.5:7");
    CHECK (place.sensor == FollowingSensor::velocity);
    CHECK (place.xMillimetres == -24.5);
    CHECK (place.yMillimetres == 7);
    CHECK (readFollowing ("displacement:1e1:0").sensor == FollowingSensor::displacement);
    CHECK (readFollowing ("displacement:1e1:0").xMillimetres == 10);
    const auto ceramic = readFollowing ("ceramic_current:8");
    CHECK (ceramic.sensor == FollowingSensor::ceramicCurrent);
    CHECK (ceramic.ceramic == 7);
    CHECK (readFollowing ("ceramic_charge:64").sensor == FollowingSensor::ceramicCharge);
    CHECK (readFollowing ("ceramic_charge:64").ceramic == 63);
    CHECK (readFollowing ("none") == FollowingSettings());

    for (const std::string wrong : { "",
                                     ":",
                                     "ear",
                                     "none:1",
                                     "velocity",
                                     "velocity:",
                                     "velocity:1",
                                     "velocity:1:",
                                     "velocity:1:2:3",
                                     "velocity:1:x",
                                     "velocity:nan:1",
                                     "velocity:inf:1",
                                     "velocity:1;2",
                                     " velocity:1:2",
                                     "ceramic_current",
                                     "ceramic_current:0",
                                     "ceramic_current:-1",
                                     "ceramic_current:1.5",
                                     "ceramic_current:1:2",
                                     "ceramic_charge:65",
                                     "ceramic_charge:1e99" })
    {
        const auto text = errorText ([&] { readFollowing (wrong); });
        CHECK (text.find ("--follow " + wrong + ": ") == 0);
        CHECK (text.find ("allowed: velocity:X:Y") != std::string::npos);
    }
}

TEST_CASE ("who tracks opens the first input, unless another one is chosen or kept")
{
    StandaloneSettings settings;
    StandaloneOptions options;
    const auto inputs = [&] { return withOptions (settings, options).audio.inputs; };
    CHECK (inputs().empty());
    options.following = "none";
    CHECK (inputs().empty());
    options.following = "ceramic_current:8";
    CHECK (inputs() == std::vector { 0 });
    settings.audio.inputs = { 4 };
    CHECK (inputs() == std::vector { 4 });
    options.sensorInput = 3;
    CHECK (inputs() == std::vector { 2 });
    options.following.clear();
    CHECK (inputs() == std::vector { 2 });
}

TEST_CASE ("options take the place of settings")
{
    StandaloneSettings settings;
    settings.audio = { "ALSA", "card", 44100, 64, { 4 } };
    StandaloneOptions options;
    CHECK (withOptions (settings, options).audio == settings.audio);
    options.channels = 3;
    options.rate = 96000;
    CHECK (withOptions (settings, options).audio == AudioChoice { "ALSA", "card", 96000, 64, { 0, 1, 2 } });
    options.type = "JACK";
    CHECK (withOptions (settings, options).audio == AudioChoice { "JACK", "", 96000, 0, { 0, 1, 2 } });
    options.oscPort = 0;
    CHECK (withOptions (settings, options).touch.oscPort == 0);
    CHECK (withOptions (settings, options).touch.tuioPort == settings.touch.tuioPort);
    CHECK (withOptions (settings, options).touch.finger.empty());
    options.tuioCursors = "medium";
    CHECK (withOptions (settings, options).touch.finger == "medium");
    settings.touch.finger = "firm";
    options.tuioCursors = "foci";
    CHECK (withOptions (settings, options).touch.finger.empty());
}
