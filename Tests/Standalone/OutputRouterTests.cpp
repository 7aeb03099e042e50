#include "RouterRig.h"
#include "Support/AllocationCount.h"

#include <antinode_audio/IdentifyTone.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace antinode;
using namespace antinode::test;

namespace
{
Channels noise (int channels, int count, float largest)
{
    std::mt19937 random (7);
    std::uniform_real_distribution<float> values (-largest, largest);
    auto samples = constant (channels, count, 0);

    for (auto& channel : samples)
        for (auto& sample : channel)
            sample = values (random);

    return samples;
}

float absolutePeak (const std::vector<float>& samples)
{
    float peak = 0;

    for (const auto sample : samples)
        peak = std::max (peak, std::abs (sample));

    return peak;
}
} // namespace

TEST_CASE ("each output gives its ceramic's samples, to the bit, and the others nothing")
{
    RouterRig rig;
    const auto ceramics = noise (3, 500, 1);
    rig.route (withOutput (straightRouting(), 0, 4));
    const auto played = rig.play (ceramics, 6);
    CHECK (played[4] == ceramics[0]);
    CHECK (played[1] == ceramics[1]);
    CHECK (played[2] == ceramics[2]);

    for (const auto silent : { 0, 3, 5 })
        CHECK (absolutePeak (played[static_cast<std::size_t> (silent)]) == 0);
}

TEST_CASE ("an amplifier of other volts per full scale and the other polarity gives the same volts")
{
    RouterRig rig;
    auto routing = straightRouting();
    routing.chains[1] = { 600, -1 };
    rig.route (routing);
    const auto played = rig.play (constant (2, 300, 0.5F), 2);
    CHECK (played[0].back() == 0.5F);
    CHECK (played[1].back() * -600 == Approx (0.5 * RouterRig::fullScale));
}

TEST_CASE ("what an output cannot give is held at full scale and counted")
{
    RouterRig rig;
    auto routing = straightRouting();
    routing.chains[0].voltsPerFullScale = 50; // a tripled sample
    rig.route (routing);
    auto ceramics = constant (2, 300, 0.3F);
    ceramics[0][100] = 0.4F;
    ceramics[0][101] = -0.9F;
    ceramics[1][7] = 1.5F;
    const auto played = rig.play (ceramics, 2);
    CHECK (played[0][100] == 1.0F);
    CHECK (played[0][101] == -1.0F);
    CHECK (played[1][7] == 1.0F);
    CHECK (rig.router.meters().clampedSamples (0) == 2);
    CHECK (rig.router.meters().clampedSamples (1) == 1);
    CHECK (rig.router.meters().takePeak (0) == 1.0F);
    CHECK (rig.router.meters().takePeak (0) == 0.0F);
}

TEST_CASE ("mute all ramps every output to 0 V in 5 ms and holds it until it is released")
{
    RouterRig rig;
    const auto ceramics = constant (2, 1000, 0.8F), monitor = constant (2, 1000, 0.8F);
    rig.route (withMonitor (straightRouting(), 2));
    rig.play (ceramics, 4, { 100 }, monitor);
    rig.router.muteAll();
    auto played = rig.play (ceramics, 4, { 64 }, monitor);

    for (const auto& output : played)
    {
        for (std::size_t n = 1; n < RouterRig::rampSamples; ++n)
            CHECK ((output[n] < output[n - 1] && output[n - 1] - output[n] < 0.004F));

        CHECK (output[RouterRig::rampSamples - 2] > 0);
        CHECK (absolutePeak ({ output.begin() + RouterRig::rampSamples - 1, output.end() }) == 0);
    }

    CHECK (rig.router.isSilent());
    CHECK (absolutePeak (rig.play (ceramics, 4, { 64 }, monitor)[0]) == 0);
    rig.router.release();
    CHECK (rig.play (ceramics, 4, { 64 }, monitor)[3].back() == 0.8F);
    CHECK_FALSE (rig.router.isSilent());
}

TEST_CASE ("a mute outlives a device that is opened anew")
{
    RouterRig rig;
    rig.router.muteAll();
    rig.router.prepare (96000);
    CHECK (absolutePeak (rig.play (constant (1, 2000, 0.8F), 1)[0]) == 0);
    CHECK (rig.router.isSilent());
}

TEST_CASE ("the identify tone is 5 percent of the ceramic's limit and 5 V at most, on that ceramic alone")
{
    const auto [limit, volts] = GENERATE (std::pair (40.0, 2.0), std::pair (100.0, 5.0), std::pair (150.0, 5.0));
    RouterRig rig;
    rig.route (straightRouting(), { limit, limit, limit });
    rig.router.identify (1);
    const auto played = rig.play (constant (3, 48000, 0.5F), 3);
    const std::vector<float> tone (played[1].begin() + 2 * RouterRig::rampSamples, played[1].end());
    CHECK (static_cast<double> (absolutePeak (tone)) * RouterRig::fullScale == Approx (volts).epsilon (0.01));
    CHECK (static_cast<double> (absolutePeak (tone)) * RouterRig::fullScale <= volts * (1 + 1e-6));
    CHECK (absolutePeak ({ played[0].begin() + RouterRig::rampSamples, played[0].end() }) == 0);

    rig.router.identify (OutputRouting::none);
    CHECK (rig.play (constant (3, 1000, 0.5F), 3)[2].back() == 0.5F);
}

TEST_CASE ("the identify tone keeps to its volts whatever the amplifier")
{
    RouterRig rig;
    auto routing = straightRouting();
    routing.chains[0] = { 20, -1 };
    rig.route (routing, { 200 });
    rig.router.identify (0);
    const auto played = rig.play (constant (1, 48000, 0), 1);
    CHECK (absolutePeak (played[0]) * 20 == Approx (5).epsilon (0.01));
}

TEST_CASE ("there is no identify tone while disarmed, or without a known limit")
{
    RouterRig rig;
    rig.router.identify (0);
    CHECK (absolutePeak (rig.play (constant (1, 48000, 0), 1)[0]) == 0);
    rig.route (straightRouting(), { 100 });
    rig.isArmed = false;
    CHECK (absolutePeak (rig.play (constant (1, 48000, 0), 1)[0]) == 0);
}

TEST_CASE ("nothing that is not finite reaches an output, and it mutes all of them")
{
    for (const auto bad : { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() })
    {
        RouterRig rig;
        auto ceramics = constant (2, 1000, 0.5F);
        ceramics[0][300] = ceramics[0][301] = ceramics[1][900] = bad;
        const auto played = rig.play (ceramics, 2, { 128 });

        for (const auto& output : played)
            for (const auto sample : output)
                CHECK ((std::isfinite (sample) && std::abs (sample) <= 0.5F));

        CHECK (played[1][299] == 0.5F);
        CHECK (played[0][300] == 0);
        CHECK (absolutePeak ({ played[1].begin() + 300 + RouterRig::rampSamples, played[1].end() }) == 0);
        CHECK (rig.router.isMuted());
        CHECK (rig.router.meters().badNumbers() == 2);
        rig.router.release();
        CHECK (rig.play (constant (2, 1000, 0.5F), 2)[0].back() == 0.5F);
    }
}

TEST_CASE ("a monitor that is not finite is silent and mutes nothing")
{
    RouterRig rig;
    rig.route (withMonitor (straightRouting(), 2));
    const auto played =
        rig.play (constant (1, 100, 0.5F), 4, { 100 }, constant (2, 100, std::numeric_limits<float>::quiet_NaN()));
    CHECK (absolutePeak (played[2]) == 0);
    CHECK_FALSE (rig.router.isMuted());
}

TEST_CASE ("another routing comes by way of 0 V")
{
    RouterRig rig;
    rig.play (constant (2, 100, 0.5F), 3);
    rig.router.setRouting (withOutput (straightRouting(), 0, 2), {});
    const auto played = rig.play (constant (2, 1000, 0.5F), 3);

    for (const auto& output : played)
        for (std::size_t n = 1; n < output.size(); ++n)
            CHECK (std::abs (output[n] - output[n - 1]) < 0.0022F);

    CHECK (played[0].back() == 0);
    CHECK (played[2].back() == 0.5F);
    CHECK (played[1][RouterRig::rampSamples - 1] == 0);
}

TEST_CASE ("routings that follow each other quickly all end in the last one")
{
    RouterRig rig;

    for (int output = 3; output < 20; ++output)
    {
        rig.router.setRouting (withOutput (straightRouting(), 0, output), {});
        rig.play (constant (1, output * 31, 0.5F), 20);
        rig.router.collect();
    }

    rig.play (constant (1, 2000, 0.5F), 20);
    CHECK (rig.play (constant (1, 2000, 0.5F), 20)[19].back() == 0.5F);
}

TEST_CASE ("the router's samples do not depend on the blocks, to the bit")
{
    const auto playAll = [] (const std::vector<int>& blocks)
    {
        RouterRig rig;
        auto ceramics = noise (4, 4000, 1.2F);
        auto routing = straightRouting();
        routing.chains[1] = { 100, -1 };
        rig.router.setRouting (routing, { 100, 100, 100, 100 });
        auto all = rig.play (ceramics, 5, blocks);
        const auto append = [&] (const Channels& more)
        {
            for (std::size_t i = 0; i < all.size(); ++i)
                all[i].insert (all[i].end(), more[i].begin(), more[i].end());
        };
        rig.router.identify (2);
        append (rig.play (ceramics, 5, blocks));
        rig.router.identify (OutputRouting::none);
        append (rig.play (ceramics, 5, blocks));
        ceramics[3][1234] = std::numeric_limits<float>::quiet_NaN();
        append (rig.play (ceramics, 5, blocks));
        return all;
    };
    const auto whole = playAll ({ 1 << 20 });

    for (const auto& blocks : std::vector<std::vector<int>> { { 1 }, { 7, 300, 1, 64 }, { 256 }, { 239, 2 } })
        CHECK (playAll (blocks) == whole);
}

TEST_CASE ("outputs that are not open are passed over")
{
    RouterRig rig;
    const auto ceramics = constant (2, 64, 0.5F);
    std::vector<float> second (64);
    const std::vector<const float*> inputs { ceramics[0].data(), ceramics[1].data() };
    const std::vector<float*> outputs { nullptr, second.data(), nullptr };
    rig.router.process ({ inputs, {}, outputs, 64, RouterRig::fullScale, true });
    CHECK (second == ceramics[1]);
}

TEST_CASE ("the router neither allocates nor locks while it plays")
{
    if (! mallocIsCounted())
        return;

    RouterRig rig;
    const auto ceramics = constant (8, 512, 0.5F);
    auto played = constant (8, 512, 0);
    const auto inputs = pointersTo (ceramics, 0);
    std::vector<float*> outputs;

    for (auto& channel : played)
        outputs.push_back (channel.data());

    rig.router.setRouting (withOutput (straightRouting(), 0, 3), { 100 });
    rig.router.identify (1);
    const auto mallocs = mallocCalls(), locks = lockCalls();

    for (int i = 0; i < 20; ++i)
        rig.router.process ({ inputs, {}, outputs, 512, RouterRig::fullScale, true });

    CHECK (mallocCalls() == mallocs);
    CHECK (lockCalls() == locks);
}
