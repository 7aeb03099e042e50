#include "Touch/OscWriter.h"

#include <Processor/AntinodeProcessor.h>
#include <Standalone/TouchInput.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
Surface makeSurface (double xMinimum, double xMaximum, double yMinimum, double yMaximum)
{
    Surface surface;
    surface.kind = SurfaceKind::plate;
    surface.xMinimum = xMinimum;
    surface.xMaximum = xMaximum;
    surface.yMinimum = yMinimum;
    surface.yMaximum = yMaximum;
    return surface;
}
} // namespace

TEST_CASE ("fractions of a surface are places between its edges, and 0 and 1 the very edges")
{
    const auto surface = makeSurface (-0.071, 0.103, 0.1, 0.3);
    const auto place = [&] (double x, double y) {
        return touchPlace ({ TouchKind::focusAt, false, x, y, 1 }, surface);
    };
    CHECK (place (0, 0) == std::pair (-0.071, 0.1));
    CHECK (place (1, 1) == std::pair (0.103, 0.3));
    CHECK (place (0.5, 0.25).first == Approx (0.016));
    CHECK (place (0.5, 0.25).second == Approx (0.15));
}

TEST_CASE ("millimetres are those of the surface's drawing")
{
    const auto place = touchPlace ({ TouchKind::focusAt, true, 24, -3.5, 1 }, makeSurface (-1, 1, -1, 1));
    CHECK (place.first == Approx (0.024));
    CHECK (place.second == Approx (-0.0035));
}

TEST_CASE ("a touch from the network plays a focus")
{
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
    processor.setRateAndBufferSizeDetails (48000, 256);
    processor.prepareToPlay (48000, 256);
    processor.session().waitUntilSettled();
    TouchInput touch (processor.session());
    touch.open ({ TouchPorts::anyFree, 0, "127.0.0.1" });
    REQUIRE (touch.ports().oscPort > 0);

    juce::DatagramSocket socket;
    const auto packet = test::OscWriter::message ("/antinode/touch", 0.66F, 0.5F);
    REQUIRE (socket.write ("127.0.0.1", touch.ports().oscPort, packet.data(), static_cast<int> (packet.size())) > 0);
    juce::AudioBuffer<float> buffer (10, 256);
    juce::MidiBuffer midi;

    for (int i = 0; i < 6000 && processor.session().meters().triggered() == 0; ++i)
    {
        processor.processBlock (buffer, midi);
        juce::Thread::sleep (10);
    }

    CHECK (processor.session().meters().triggered() == 1);
    touch.open ({ 0, 0, "127.0.0.1" });
    CHECK (touch.ports().oscPort == 0);
}

TEST_CASE ("touches outside the surface are counted until the ports are opened again")
{
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
    processor.prepareToPlay (48000, 256);
    processor.session().waitUntilSettled();
    TouchInput touch (processor.session());
    touch.play ({ TouchKind::focusAt, true, 500, 0, 1 });
    touch.play ({ TouchKind::focusAt, true, -75.1, 0, 1 });
    touch.play ({ TouchKind::focusAt, true, 24, 0, 1 });
    touch.play ({ TouchKind::stopAll, false, 0, 0, 0 });
    CHECK (touch.unplayed().outsideSurface == 2);
    CHECK (touch.unplayed().notAccepted == 0);
    touch.open ({ 0, 0, "127.0.0.1" });
    CHECK (touch.unplayed().outsideSurface == 0);
}
