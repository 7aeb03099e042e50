#pragma once

#include "MotionView.h"

#include <Editor/SurfacePainter.h>

#include "PlateProcessor.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>

namespace antinode
{
/** The surface from above, slowly: the frames of a captured window one after the other, and the probes, which can
    be dragged. [message thread] */
class MotionSurface final : public juce::Component, public juce::SettableTooltipClient
{
public:
    explicit MotionSurface (PlateProcessor&);

    void setPicture (std::shared_ptr<const MotionPicture>);

    /** @param frame  of the picture's window */
    void setFrame (int frame);

    /** Draws the probes where the parameters say. */
    void refresh();

    /** Where a probe stands, in pixels of this component. */
    juce::Point<float> probe (int index) const;

    void paint (juce::Graphics&) override;
    void resized() override { repaint(); }
    void lookAndFeelChanged() override;
    void mouseDown (const juce::MouseEvent&) override;
    void mouseDrag (const juce::MouseEvent&) override;
    void mouseUp (const juce::MouseEvent&) override;

private:
    static constexpr int none = -1;

    int probeAt (juce::Point<float>) const;
    void paintProbe (juce::Graphics&, int index) const;

    PlateProcessor& processor;
    std::shared_ptr<const MotionPicture> picture;
    SurfacePainter painter;
    int frame = 0, dragged = none, shownProbes = 0;
    SurfaceSettings shown;
};
} // namespace antinode
