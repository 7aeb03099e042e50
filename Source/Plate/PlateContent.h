#pragma once

#include "LevelRows.h"
#include "MotionSurface.h"
#include "MotionView.h"

#include <Editor/ChartView.h>
#include <Editor/DeviceButton.h>
#include <Editor/EditorLook.h>
#include <Editor/LocalTooltips.h>
#include <Editor/StatusLine.h>
#include <Editor/WindowScale.h>

#include <antinode_base/BackgroundThread.h>

#include <functional>
#include <memory>

namespace antinode
{
/** All that the editor of Antinode Plate shows, in a plain component: any window can have it. Whoever has it calls
    refresh(). [message thread] */
class PlateContent final : public juce::Component
{
public:
    static constexpr ContentSizes sizes { 720, 460, 1300, 800 };
    static constexpr int usualWidth = 1040, usualHeight = 640, framesPerSecond = 30;
    static constexpr double secondsOfWindow = 4; ///< That a captured window is shown for.

    explicit PlateContent (PlateProcessor&);
    ~PlateContent() override;

    /** Shows what has changed. @param seconds  since the last call */
    void refresh (double seconds);

    void setDark (bool isDark);
    bool isDark() const { return look.palette().isDark; }

    /** Called after it has become dark or light. */
    std::function<void()> onTheme;

    /** Goes to a frame of the window and stays there. */
    void holdAt (int frame);

    /** The picture that is shown, or none. */
    const MotionPicture* picture() const { return shown.get(); }

    MotionSurface& surface() { return surfaceView; }

    /** Loads a device of the library, or of a file. What is wrong with it stands in the status line. */
    void loadDevice (const std::string& nameOrFile);

    juce::String status() const { return statusView.text(); }

    void paint (juce::Graphics&) override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    void showPicture();
    void showLevels (double seconds);
    void nameRows();
    void showStatus (double seconds);

    PlateProcessor& processor;
    juce::SharedResourcePointer<EditorLook> fonts; ///< Of JUCE's own windows: menus and alerts.
    EditorLook look;
    std::shared_ptr<MotionView> motion = std::make_shared<MotionView>();
    BackgroundThread motionThread { [kept = motion] { kept->run(); } };
    DeviceButton device;
    juce::TextButton hold { "Hold" }, theme;
    juce::Label time;
    MotionSurface surfaceView;
    ChartView spectrum { "Modes" };
    LevelRows probes { "Probes", "mm/s", 2 }, voltages { "Voltages", "V", 1 };
    LocalTooltips tooltips;
    std::shared_ptr<const PlateSnapshot> snapshot;
    std::shared_ptr<const MotionPicture> shown;
    SurfaceSettings namedSettings;
    int namedProbes = 0;
    double position = 0; ///< s since the window's first frame.
    StatusLine statusView;
};
} // namespace antinode
