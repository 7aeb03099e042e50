#include "EditorFixture.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace antinode;

namespace
{
constexpr int maximum = AntinodeProcessor::maximumCeramics;

/** A plate with as many ceramics as there can be, in rows of eight. */
std::shared_ptr<const DeviceDocument> largestDevice()
{
    auto device = loadDocument (LibraryKind::device, "aluminium-200x120");
    auto ceramic = device["ceramics"][0];
    device["ceramics"] = nlohmann::json::array();
    ceramic["size_x_mm"] = 12;
    ceramic["size_y_mm"] = 8;

    for (int i = 0; i < maximum; ++i)
    {
        ceramic["name"] = "C" + std::to_string (i + 1);
        ceramic["x_mm"] = 8 + 24 * (i % 8);
        ceramic["y_mm"] = 4 + 14.5 * (i / 8);
        device["ceramics"].push_back (ceramic);
    }

    return std::make_shared<const DeviceDocument> (readDeviceDocument (device, "largest"));
}

std::shared_ptr<const FocusDocument> focusAtCentre()
{
    const auto focus = loadDocument (LibraryKind::focus, "aluminium-centre");
    return std::make_shared<const FocusDocument> (readFocusDocument (focus, "centre"));
}

/** What this thread has worked, ms: other programs do not count. */
double worked()
{
    timespec now {};
    clock_gettime (CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double> (now.tv_sec) + 1e-6 * static_cast<double> (now.tv_nsec);
}

/** What a window draws in one frame while a ceramic of the device is dragged. @return  ms of work */
double dragFrame (Editor& editor, juce::Image& image, juce::Point<float> to, juce::Point<float> from)
{
    const auto start = worked();
    auto& content = editor.content();
    auto& surface = content.deviceSurface();
    surface.mouseDrag (mouseAt (surface, to, from));
    content.refresh (1.0 / 60);
    juce::Graphics g (image);
    juce::RectangleList<int> changed (editor.getLocalArea (&surface, surface.getLocalBounds()));
    changed.add (editor.getLocalArea (&content.devicePanel(), content.devicePanel().getLocalBounds()));
    g.reduceClipRegion (changed);
    editor.paintEntireComponent (g, true);
    return worked() - start;
}

/** What a window draws in one frame while the field moves and voltages are put out. @return  ms of work */
double drawFrame (Editor& editor, juce::Image& image)
{
    const auto start = worked();
    auto& content = editor.content();
    content.refresh (1.0 / 60);
    juce::Graphics g (image);
    juce::RectangleList<int> changed (editor.getLocalArea (&content.surface(), content.surface().getLocalBounds()));
    changed.add (editor.getLocalArea (&content.metersStrip(), content.metersStrip().getLocalBounds()));
    g.reduceClipRegion (changed);
    editor.paintEntireComponent (g, true);
    return worked() - start;
}
} // namespace

TEST_CASE ("A device of 64 ceramics is shown with a meter each, and its field moves from frame to frame")
{
    AntinodeProcessor processor (maximum, juce::AudioProcessor::wrapperType_Undefined);
    processor.load (largestDevice(), focusAtCentre());
    processor.parameters().find ("notes")->setValueNotifyingHost (1);
    processor.prepareToPlay (EditorFixture::sampleRate, EditorFixture::blockSize);
    processor.session().waitUntilSettled();
    Editor editor (processor);

    while (! editor.content().isSettled())
    {
        std::this_thread::sleep_for (std::chrono::milliseconds (5));
        editor.content().refresh (0);
    }

    CHECK (editor.content().metersStrip().getNumChildComponents() == maximum);
    editor.content().timeline().setPlaying (true);

    for (const auto& [width, height] : { std::pair { 1280, 800 }, { 2560, 1440 } })
    {
        editor.setSize (width, height);
        juce::Image image (juce::Image::RGB, width, height, true, juce::SoftwareImageType());
        std::vector<double> times;
        drawFrame (editor, image);
        const auto before = image.createCopy();

        for (int i = 0; i < 30; ++i)
            times.push_back (drawFrame (editor, image));

        std::sort (times.begin(), times.end());
        std::printf ("editor with %d ceramics, %d x %d: a frame takes %.2f ms of work (median), %.2f ms (largest)\n",
                     maximum, width, height, times[times.size() / 2], times.back());
        const juce::Image::BitmapData one (before, juce::Image::BitmapData::readOnly),
            other (image, juce::Image::BitmapData::readOnly);
        CHECK_FALSE (std::equal (one.data, one.data + one.size, other.data, other.data + other.size));
    }
}

TEST_CASE ("While a ceramic is dragged its device is solved and shown again and again")
{
    AntinodeProcessor processor (16, juce::AudioProcessor::wrapperType_Undefined);
    processor.load (deviceDocument ("phone"), focusDocument ("phone-thumb"));
    processor.parameters().find ("notes")->setValueNotifyingHost (1);
    processor.prepareToPlay (EditorFixture::sampleRate, EditorFixture::blockSize);
    processor.session().waitUntilSettled();
    Editor editor (processor);
    auto& content = editor.content();
    auto& surface = content.deviceSurface();

    for (const auto& [width, height] : { std::pair { 1280, 800 }, { 2560, 1440 } })
    {
        editor.setSize (width, height);
        content.showPanel ("Device");
        test::refreshUntil (content, [&] { return content.isSettled(); });
        juce::Image image (juce::Image::RGB, width, height, true, juce::SoftwareImageType());
        editor.createComponentSnapshot (editor.getLocalBounds(), true, 1);
        const auto from = surface.middleOf (0);
        surface.mouseDown (mouseAt (surface, from));
        std::vector<double> times, solving;
        std::shared_ptr<const DraftPicture> before;
        auto pictures = 0;

        for (int i = 0; i < 30; ++i)
        {
            times.push_back (dragFrame (editor, image, from + juce::Point<float> (static_cast<float> (i), -40), from));
            std::this_thread::sleep_for (std::chrono::milliseconds (16));

            if (const auto shown = content.draftShown(); std::exchange (before, shown) != shown && ! shown->isExact)
            {
                ++pictures;
                solving.push_back (1e3 * shown->solveTime);
            }
        }

        surface.mouseUp (mouseAt (surface, from, from));
        std::sort (times.begin(), times.end());
        std::sort (solving.begin(), solving.end());
        REQUIRE (pictures > 0);
        std::printf ("a ceramic of the phone is dragged, %d x %d: a frame takes %.2f ms of work (median), %.2f ms "
                     "(largest); coarse modes in %.1f ms (median), %.1f ms (largest), %d pictures in 30 frames\n",
                     width, height, times[times.size() / 2], times.back(), solving[solving.size() / 2], solving.back(),
                     pictures);
        CHECK_FALSE (content.deviceDraft().isEdited());
    }
}
