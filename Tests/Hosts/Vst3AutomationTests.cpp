#include "RawVst3.h"

#include <catch2/catch.hpp>

#include <limits>
#include <random>
#include <string>

// Whatever comes with a block: values and events at random, and such as no host should send.

using namespace antinode::test;

namespace
{
constexpr double loudest = 1 + 1e-6; // of a ceramic: full scale is the device's limit
constexpr int noteEvery = 2000;

} // namespace

TEST_CASE ("Whatever a host automates, voltages stay finite and within full scale", "[vst3]")
{
    const auto isDouble = GENERATE (false, true);
    const auto isOffline = GENERATE (false, true);
    RawVst3 plugin (8);
    std::mt19937 random (17);
    const auto parameters = plugin.parameters();
    plugin.activate ({ 48000, 512, isOffline, isDouble });
    const auto monitorGain = plugin.parameter (u"Monitor gain");
    const auto played = plugin.play (isOffline ? 24 * 512 : 600 * 512, 512,
                                     [&] (Vst3Block& block)
                                     {
                                         for (const auto& parameter : parameters)
                                             for (int point = 0; point < 3; ++point)
                                                 block.changes.add (parameter.id, 200 * point,
                                                                    static_cast<double> (random() % 1001) / 1000);

                                         if (isOffline || block.start % noteEvery < 512)
                                             block.events.events.push_back (noteOn (static_cast<int> (random() % 512),
                                                                                    static_cast<int> (random() % 128)));

                                         block.changes.add (monitorGain, 511, 0.5);
                                     });
    CHECK (played.allFinite());
    CHECK (played.topRows (8).cwiseAbs().maxCoeff() <= loudest);
}

TEST_CASE ("Values that are no numbers do no harm", "[vst3]")
{
    RawVst3 plugin (8);
    plugin.activate ({ 48000, 512, true, false });
    const auto before = plugin.state();
    const auto bad = GENERATE (std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), 1e30, -1e30);
    CAPTURE (bad);
    const auto played = plugin.play (4096, 512,
                                     [&] (Vst3Block& block)
                                     {
                                         for (const auto& parameter : plugin.parameters())
                                             block.changes.add (parameter.id, 0, bad);

                                         block.events.events.push_back (noteOn (0, 60));
                                     });
    CHECK (played.allFinite());
    CHECK (played.topRows (8).cwiseAbs().maxCoeff() <= loudest);
    plugin.deactivate();
    const auto harmed = plugin.state();
    CHECK (harmed.find ("null") == std::string::npos);
    plugin.setState (before);
    CHECK ((plugin.state() == before));
    plugin.setState (harmed);
    CHECK ((plugin.state() == harmed));
    plugin.setState (before);
    plugin.activate ({ 48000, 512, true, false });
    CHECK (plugin.isPlaying());
}

TEST_CASE ("Events out of their block, off the keys or of other kinds do no harm", "[vst3]")
{
    RawVst3 plugin (8);
    plugin.activate ({ 48000, 512, true, false });
    const auto played =
        plugin.play (16 * 512, 512,
                     [&] (Vst3Block& block)
                     {
                         auto& events = block.events.events;

                         for (const auto offset : { -5, 0, 511, 512, 100000 })
                             for (const auto note : { -1, 0, 60, 127, 128, 32767 })
                                 events.push_back (noteOn (offset, note, 1.5F));

                         for (int type = 0; type < 12; ++type)
                         {
                             auto& event = events.emplace_back();
                             event = noteOn (3, 60);
                             event.type = static_cast<Steinberg::uint16> (type == Vst::Event::kDataEvent ? 0 : type);
                         }
                     });
    CHECK (played.allFinite());
    CHECK (played.topRows (8).cwiseAbs().maxCoeff() <= loudest);
}
