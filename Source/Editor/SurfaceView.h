#pragma once

#include "SurfacePainter.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <memory>
#include <utility>

namespace antinode
{
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
    const Surface& surface() const { return picture->model->surface; }
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
