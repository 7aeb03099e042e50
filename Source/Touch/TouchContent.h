#pragma once

#include "FingerViews.h"
#include "TouchProcessor.h"

#include <Editor/ContentEditor.h>
#include <Editor/DriftPanel.h>
#include <Editor/Meters.h>
#include <Editor/MotionView.h>
#include <Editor/Presets.h>
#include <antinode_session/SessionOwner.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace antinode
{
/** Says which ports are open for touches by OSC and TUIO and how many fingers they are, and opens others.
    [message thread] */
class TouchesButton final : public juce::TextButton
{
public:
    explicit TouchesButton (TouchProcessor&);

    /** Shows what has changed. */
    void refresh();

    /** Why the ports that were chosen last cannot be opened, or empty. */
    juce::String error() const { return failure; }

    /** Opens ports, as the menu does. */
    void open (const TouchPorts&);

private:
    void showMenu();

    TouchProcessor& processor;
    juce::String failure;
};

/** What Antinode Touch shows. [message thread] */
class TouchContent final : public WindowContent
{
public:
    explicit TouchContent (TouchProcessor&);
    ~TouchContent() override;

    void refresh (double seconds) override;

    /** Whether the surface of a solved device is shown. */
    bool hasPicture() const { return picture != nullptr; }

    TouchSurface& surface() { return surfaceView; }
    FingerPanel& fingers() { return fingerPanel; }
    TouchesButton& touches() { return touchesButton; }

    LibraryButton& deviceButton() { return device; }
    LibraryButton& focusButton() { return focus; } ///< Of what notes play.

    /** The sensor that follows the drift; shown in place of the motions while its button is on. */
    DriftPanel& driftPanel() { return drift; }
    juce::Button& driftButton() { return driftChoice; }

    /** What noise at the fingers' levels costs, by latency. */
    juce::String volts() const { return voltsText; }

    void paint (juce::Graphics&) override;

private:
    void takeSnapshot();
    DriftPanelSource driftSource();
    void showFingers (double seconds);
    AskedMotion askedOf (const FingerMeters&, std::size_t finger, double level) const;
    void showStatus (double seconds);
    void layOut (juce::Rectangle<int>) override;

    TouchProcessor& processor;
    SessionThread<MotionView> rest; ///< Draws the surface at rest.
    LibraryButton device, focus;
    TouchesButton touchesButton;
    juce::TextButton driftChoice { "Drift" };
    TouchSurface surfaceView;
    FingerPanel fingerPanel;
    LevelRows motions { "Asked for at the fingers, 40 to 1000 Hz", juce::String::fromUTF8 ("\xC2\xB5m"), 2 };
    DriftPanel drift;
    LevelRows voltages { "Voltages", "V", 1 };
    std::shared_ptr<const TouchSnapshot> snapshot;
    std::shared_ptr<const MotionPicture> picture;
    std::array<double, mostFingers> felt {}; ///< dB over threshold, which falls slowly.
    juce::String voltsText;
};

/** The window of Antinode Touch. */
using TouchEditor = RoleEditor<TouchContent>;

/** What Antinode Touch does just now that somebody has to wait for or to know; empty where it simply plays. [message
    thread] */
std::vector<UserMessage> touchSentences (TouchProcessor&, const TouchSnapshot&);

/** The voltage, V, of the ceramic with most where every finger that plays gets noise that fills the band and whose
    largest samples, three times its RMS, are 1.0; none where there are no filters for that latency yet. [any] */
std::optional<double> noiseVolts (const TouchSnapshot&, const PlayControls&, std::size_t latency);

/** The same for all latencies, in words. [any] */
juce::String latencyVoltsText (const TouchSnapshot&, const PlayControls&);
} // namespace antinode
