#pragma once

#include "PlateProcessor.h"

#include <Editor/ChartView.h>
#include <Editor/ContentEditor.h>
#include <Editor/Meters.h>
#include <Editor/MotionView.h>
#include <Editor/Presets.h>
#include <Editor/SurfaceView.h>

#include <antinode_session/SessionOwner.h>

#include <memory>

namespace antinode
{
/** The surface, slowly: the frames of a captured window one after the other, and the probes. [message thread] */
class ProbeSurface final : public SurfaceView
{
public:
    explicit ProbeSurface (PlateProcessor&);

    /** Draws the probes where the parameters say. */
    void refresh();

    /** Where a probe stands, in pixels of this component. */
    juce::Point<float> probe (int index) const { return pixels (placeOf (index)); }

    void mouseDown (const juce::MouseEvent&) override;

private:
    Place placeOf (int probe) const;
    void paintOnTop (juce::Graphics&) override;

    PlateProcessor& processor;
    int shownProbes = 0;
    SurfaceSettings shown;
};

/** What Antinode Plate shows. [message thread] */
class PlateContent final : public WindowContent
{
public:
    static constexpr double secondsOfWindow = 4; ///< That a captured window is shown for.

    explicit PlateContent (PlateProcessor&);

    void refresh (double seconds) override;

    /** Goes to a frame of the window and stays there. */
    void holdAt (int frame);

    /** The picture that is shown, or none. */
    const MotionPicture* picture() const { return shown.get(); }

    ProbeSurface& surface() { return surfaceView; }
    LibraryButton& deviceButton() { return device; }

    void lookAndFeelChanged() override { time.setColour (juce::Label::textColourId, look.palette().mutedText); }

private:
    void takeSnapshot();
    void showPicture();
    void nameProbes();
    void showLevels (double seconds);
    void showStatus (double seconds);
    void layOut (juce::Rectangle<int>) override;

    PlateProcessor& processor;
    SessionThread<MotionView> motion;
    LibraryButton device;
    juce::TextButton hold { "Hold" };
    juce::Label time;
    ProbeSurface surfaceView;
    ChartView spectrum { "Modes" };
    LevelRows probes { "Probes", "mm/s", 2 }, voltages { "Voltages", "V", 1 };
    std::shared_ptr<const PlateSnapshot> snapshot;
    std::shared_ptr<const MotionPicture> shown;
    SurfaceSettings namedSettings;
    int namedProbes = 0;
    double position = 0; ///< s since the window's first frame.
};

/** The window of Antinode Plate. */
using PlateEditor = RoleEditor<PlateContent>;
} // namespace antinode
