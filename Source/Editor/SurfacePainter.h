#pragma once

#include "FieldFrames.h"
#include "Palette.h"

#include <antinode_reports/Chart.h>
#include <antinode_reports/PlotFrame.h>

#include <juce_graphics/juce_graphics.h>

#include <memory>
#include <string>

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
} // namespace antinode
