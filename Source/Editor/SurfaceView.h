#pragma once

#include "EditorLook.h"
#include "FieldFrames.h"

#include <antinode_reports/Chart.h>
#include <antinode_reports/PlotFrame.h>
#include <juce_audio_processors/juce_audio_processors.h>
#include <juce_graphics/juce_graphics.h>

#include <memory>
#include <string>
#include <utility>

namespace antinode
{
/** A surface as it is drawn. Immutable. */
struct SurfacePicture
{
    std::shared_ptr<const ModalModel> model;
    std::shared_ptr<const FieldFrames> frames;
    std::shared_ptr<const Chart> field; ///< A LineChart of a line: wanted, reached, truncated; a HeatMap of a plate.
    std::string error;                  ///< Why it is at rest, in one sentence.
};

/** Draws the field of a picture, frame by frame: what does not move lies in images that are drawn once, with the code
   of the report's charts. [message thread] */
class SurfacePainter
{
public:
    void setPicture (std::shared_ptr<const SurfacePicture>);
    void setPalette (const Palette&);

    /** Whether there is a bar that explains the field's colours, as at first: not where there never is a field. */
    void setColourBar (bool isShown) { hasColourBar = isShown; }

    /** @param area   from 0, 0
        @param scale  pixels of the screen for one of the area */
    void layOut (juce::Rectangle<int> area, float scale);

    /** The mapping of positions and velocities, in mm and mm/s, to pixels. */
    const PlotFrame& frame() const { return plot; }

    bool isLine() const;

    /** @param frame  of FieldFrames; the focus where there is no other yet */
    void paint (juce::Graphics&, int frame) const;

private:
    void layOutLine (const LineChart&, juce::Graphics&);
    void layOutPlate (const HeatMap&, juce::Graphics&);
    void drawLayer (juce::Graphics&, const juce::Image&) const;
    void paintLine (juce::Graphics&, int frame) const;
    void paintPlate (juce::Graphics&, int frame) const;
    void paintOverlay (juce::Graphics&, bool withContours) const;
    juce::Image emptyLayer() const;

    std::shared_ptr<const SurfacePicture> picture;
    const Palette* colours = &Palette::dark();
    juce::Rectangle<int> area;
    float scale = 1;
    bool hasColourBar = true;
    PlotFrame plot;
    juce::Image below, above, aboveFocus; ///< The field lies between them; the last one with the contours of the focus.
    juce::Image still;                    ///< All of a picture that has one frame alone.
};

/** The plate or beam from above, in the window of any role: its ceramics and its field. What lies on it a role draws on
    top, and lets the mouse drag where two parameters say its place. [message thread] */
class SurfaceView : public juce::Component, public juce::SettableTooltipClient
{
public:
    void setPicture (std::shared_ptr<const SurfacePicture>);

    /** @param frame  of the picture */
    void setFrame (int frame);

    void paint (juce::Graphics&) final;
    void resized() final { repaint(); }
    void lookAndFeelChanged() final;
    void mouseDrag (const juce::MouseEvent&) override;
    void mouseUp (const juce::MouseEvent&) override { release(); }

protected:
    /** The parameters of a place, in percent of the surface. */
    struct Place
    {
        juce::RangedAudioParameter *x = nullptr, *y = nullptr;
    };

    static constexpr float grabRadius = 14; ///< Pixels.

    SurfaceView (const juce::String& description, const juce::String& tooltip, bool hasColourBar);

    /** Whether there is a picture: what follows has a meaning then alone. */
    bool isShown() const { return picture != nullptr; }
    const ModalModel& model() const { return *picture->model; }
    const Surface& surface() const { return model().surface; }
    bool isLine() const { return painter.isLine(); }
    const PlotFrame& plot() const { return painter.frame(); }

    /** A place in pixels of this component. @param height  where it is drawn on a line, mm/s */
    juce::Point<float> pixels (double xPercent, double yPercent, double height = 0) const;
    juce::Point<float> pixels (const Place&, double height = 0) const;

    /** What lies at pixels, in percent of the surface, which may be beside it. */
    std::pair<double, double> percentAt (juce::Point<float>) const;

    /** Begins a drag. @param offset  of the mouse from the middle of what is dragged */
    void grab (const Place&, juce::Point<float> offset);

    /** Ends it. */
    void release();

    /** Sets both parameters; of a line the first alone. */
    void move (const Place&, double xPercent, double yPercent);

    virtual void paintOnTop (juce::Graphics&) = 0;

private:
    void paintError (juce::Graphics&) const;

    std::shared_ptr<const SurfacePicture> picture;
    SurfacePainter painter;
    int frame = FieldFrames::atFocus;
    Place held;                  ///< None: nothing is dragged.
    juce::Point<float> heldFrom; ///< From its middle.
};
} // namespace antinode
