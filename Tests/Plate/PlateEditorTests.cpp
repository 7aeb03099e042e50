#include "PlayedPlate.h"

#include <Plate/PlateContent.h>

#include <Support/EditorTools.h>

#include <catch2/catch.hpp>

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

TEST_CASE ("The plate's editor says which channels a device lacks", "[plate][editor]")
{
    const auto processor = offlinePlate (8, 48000, 480);
    PlateEditor editor (*processor);
    auto& content = editor.content();
    content.deviceButton().loadDocument ("glass-148x210");
    refreshUntil (content, [&] { return content.statusLine().text().contains ("ceramics"); });
}
