#include <Standalone/StandaloneHost.h>
#include <Standalone/StandaloneOptions.h>

#include "Support/BlockingActions.h"
#include "Support/LargestDevice.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/FingerFile.h>

#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <random>
#include <thread>

using namespace antinode;

TEST_CASE ("the program starts with the demonstrator, disarmed")
{
    StandaloneHost host (SettingsFile ({}), false);
    CHECK (host.processor().device()->description.name == "staple");
    CHECK (host.processor().focus()->description.name == "demonstrator");
    CHECK_FALSE (host.processor().parameters().arm().get());
    CHECK_FALSE (host.router().isMuted());
}

TEST_CASE ("what is changed is kept, and comes back disarmed")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "standalone.json";
    {
        StandaloneHost host (SettingsFile (path), true);
        host.processor().parameters().arm().setValueNotifyingHost (1);
        host.processor().parameters().find ("x")->setValueNotifyingHost (0.25F);
        host.processor().setMutes (0b101);
        host.setRouting (withOutput (straightRouting(), 0, 9));
    }
    StandaloneHost host (SettingsFile (path), true);
    CHECK (host.warning().isEmpty());
    CHECK_FALSE (host.processor().parameters().arm().get());
    CHECK (host.processor().parameters().find ("x")->getValue() == Approx (0.25));
    CHECK (host.processor().mutes() == 0b101);
    CHECK (host.settings().routing.outputs[0] == 9);
}

TEST_CASE ("a program without windows changes no settings")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "standalone.json";
    {
        StandaloneHost host (SettingsFile (path), false);
        host.setRouting (withOutput (straightRouting(), 0, 9));
    }
    CHECK_FALSE (std::filesystem::exists (path));
}

TEST_CASE ("a device that cannot be opened is a warning, and all else goes on")
{
    StandaloneHost host (SettingsFile ({}), false);
    auto wanted = host.settings();
    wanted.audio.type = "OSS";
    wanted.touch = { 0, 0, "127.0.0.1" };
    host.openAll (wanted);
    CHECK (host.warning() == "audio device type 'OSS': does not exist; available: ALSA, JACK");
    host.muteAll();
    CHECK (host.router().isMuted());
}

TEST_CASE ("touches rest as fingers of the focus while they last, and damp what plays")
{
    StandaloneHost host (SettingsFile ({}), false);
    host.processor().prepareToPlay (48000, 256);
    host.processor().session().waitUntilSettled();
    const auto fingers = [&] { return host.processor().focus()->description.fingers; };
    const Touch touch { TouchKind::rest, false, 0.25, 0.5, 1, 1 };
    host.touch().play (touch);
    CHECK (host.touch().unplayed().withoutKind == 1); // They play foci, by default.
    CHECK (host.touch().unplayed().notAccepted == 0);
    host.restTouches();
    CHECK (fingers().empty());

    host.setTouch ({ 0, 0, "127.0.0.1", "firm" });
    host.touch().play (touch);
    CHECK (host.touch().unplayed().withoutKind == 0);
    host.restTouches();
    REQUIRE (fingers().size() == 1);
    CHECK (fingers()[0].name == "firm");
    CHECK_FALSE (fingers()[0].isKnown);
    host.processor().session().waitUntilSettled();
    const auto now = host.processor().session().snapshot();
    CHECK (now->error.empty());
    CHECK (now->focusDocument->description.fingers == fingers());
    CHECK (fingers()[0].x == Approx (0.75 * now->model->surface.xMinimum + 0.25 * now->model->surface.xMaximum));

    // What is kept at any time has no touches, though the program may be killed at any time.
    CHECK (host.processor().state().focus->description.fingers.empty());
    host.shutDown();
    CHECK (fingers().empty());
}

TEST_CASE ("touches rest in what room the focus has, and come back after another one is loaded")
{
    StandaloneHost host (SettingsFile ({}), false);
    host.processor().prepareToPlay (48000, 256);
    host.processor().session().waitUntilSettled();
    const auto bare = host.processor().state().focus;
    std::vector<Finger> own;

    for (int i = 0; i < 9; ++i)
        own.push_back (builtInFinger ("light", -0.07 + 0.009 * i, 0));

    host.processor().setFingers (own);
    host.setTouch ({ 0, 0, "127.0.0.1", "light" });
    host.touch().play ({ TouchKind::rest, false, 0.8, 0.5, 1, 1 });
    host.touch().play ({ TouchKind::rest, false, 0.9, 0.5, 1, 2 });
    host.restTouches();
    CHECK (host.warning().isEmpty());
    CHECK (host.processor().focus()->description.fingers.size() == maximumFingers);
    CHECK (host.processor().touches().size() == 1);

    host.processor().load (nullptr, bare);
    CHECK (host.processor().touches().empty());
    std::this_thread::sleep_for (RestingTouches::pause + std::chrono::milliseconds (10));
    host.restTouches();
    CHECK (host.processor().touches().size() == 2);
    CHECK (host.processor().state().focus == bare);

    // The same state again, as undo sets it, leaves them where they are.
    host.processor().setState (host.processor().state(), false);
    CHECK (host.processor().touches().size() == 2);
}

TEST_CASE ("a program that plays foci listens to the first open input")
{
    StandaloneHost host (SettingsFile ({}), false);
    auto& session = host.processor().session();
    juce::BigInteger inputs;
    inputs.setBit (1);
    session.following().setSettings (readFollowing ("ceramic_current:8"));
    host.callback().prepare (48000, 256, {}, inputs);
    session.waitUntilSettled();

    // What is no number is never explained: the follower says so after a window.
    const std::vector<float> broken (4800, std::numeric_limits<float>::quiet_NaN());
    const std::array<const float*, 1> sources { broken.data() };

    for (int i = 0; i < 6000 && session.following().status()->state != FollowingState::lost; ++i)
    {
        host.callback().audioDeviceIOCallbackWithContext (sources.data(), 1, nullptr, 0, 4800, {});
        std::this_thread::sleep_for (std::chrono::milliseconds (20));
    }

    CHECK (session.following().status()->state == FollowingState::lost);
}

TEST_CASE ("who quits while a device is solved or a focus designed does not wait")
{
    test::BlockingTimes times;
    std::mt19937 random (3);

    for (int i = 0; i < test::blockingRounds (10); ++i)
    {
        auto host = std::make_unique<StandaloneHost> (SettingsFile ({}), false);
        const auto device = test::largestDevice (50 + i);
        host->processor().load (std::make_shared<const DeviceDocument> (readDeviceDocument (device, "device")),
                                nullptr);
        host->processor().prepareToPlay (48000, 256);
        std::this_thread::sleep_for (std::chrono::milliseconds (random() % 200));
        times.measure ("sample rate changed", [&] { host->processor().prepareToPlay (96000, 256); });
        times.measure ("quit", [&] { host.reset(); });
    }

    times.print();
    CHECK (times.longest() <= test::BlockingTimes::allowed());
}
