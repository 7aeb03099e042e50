#pragma once

#include "FingerPanel.h"
#include "TouchSurface.h"
#include "TouchesButton.h"

#include <Editor/ContentEditor.h>
#include <Editor/DriftPanel.h>
#include <Editor/LevelRows.h>
#include <Editor/LibraryButton.h>
#include <Editor/MotionView.h>

#include <antinode_session/SessionOwner.h>

#include <array>
#include <memory>

namespace antinode
{
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
} // namespace antinode
