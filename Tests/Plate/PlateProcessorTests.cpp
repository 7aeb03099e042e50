#include "PlayedPlate.h"

#include <Support/LaggingDevice.h>

#include <antinode_focus/DesignFocus.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_text/WaveFile.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int latency = 15;

/** What `antinode render` writes for the demonstrator with one probe: the bytes of both files, read again. */
struct RenderedFiles
{
    Eigen::MatrixXd voltages, probe;

    /** @param xPercent  of the surface */
    explicit RenderedFiles (double xPercent)
    {
        const auto model = solveDevice (plateDevice ("staple")->description, {}, true);
        const auto focus = readFocusDocument (loadDocument (LibraryKind::focus, "demonstrator"), "demonstrator");
        RenderOptions options;
        options.playback = { Reconstruction::bandLimited, rate };
        options.probes = { placeFromPercent (model.surface, xPercent, 50) };
        const auto rendered = renderFocus (model, designFocus (model, focus.description, options.playback), options);
        voltages =
            decodeWave (encodeWave (rendered.render.voltages, model.fullScaleVoltage, rate), "voltages.wav").samples;
        probe = decodeWave (encodeWave (rendered.render.probeVelocities, 1, rate), "probe.wav").samples;
    }
};

juce::AudioProcessor::BusesLayout makeLayout (int ceramics, int probes)
{
    juce::AudioProcessor::BusesLayout layout;
    layout.inputBuses.add (juce::AudioChannelSet::discreteChannels (ceramics));
    layout.outputBuses.add (juce::AudioChannelSet::discreteChannels (probes));
    return layout;
}
} // namespace

TEST_CASE ("Rendered voltages through Antinode Plate are the rendered probe, within 1e-6, for any blocks", "[plate]")
{
    static const RenderedFiles files (62.5);
    const auto block = GENERATE (1, 64, 511, 8193);
    const auto processor = offlinePlate (8, rate, block);
    processor->parameters().probeX (2) = 62.5F;
    CHECK (processor->getLatencySamples() == latency);
    const auto peak = files.probe.cwiseAbs().maxCoeff();
    const auto length = files.probe.cols() - 2 * latency; // At its end a render knows what voltages come.
    const auto played = moved<float> (*processor, files.voltages, block);
    REQUIRE (peak > 0.01);
    CHECK ((played.row (2).segment (latency, length) - files.probe.leftCols (length)).cwiseAbs().maxCoeff()
           < 1e-6 * peak);
    // Band-limited voltages move the surface a little before their first sample.
    CHECK (played.row (2).head (latency).cwiseAbs().maxCoeff() < 1e-5 * peak);
}

TEST_CASE ("What a lagging device is asked for moves its surface as designed, later by the latency", "[plate][lag]")
{
    const auto model = withOwnLags (solveDevice (plateDevice ("staple")->description, {}, true));
    const auto focus = readFocusDocument (loadDocument (LibraryKind::focus, "demonstrator"), "demonstrator");
    RenderOptions options;
    options.playback = { Reconstruction::bandLimited, rate };
    options.probes = { placeFromPercent (model.surface, 62.5, 50) };
    const auto rendered = renderFocus (model, designFocus (model, focus.description, options.playback), options);
    REQUIRE (rendered.undone);
    const auto processor = offlinePlate (8, rate, 512);
    processor->load (std::make_shared<const DeviceDocument> (documentOf (model)));
    processor->session().waitUntilSettled();
    processor->prepareToPlay (rate, 512);
    processor->parameters().probeX (2) = 62.5F;
    const auto late = processor->getLatencySamples() + rendered.undone->lateness;
    CHECK (processor->getLatencySamples() > latency);
    const auto played = moved<float> (*processor, outputVoltages (rendered) / model.fullScaleVoltage, 512);
    const auto& wanted = rendered.render.probeVelocities;
    const auto length = std::min (wanted.cols(), played.cols() - late);
    CHECK ((played.row (2).segment (late, length) - wanted.leftCols (length)).cwiseAbs().maxCoeff()
           < 2e-3 * wanted.cwiseAbs().maxCoeff());
}

TEST_CASE ("The quick surface has no latency and is near the rendered one", "[plate]")
{
    const RenderedFiles files (62.5);
    const auto processor = offlinePlate (8, rate, 512);
    processor->parameters().setValues ({ { "quick", 1 }, { "probe1_x", 62.5 }, { "probe1_y", 50 } });
    processor->session().waitUntilSettled();
    processor->prepareToPlay (rate, 512);
    CHECK (processor->getLatencySamples() == 0);
    const auto played = moved<float> (*processor, files.voltages, 512);
    CHECK ((played.row (0) - files.probe).cwiseAbs().maxCoeff() < 0.02 * files.probe.cwiseAbs().maxCoeff());
}

TEST_CASE ("A gain is a factor of the velocities", "[plate]")
{
    const auto voltages = sines (8, 2000);
    const auto one = offlinePlate (8, rate, 100);
    const auto doubles = moved<double> (*one, voltages, 100);
    CHECK (doubles.rowwise().lpNorm<Eigen::Infinity>().minCoeff() > 0);
    const auto louder = offlinePlate (8, rate, 100);
    louder->parameters().setValues ({ { "gain", 20 } });
    CHECK ((moved<double> (*louder, voltages, 100) - 10 * doubles).cwiseAbs().maxCoeff()
           < 1e-9 * doubles.cwiseAbs().maxCoeff());
}

TEST_CASE ("With fewer inputs than ceramics the others get 0 V", "[plate]")
{
    const auto narrow = offlinePlate (8, rate, 512);
    REQUIRE (narrow->setBusesLayout (makeLayout (3, 1)));
    narrow->prepareToPlay (rate, 512);
    auto voltages = sines (8, 3000);
    const auto heard = moved (*narrow, voltages, 512);
    REQUIRE (heard.rows() == 1);
    voltages.bottomRows (5).setZero();
    const auto wide = offlinePlate (64, rate, 512);
    CHECK (moved (*wide, voltages, 512).row (0) == heard.row (0));
}

TEST_CASE ("What is not a number never comes out, and that is said", "[plate]")
{
    const auto processor = offlinePlate (8, rate, 64);
    auto voltages = sines (8, 4000);
    voltages (2, 1000) = std::numeric_limits<double>::quiet_NaN();
    voltages (3, 1500) = std::numeric_limits<double>::infinity();
    const auto heard = moved (*processor, voltages, 64);
    CHECK (heard.allFinite());
    CHECK (heard.leftCols (1000).cwiseAbs().maxCoeff() > 0);
    CHECK (processor->warning().contains ("not a finite number"));
    processor->prepareToPlay (rate, 64);
    CHECK (moved (*processor, sines (8, 4000), 64).rightCols (2000).cwiseAbs().maxCoeff() > 0);
    CHECK (processor->warning().isEmpty());
}

TEST_CASE ("Beyond its device's limit a voltage is cut", "[plate]")
{
    const auto huge = offlinePlate (8, rate, 64), limited = offlinePlate (8, rate, 64);
    const auto limit = huge->session().snapshot()->model->ceramics[0].voltageLimit
                       / huge->session().snapshot()->model->fullScaleVoltage;
    const auto voltages = sines (8, 3000, 50);
    CHECK (moved (*huge, voltages, 64) == moved (*limited, voltages.cwiseMax (-limit).cwiseMin (limit), 64));
    CHECK (huge->session().meters().limitedSamples (0) > 0);
}

TEST_CASE ("Bypassed, a surface rings out", "[plate]")
{
    const auto processor = offlinePlate (8, rate, 64);
    CHECK (moved (*processor, sines (8, 6000), 64).rightCols (1000).cwiseAbs().maxCoeff() > 1e-4);
    processor->parameters().bypass() = true;
    const auto ringing = moved (*processor, sines (8, 72000), 64);
    CHECK (ringing.rightCols (1000).cwiseAbs().maxCoeff() < 1e-4 * ringing.leftCols (100).cwiseAbs().maxCoeff());
}

TEST_CASE ("Probes follow their parameters while the surface moves", "[plate]")
{
    const auto still = offlinePlate (8, rate, 64), moving = offlinePlate (8, rate, 64);
    still->parameters().probeX (1) = 60.0F;
    still->session().waitUntilSettled();
    moved (*still, sines (8, 2000), 64);
    moved (*moving, sines (8, 2000), 64);
    moving->parameters().probeX (1) = 60.0F;
    moving->session().waitUntilSettled();
    const auto voltages = sines (8, 1000);
    CHECK ((moved (*moving, voltages, 64).row (1) - moved (*still, voltages, 64).row (1)).cwiseAbs().maxCoeff()
           < 1e-15);
}

TEST_CASE ("Another device fades the old velocities out before its own begin", "[plate]")
{
    const auto processor = offlinePlate (8, rate, 64);
    const Eigen::MatrixXd before = moved (*processor, sines (8, 4800), 64);
    processor->load (plateDevice ("beam"));
    processor->session().waitUntilSettled();
    const Eigen::MatrixXd after = moved (*processor, Eigen::MatrixXd::Zero (8, 4800), 64);
    const auto largest = before.cwiseAbs().maxCoeff();
    double step = 0;

    for (Eigen::Index n = 1; n < after.cols(); ++n)
        step = std::max (step, (after.col (n) - after.col (n - 1)).cwiseAbs().maxCoeff());

    CHECK (after.leftCols (60).cwiseAbs().maxCoeff() > 0.01 * largest);
    CHECK (after.rightCols (4000).isZero (0));
    CHECK (step < largest);
    CHECK (processor->session().snapshot()->model->actuators() == 6);
}
