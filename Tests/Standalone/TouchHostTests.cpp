#include <Standalone/MainWindow.h>
#include <Standalone/StandaloneOptions.h>
#include <Standalone/TouchHost.h>

#include "Support/TemporaryFolder.h"

#include <antinode_documents/Library.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace antinode;

namespace
{
constexpr double rate = 48000;
constexpr int block = 256;

/** A program as it starts, its device solved and its filters designed. */
struct TouchRig
{
    explicit TouchRig (std::vector<WantedFinger> fingers = { { 0.06, 0.05 }, { 0.14, 0.07 } },
                       SettingsFile file = SettingsFile ({}), bool keeps = false)
        : host (std::move (file), keeps)
    {
        prepare (4, 8);
        host.processor().session().waitUntilSettled();
        host.setFingers (std::move (fingers));
        host.tick();
        host.processor().session().waitUntilSettled();
        host.arm().setValueNotifyingHost (1);
    }

    void prepare (int inputs, int outputs)
    {
        juce::BigInteger openInputs, openOutputs;
        openInputs.setRange (0, inputs, true);
        openOutputs.setRange (0, outputs, true);
        host.callback().prepare (rate, block, openOutputs, openInputs);
    }

    /** A tone of 200 Hz at one input, nothing at the others. @return  the largest sample of each output */
    std::vector<float> play (int toneAt, int inputs = 4, int outputs = 8)
    {
        constexpr int length = 9600;
        std::vector<float> tone (length), silence (length, 0.0F);

        for (int n = 0; n < length; ++n)
            tone[static_cast<std::size_t> (n)] =
                static_cast<float> (0.5 * std::sin (2 * std::numbers::pi * 200 * n / rate));

        std::vector<const float*> heard (static_cast<std::size_t> (inputs), silence.data());

        if (toneAt < inputs)
            heard[static_cast<std::size_t> (toneAt)] = tone.data();

        std::vector<std::vector<float>> played (static_cast<std::size_t> (outputs), std::vector<float> (length, 7));
        std::vector<float*> channels;

        for (auto& channel : played)
            channels.push_back (channel.data());

        host.callback().audioDeviceIOCallbackWithContext (heard.data(), inputs, channels.data(), outputs, length, {});
        std::vector<float> peaks;

        for (const auto& channel : played)
            peaks.push_back (std::abs (*std::max_element (
                channel.begin(), channel.end(), [] (float a, float b) { return std::abs (a) < std::abs (b); })));

        return peaks;
    }

    TouchHost host;
};

float largest (const std::vector<float>& peaks)
{
    return *std::max_element (peaks.begin(), peaks.end());
}
} // namespace

TEST_CASE ("audio inputs feed the fingers, outputs drive the ceramics", "[standalone][touch]")
{
    TouchRig rig;
    CHECK (rig.host.fingersError().empty());
    const auto settings = rig.host.processor().parameters().settings();
    CHECK (settings.fingers[0].xPercent == Approx (30));
    CHECK (settings.fingers[1].presence == FingerPresence::plays);
    CHECK (settings.fingers[2].presence == FingerPresence::absent);
    const auto of = [&] (int input)
    {
        TouchRig fresh;
        return fresh.play (input);
    };
    const auto first = of (0), second = of (1);
    CHECK (largest (first) > 1e-3);
    CHECK (largest (second) > 1e-3);
    CHECK (first != second);
    CHECK (largest (of (2)) == 0);            // its finger is absent
    CHECK (rig.host.latencyText().isEmpty()); // no device is open
}

TEST_CASE ("fingers feel the inputs that they are given, and silence from those that are not open",
           "[standalone][touch]")
{
    const auto straight = TouchRig().play (0);
    TouchRig swapped;
    swapped.host.setInputs ({ { 2, 0, FingerInputs::none, 3, 4, 5, 6, 7 } });
    CHECK (swapped.play (2) == straight);

    TouchRig missing;
    missing.host.setInputs ({ { 100, FingerInputs::none, 0, 1, 2, 3, 4, 5 } });
    CHECK (largest (missing.play (0)) == 0);
}

TEST_CASE ("a disarmed touch program gives 0 V, and so does one that is muted", "[standalone][touch]")
{
    TouchRig rig;
    rig.host.arm().setValueNotifyingHost (0);
    rig.play (3); // the ramp
    CHECK (largest (rig.play (0)) == 0);
    rig.host.arm().setValueNotifyingHost (1);
    rig.host.muteAll();
    rig.play (0); // the ramp
    CHECK (largest (rig.play (0)) == 0);
    CHECK (rig.host.router().isSilent());
}

TEST_CASE ("what the touch program keeps comes back disarmed, beside what the foci keep", "[standalone][touch]")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "standalone.json";
    {
        StandaloneHost foci (SettingsFile (path), true);
        foci.processor().parameters().find ("x")->setValueNotifyingHost (0.25F);
    }
    {
        TouchRig rig ({ { 0.1, 0.06, 0 } }, SettingsFile (path), true);
        rig.host.setInputs ({ { 1, 0, 2, 3, 4, 5, 6, FingerInputs::none }, 11 });
        rig.host.processor().session().following().setSettings (readFollowing ("ceramic_charge:2"));
        rig.host.setTouch ({ 0, 0, "127.0.0.1" });
    }
    {
        TouchHost host (SettingsFile (path), true);
        CHECK (host.warning().isEmpty());
        CHECK_FALSE (host.arm().get());
        CHECK (host.settings().inputs.inputs[0] == 1);
        CHECK (host.settings().inputs.inputs[7] == FingerInputs::none);
        CHECK (host.settings().inputs.sensor == 11);
        CHECK (host.processor().session().following().settings() == readFollowing ("ceramic_charge:2"));
        CHECK (host.processor().parameters().settings().fingers[0].presence == FingerPresence::silent);
    }
    const StandaloneHost foci (SettingsFile (path), true);
    CHECK (foci.settings().state->parameters.at ("x") == Approx (25));
}

TEST_CASE ("a finger outside the surface is refused with its place and what is allowed", "[standalone][touch]")
{
    const TouchRig rig ({ { 0.06, 0.05 }, { 0.3, 0.05 } });
    CHECK (rig.host.fingersError()
           == "--finger: finger 2 has x = 300 mm, which is outside the surface; allowed: 0 to 200 mm");
}

TEST_CASE ("touches play fingers of the touch program, and are lifted when it ends", "[standalone][touch]")
{
    TouchRig rig;
    rig.host.processor().network().take ({ TouchKind::rest, false, 0.5, 0.9, 1, 5000 });
    rig.host.processor().network().apply();
    const auto finger = [&] (std::size_t k) { return rig.host.processor().parameters().settings().fingers[k]; };
    CHECK (finger (2).presence == FingerPresence::plays);
    CHECK (finger (2).yPercent == Approx (90));
    rig.host.processor().session().waitUntilSettled();
    CHECK (largest (rig.play (2)) > 1e-3);
    rig.host.shutDown();
    CHECK (finger (2).presence == FingerPresence::absent);
    CHECK (finger (0).presence == FingerPresence::plays);
}

TEST_CASE ("the window of the touch program has inputs in place of MIDI", "[standalone][touch]")
{
    TouchHost host (SettingsFile ({}), false);
    MainComponent window (host);
    REQUIRE (window.touchEditor() != nullptr);
    CHECK (window.fociEditor() == nullptr);
    window.showSettings ("Inputs");
    CHECK (window.keyPressed (juce::KeyPress (juce::KeyPress::F12Key)));
    CHECK (host.router().isMuted());
    window.touchEditor()->content().setDark (false);
    CHECK_FALSE (EditorLook::findPalette (window).isDark);
    CHECK_FALSE (host.settings().isDark);
}

TEST_CASE ("what an output cannot give limits its ceramic, so that no sample is clamped", "[standalone][touch]")
{
    TouchRig rig;
    auto routing = straightRouting();
    routing.chains[0].voltsPerFullScale = 0.01;
    rig.host.setRouting (routing);
    rig.host.processor().session().waitUntilSettled();
    CHECK (voltageLimits (*rig.host.model())[0] == 0.01);
    CHECK (voltageLimits (*rig.host.model())[1] > 1);
    rig.play (3); // Routing and path ramp to 0 V and back.
    const auto peaks = rig.play (0);
    CHECK (peaks[0] == Approx (1).epsilon (1e-3)); // It is cut at what the output gives.
    CHECK (peaks[1] > 1e-3);
    CHECK (rig.host.router().meters().clampedSamples (0) == 0);
}
