#include "EngineFixtures.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_engine/VoltageSynthesiser.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr auto bandLimited = Reconstruction::bandLimited;
constexpr auto zeroOrderHold = Reconstruction::zeroOrderHold;

RenderSettings offlineSettings (Playback playback, double duration = 0.025, int blockSize = 512)
{
    return { playback, duration, blockSize, Draws (21).matrix (2, 34) };
}
} // namespace

TEST_CASE ("a render has every sample of its duration, with the focus on one of them")
{
    for (const auto rate : usualRates)
    {
        const auto render = renderOffline (manyModes(), manyOscillations(), offlineSettings ({ bandLimited, rate }));
        CHECK (render.sampleRate == rate);
        CHECK (render.focusSample == std::llround (0.0200037 * rate));
        const auto samples = std::lround (0.025 * rate);
        CHECK (render.voltages.cols() == samples);
        CHECK (render.modalVelocities.cols() == samples);
        CHECK (render.probeVelocities.cols() == samples);
        CHECK (sameBits (render.focusVelocities, render.modalVelocities.col (render.focusSample)));
        CHECK (render.modalVelocities.allFinite());
        CHECK (render.voltages.cwiseAbs().maxCoeff() > 0.1);
        CHECK (render.limitedSamples == std::vector<std::int64_t> (8, 0));
    }
}

TEST_CASE ("a render is the same to the bit for every block size and from run to run, at any rate")
{
    std::vector<Playback> playbacks { { zeroOrderHold, 192e3 } };
    for (const auto rate : usualRates)
        playbacks.push_back ({ bandLimited, rate });

    for (const auto& playback : playbacks)
    {
        const auto whole = renderOffline (manyModes(), manyOscillations(), offlineSettings (playback));
        for (const auto blockSize : blockSizes)
        {
            const auto render =
                renderOffline (manyModes(), manyOscillations(), offlineSettings (playback, 0.025, blockSize));
            INFO (playback.sampleRate << " Hz, blocks of " << blockSize);
            CHECK (sameBits (render.voltages, whole.voltages));
            CHECK (sameBits (render.modalVelocities, whole.modalVelocities));
            CHECK (sameBits (render.probeVelocities, whole.probeVelocities));
            CHECK (sameBits (render.focusVelocities, whole.focusVelocities));
        }
    }
}

TEST_CASE ("rendered velocities are aligned with the voltages: the plate model's latency is gone")
{
    const Playback playback { bandLimited, 96e3 };
    const auto render = renderOffline (manyModes(), manyOscillations(), offlineSettings (playback));
    PlateModel plate (manyModes(), playback, offlineSettings (playback).probeShapes);
    const auto latency = plate.latencySamples();
    REQUIRE (latency == 15);

    // The plate is given what the program plays beyond the end of the render as well.
    Eigen::MatrixXd voltages (8, 2400 + latency), velocities (2, 2400 + latency);
    VoltageSynthesiser (manyOscillations(), playback).process (0, voltages);
    plate.process (voltages, velocities);
    CHECK (sameBits (render.voltages, voltages.leftCols (2400)));
    CHECK ((render.probeVelocities - velocities.rightCols (2400)).cwiseAbs().maxCoeff()
           < 1e-13 * velocities.cwiseAbs().maxCoeff());
    CHECK (sameBits (render.modalVelocities.rightCols (1), plate.modalVelocities()));
}

TEST_CASE ("a longer render begins like a shorter one that ends while voltages still play")
{
    const auto shorter =
        renderOffline (manyModes(), manyOscillations(), offlineSettings ({ bandLimited, 48e3 }, 0.0203));
    const auto longer = renderOffline (manyModes(), manyOscillations(), offlineSettings ({ bandLimited, 48e3 }, 0.03));
    CHECK (shorter.voltages.rightCols (1).cwiseAbs().maxCoeff() > 0.01);
    CHECK (sameBits (shorter.modalVelocities, longer.modalVelocities.leftCols (shorter.modalVelocities.cols())));
}

TEST_CASE ("no rendered voltage exceeds its ceramic's limit and the clamped samples are counted")
{
    auto program = manyOscillations();
    program.voltageLimits[2] = 0.05;
    program.voltageLimits[5] = 0;
    const auto free = renderOffline (manyModes(), manyOscillations(), offlineSettings ({ bandLimited, 48e3 }));
    const auto render = renderOffline (manyModes(), program, offlineSettings ({ bandLimited, 48e3 }));
    for (const auto ceramic : { 2, 5 })
    {
        const auto limit = program.voltageLimits[ceramic];
        const auto over = (free.voltages.row (ceramic).array().abs() > limit).count();
        CHECK (over > 0);
        CHECK (render.limitedSamples[static_cast<std::size_t> (ceramic)] == over);
        CHECK (render.voltages.row (ceramic).cwiseAbs().maxCoeff() == limit);
    }
    CHECK (render.limitedSamples[0] == 0);
    CHECK (sameBits (render.voltages.row (0), free.voltages.row (0)));
}

TEST_CASE ("progress of a render rises to 1")
{
    std::vector<double> seen;
    renderOffline (manyModes(), manyOscillations(), offlineSettings ({ bandLimited, 48e3 }),
                   [&] (double done) { seen.push_back (done); });
    CHECK (seen.size() > 1);
    CHECK (std::is_sorted (seen.begin(), seen.end()));
    CHECK (seen.back() == 1);
}

TEST_CASE ("renders of a few samples and blocks longer than the render work")
{
    auto program = manyOscillations();
    program.focusTime = 0;
    for (const auto duration : { 1 / 48e3, 5 / 48e3, 40 / 48e3 })
    {
        for (const auto blockSize : { 1, 3, 1000000000 })
        {
            const auto render =
                renderOffline (manyModes(), program, offlineSettings ({ bandLimited, 48e3 }, duration, blockSize));
            CHECK (render.voltages.cols() == std::lround (duration * 48e3));
            CHECK (render.modalVelocities.allFinite());
        }
    }
}

TEST_CASE ("a render that cannot be done is refused with a reason")
{
    const auto refuses = [] (const VoltageProgram& program, const RenderSettings& settings, const std::string& reason)
    { CHECK_THROWS_WITH (renderOffline (manyModes(), program, settings), Catch::Contains (reason)); };
    const auto program = manyOscillations();

    for (const auto rate : { 0.0, 7999.0, 2.1e6, std::numeric_limits<double>::quiet_NaN() })
        refuses (program, offlineSettings ({ bandLimited, rate }), "allowed: 8000 to 2000000 Hz");
    for (const auto duration : { 0.0, -1.0, 61.0, std::numeric_limits<double>::infinity() })
        refuses (program, offlineSettings ({ bandLimited, 48e3 }, duration), "allowed: above 0 to 60 s");
    refuses (program, offlineSettings ({ bandLimited, 48e3 }, 0.025, 0), "allowed: 1 or more");
    refuses (program, offlineSettings ({ bandLimited, 768e3 }, 60), "allowed: 1024 MiB");
    refuses (program, offlineSettings ({ bandLimited, 48e3 }, 0.019), "ends before the focus");

    auto fewerCeramics = program;
    fewerCeramics.allocation.conservativeResize (7, 68);
    refuses (fewerCeramics, offlineSettings ({ bandLimited, 48e3 }), "every ceramic");

    auto endless = program;
    endless.allocation *= 1e308;
    for (auto& oscillation : endless.oscillations)
        oscillation.inPhase = oscillation.quadrature = 1e3;
    refuses (endless, offlineSettings ({ bandLimited, 48e3 }), "beyond double precision");
}
