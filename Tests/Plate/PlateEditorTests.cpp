#include "PlayedPlate.h"

#include <Plate/PlateContent.h>

#include <Support/BlockingActions.h>
#include <Support/EditorTools.h>
#include <Support/LargestDevice.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <random>
#include <thread>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("The plate's editor shows the surface at rest, then how it moved", "[plate][editor]")
{
    const auto device = GENERATE ("staple", "aluminium-200x120");
    const auto processor = offlinePlate (16, 48000, 480);
    processor->load (plateDevice (device));
    processor->session().waitUntilSettled();
    PlateEditor editor (*processor);
    auto& content = editor.content();
    refreshUntil (content, [&] { return content.picture() != nullptr; });
    CHECK (content.picture()->step == 0);
    CHECK (content.picture()->frames->largest == 0);
    moved (*processor, sines (16, 9600), 480);
    refreshUntil (content, [&] { return content.picture()->step > 0; });
    const auto& frames = *content.picture()->frames;
    CHECK (frames.available() == PlatePath::capturedFrames);
    CHECK (frames.largest > 0);
    CHECK (content.picture()->step * (PlatePath::capturedFrames - 1) == Approx (PlatePath::capturedSeconds));
    content.holdAt (60);
    const auto middle = editor.createComponentSnapshot (editor.getLocalBounds(), true, 1);
    content.holdAt (10);
    const auto early = editor.createComponentSnapshot (editor.getLocalBounds(), true, 1);
    CHECK (countColours (middle) > 40);
    CHECK (countColours (early) > 40);
}

TEST_CASE ("A probe that is dragged on the surface moves its parameters", "[plate][editor]")
{
    const auto processor = offlinePlate (16, 48000, 480);
    processor->load (plateDevice ("aluminium-200x120"));
    processor->session().waitUntilSettled();
    PlateEditor editor (*processor);
    auto& surface = editor.content().surface();
    refreshUntil (editor.content(), [&] { return editor.content().picture() != nullptr; });
    editor.createComponentSnapshot (editor.getLocalBounds(), true, 1); // It is laid out where it is painted.
    const auto from = surface.probe (3), to = from + juce::Point<float> (40, -30);
    surface.mouseDown (mouseAt (surface, from));
    surface.mouseDrag (mouseAt (surface, to));
    surface.mouseUp (mouseAt (surface, to));
    CHECK (surface.probe (3).getDistanceFrom (to) < 0.5F);
    CHECK (processor->parameters().probeX (3).get() > 50.0F);
    CHECK (processor->parameters().probeY (3).get() > 25.0F);
}

TEST_CASE ("The plate's editor says what is wrong in its status line", "[plate][editor]")
{
    const auto processor = offlinePlate (8, 48000, 480);
    PlateEditor editor (*processor);
    auto& content = editor.content();
    content.deviceButton().loadDocument ("no-such-device");
    content.refresh (0);
    CHECK (content.statusLine().text().contains ("no-such-device"));
    content.deviceButton().loadDocument ("glass-148x210");
    refreshUntil (content, [&] { return content.statusLine().text().contains ("ceramics"); });
}

TEST_CASE ("Closing Antinode Plate or its editor does not wait for what is computed", "[plate][editor][blocking]")
{
    BlockingTimes times;
    std::mt19937 random (3);

    for (int i = 0; i < blockingRounds (10); ++i)
    {
        auto processor = std::make_unique<PlateProcessor> (64, juce::AudioProcessor::wrapperType_Undefined);
        auto editor = std::make_unique<PlateEditor> (*processor);
        const auto device = i % 3 == 0 ? largestDevice (50 + i) : loadDocument (LibraryKind::device, "glass-148x210");
        processor->load (std::make_shared<const DeviceDocument> (readDeviceDocument (device, "device")));
        times.measure ("prepared", [&] { processor->prepareToPlay (48000, 512); });
        std::this_thread::sleep_for (std::chrono::milliseconds (random() % 200));
        editor->content().refresh (0.02);
        times.measure ("sample rate changed", [&] { processor->prepareToPlay (96000, 512); });
        times.measure ("editor closed", [&] { editor.reset(); });
        times.measure ("plug-in destroyed", [&] { processor.reset(); });
    }

    times.print();
    CHECK (times.longest() <= BlockingTimes::allowed());
}
