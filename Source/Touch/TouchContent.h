#pragma once

#include "FingerPanel.h"
#include "FocusButton.h"
#include "TouchSurface.h"
#include "TouchesButton.h"

#include <Editor/DeviceButton.h>
#include <Editor/DriftPanel.h>
#include <Editor/EditorLook.h>
#include <Editor/LocalTooltips.h>
#include <Editor/StatusLine.h>
#include <Editor/WindowScale.h>
#include <Plate/LevelRows.h>
#include <Plate/MotionView.h>

#include <antinode_base/BackgroundThread.h>

#include <functional>
#include <memory>

namespace antinode
{
/** All that the editor of Antinode Touch shows, in a plain component: any window can have it. Whoever has it calls
    refresh(). [message thread] */
class TouchContent final : public juce::Component
{
public:
    static constexpr ContentSizes sizes { 760, 560, 1300, 860 };
    static constexpr int usualWidth = 1040, usualHeight = 640, framesPerSecond = 30;

    explicit TouchContent (TouchProcessor&);
    ~TouchContent() override;

    /** Shows what has changed. @param seconds  since the last call */
    void refresh (double seconds);

    void setDark (bool isDark);
    bool isDark() const { return look.palette().isDark; }

    /** Called after it has become dark or light. */
    std::function<void()> onTheme;

    /** Whether the surface of a solved device is shown. */
    bool hasPicture() const { return picture != nullptr; }

    TouchSurface& surface() { return surfaceView; }
    FingerPanel& fingers() { return fingerPanel; }
    TouchesButton& touches() { return touchesButton; }

    /** Loads a device of the library, or of a file. What is wrong with it stands in the status line. */
    void loadDevice (const std::string& nameOrFile) { device.loadDevice (nameOrFile); }

    /** Loads a focus that notes play, as loadDevice does. */
    void loadFocus (const std::string& nameOrFile) { focus.loadDocument (nameOrFile); }

    /** The sensor that follows the drift; shown in place of the motions while its button is on. */
    DriftPanel& driftPanel() { return drift; }
    juce::Button& driftButton() { return driftChoice; }

    /** What the window around has to say beside it; none: nothing. */
    std::function<std::vector<UserMessage>()> moreMessages;

    StatusLine& statusLine() { return statusView; }
    juce::String status() const { return statusView.text(); }

    /** What noise at the fingers' levels costs, by latency. */
    juce::String volts() const { return voltsText; }

    void paint (juce::Graphics&) override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    void takeSnapshot();
    DriftPanelSource driftSource();
    void showFingers (double seconds);
    AskedMotion askedOf (const FingerMeters&, std::size_t finger, double level) const;
    void showVoltages (double seconds);
    void showStatus (double seconds);

    TouchProcessor& processor;
    juce::SharedResourcePointer<EditorLook> fonts; ///< Of JUCE's own windows: menus and alerts.
    EditorLook look;
    std::shared_ptr<MotionView> rest = std::make_shared<MotionView>(); ///< Draws the surface at rest.
    BackgroundThread restThread { [kept = rest] { kept->run(); } };
    DeviceButton device;
    FocusButton focus;
    TouchesButton touchesButton;
    juce::TextButton driftChoice { "Drift" }, theme;
    TouchSurface surfaceView;
    FingerPanel fingerPanel;
    LevelRows motions { "Asked for at the fingers, 40 to 1000 Hz", juce::String::fromUTF8 ("\xC2\xB5m"), 2 };
    DriftPanel drift;
    LevelRows voltages { "Voltages", "V", 1 };
    LocalTooltips tooltips;
    std::shared_ptr<const TouchSnapshot> snapshot;
    std::shared_ptr<const MotionPicture> picture;
    std::array<double, mostFingers> felt {}; ///< dB over threshold, which falls slowly.
    StatusLine statusView;
    juce::String voltsText;
};
} // namespace antinode
