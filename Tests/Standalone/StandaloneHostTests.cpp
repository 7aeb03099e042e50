#include <Standalone/StandaloneHost.h>

#include "Support/BlockingActions.h"
#include "Support/LargestDevice.h"
#include "Support/TemporaryFolder.h"

#include <catch2/catch.hpp>

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
