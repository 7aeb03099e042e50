#include "PlayedPlate.h"

#include <Support/LaggingDevice.h>

#include <antinode_focus/DesignFocus.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_text/WaveFile.h>
#include <antinode_text/WaveReader.h>

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

juce::MemoryBlock savedState (PlateProcessor& processor)
{
    juce::MemoryBlock state;
    processor.getStateInformation (state);
    return state;
}

void setState (PlateProcessor& processor, const std::string& text)
{
    processor.setStateInformation (text.data(), static_cast<int> (text.size()));
}

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

TEST_CASE ("Floats and doubles move the surface alike, and a gain is a factor", "[plate]")
{
    const auto voltages = sines (8, 2000);
    const auto one = offlinePlate (8, rate, 100), other = offlinePlate (8, rate, 100);
    const auto doubles = moved<double> (*one, voltages, 100);
    CHECK (doubles.rowwise().lpNorm<Eigen::Infinity>().minCoeff() > 0);
    CHECK ((moved<float> (*other, voltages, 100) - doubles).cwiseAbs().maxCoeff()
           < 1e-6 * doubles.cwiseAbs().maxCoeff());
    const auto louder = offlinePlate (8, rate, 100);
    louder->parameters().setValues ({ { "gain", 20 } });
    CHECK ((moved<double> (*louder, voltages, 100) - 10 * doubles).cwiseAbs().maxCoeff()
           < 1e-9 * doubles.cwiseAbs().maxCoeff());
}

TEST_CASE ("Layouts of 1 to 64 voltages and 1 to 8 probes are taken, others not", "[plate]")
{
    PlateProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    CHECK (processor.isBusesLayoutSupported (makeLayout (1, 1)));
    CHECK (processor.isBusesLayoutSupported (makeLayout (64, 8)));
    CHECK (processor.isBusesLayoutSupported (makeLayout (2, 2)));
    CHECK_FALSE (processor.isBusesLayoutSupported (makeLayout (0, 2)));
    CHECK_FALSE (processor.isBusesLayoutSupported (makeLayout (2, 0)));
    CHECK_FALSE (processor.isBusesLayoutSupported (makeLayout (65, 8)));
    CHECK_FALSE (processor.isBusesLayoutSupported (makeLayout (8, 9)));
}

TEST_CASE ("With fewer inputs than ceramics the others get 0 V, and that is said", "[plate]")
{
    const auto narrow = offlinePlate (8, rate, 512);
    REQUIRE (narrow->setBusesLayout (makeLayout (3, 1)));
    narrow->prepareToPlay (rate, 512);
    auto voltages = sines (8, 3000);
    const auto heard = moved (*narrow, voltages, 512);
    REQUIRE (heard.rows() == 1);
    CHECK (narrow->warning()
           == "The device has 8 ceramics, but this bus has only 3 channels: ceramic 4 and above stay at 0 V.");
    voltages.bottomRows (5).setZero();
    const auto wide = offlinePlate (64, rate, 512);
    CHECK (moved (*wide, voltages, 512).row (0) == heard.row (0));
    CHECK (wide->warning().isEmpty());
}

TEST_CASE ("Unprepared, or while its device is solved, a plate is silent", "[plate]")
{
    PlateProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
    CHECK (moved (processor, sines (8, 512), 64).isZero (0));
    juce::AudioBuffer<float> tooFew (1, 64);
    tooFew.clear();
    tooFew.setSample (0, 3, 1);
    juce::MidiBuffer midi;
    processor.processBlock (tooFew, midi);
    CHECK (tooFew.getMagnitude (0, 64) == 0);
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

TEST_CASE ("A plate's state comes back to the bit in another instance", "[plate]")
{
    const auto first = offlinePlate (8, rate, 64);
    first->load (plateDevice ("aluminium-200x120"));
    first->parameters().probeX (7).setValueNotifyingHost (0.377F);
    first->parameters().setValues ({ { "gain", -7.3 }, { "probe3_y", 12.345 } });
    const auto kept = savedState (*first);
    const auto second = offlinePlate (8, rate, 64);
    second->setStateInformation (kept.getData(), static_cast<int> (kept.getSize()));
    CHECK (savedState (*second) == kept);
    CHECK (second->warning().isEmpty());
    CHECK (second->device()->description.name == first->device()->description.name);
    const auto voltages = sines (16, 1000);
    first->session().waitUntilSettled();
    second->session().waitUntilSettled();
    first->prepareToPlay (rate, 64);
    second->prepareToPlay (rate, 64);
    CHECK (moved (*second, voltages, 64) == moved (*first, voltages, 64));
}

TEST_CASE ("A state that cannot be read changes nothing and is one sentence", "[plate]")
{
    const auto processor = offlinePlate (8, rate, 64);
    const auto before = savedState (*processor);
    auto json = nlohmann::json::parse (before.toString().toStdString());
    json["device"]["thickness_mm"] = -1;
    auto wrongParameter = nlohmann::json::parse (before.toString().toStdString());
    wrongParameter["parameters"]["gain"] = "loud";

    for (const auto& text : { std::string(), std::string ("no state"), std::string (1000, '\0'), std::string ("[]"),
                              std::string (R"({"schema":"antinode.state/1"})"),
                              std::string (R"({"schema":"antinode.plate/2"})"), json.dump(), wrongParameter.dump(),
                              std::string (R"({"schema":"antinode.plate/1","device":3,"parameters":{}})"),
                              before.toString().toStdString().substr (0, 500) })
    {
        CAPTURE (text);
        setState (*processor, text);
        CHECK (processor->warning().startsWith ("The saved state could not be read; nothing was changed: "));
        CHECK_FALSE (processor->warning().containsChar ('\n'));
        CHECK (savedState (*processor) == before);
    }

    setState (*processor, before.toString().toStdString());
    CHECK (processor->warning().isEmpty());
}

TEST_CASE ("A device that cannot be solved leaves the present one moving, and says why", "[plate]")
{
    const auto processor = offlinePlate (8, rate, 64);
    auto json = loadDocument (LibraryKind::device, "beam");
    json["ceramics"] = nlohmann::json::array();
    processor->load (std::make_shared<const DeviceDocument> (readDeviceDocument (json, "beam")));
    processor->session().waitUntilSettled();
    CHECK (processor->warning() == "device 'beam': has no ceramics, so nothing can move it");
    CHECK (moved (*processor, sines (8, 2000), 64).cwiseAbs().maxCoeff() > 0);
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

TEST_CASE ("Plates end in the middle of anything", "[plate]")
{
    for (int i = 0; i < 12; ++i)
    {
        PlateProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);

        if (i % 3 != 0)
            processor.prepareToPlay (rate, 64);

        if (i % 4 == 0)
            processor.load (plateDevice ("beam"));

        moved (processor, sines (8, 64 * i), 64);
        processor.parameters().probeX (0) = static_cast<float> (i);
    }

    SUCCEED();
}
