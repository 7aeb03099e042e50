#pragma once

#include "SurfaceFingers.h"
#include "SurfacePainter.h"

#include <Processor/AntinodeProcessor.h>

#include <functional>
#include <memory>
#include <optional>

namespace antinode
{
/** The plate or beam from above: ceramics, field, spot, probe and fingers. They can be dragged; spot and probe move
   with arrow keys too, and a menu puts fingers on the surface. [message thread] */
class SurfaceView : public juce::Component, public juce::SettableTooltipClient
{
public:
    SurfaceView (AntinodeProcessor&, History&);

    void setPicture (std::shared_ptr<const DesignPicture>);

    /** @param frame  of FieldFrames */
    void setFrame (int frame);

    /** Draws the spot and the probe where the parameters say. */
    void refresh();

    /** The positions of spot and probe, in pixels of this component. */
    juce::Point<float> spot() const { return pixelPlace (*spotX, *spotY, shownSpotHeight()); }
    juce::Point<float> probe() const { return pixelPlace (*probeX, *probeY, 0); }

    SurfaceFingers& fingers() { return touching; }

    /** What can be done with fingers at a place. @param place  in pixels of this component */
    juce::PopupMenu fingerMenu (juce::Point<float> place);

    /** The action of Space and Return. */
    std::function<void()> onFire;

    void paint (juce::Graphics&) override;
    void resized() override { repaint(); }
    void lookAndFeelChanged() override;
    void mouseMove (const juce::MouseEvent&) override;
    void mouseDown (const juce::MouseEvent&) override;
    void mouseDrag (const juce::MouseEvent&) override;
    void mouseUp (const juce::MouseEvent&) override;
    bool keyPressed (const juce::KeyPress&) override;
    void focusGained (FocusChangeType) override { repaint(); }
    void focusLost (FocusChangeType) override { repaint(); }
    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

private:
    enum class Handle
    {
        none,
        spot,
        probe,
        finger
    };

    juce::Point<float> pixelPlace (const juce::RangedAudioParameter& x, const juce::RangedAudioParameter& y,
                                   double lineHeight) const;
    double shownSpotHeight() const;
    Handle handleAt (juce::Point<float>) const;
    std::optional<std::size_t> fingerAt (juce::Point<float>) const;
    juce::RangedAudioParameter* horizontal (Handle) const;
    juce::RangedAudioParameter* vertical (Handle) const;
    juce::Point<float> middleOf (Handle) const;
    void moveHandle (juce::Point<float>);
    void moveFinger (juce::Point<float>);
    bool changeFingers (const juce::KeyPress&);
    juce::Point<double> surfacePlace (juce::Point<float>) const;
    void nudge (Handle, float xPercent, float yPercent);
    void paintSpot (juce::Graphics&) const;
    void paintProbe (juce::Graphics&) const;
    void paintMessage (juce::Graphics&) const;

    AntinodeProcessor& processor;
    juce::RangedAudioParameter *spotX, *spotY, *probeX, *probeY, *width, *height;
    std::shared_ptr<const DesignPicture> picture;
    SurfacePainter painter;
    SurfaceFingers touching;
    std::size_t draggedFinger = 0;
    int frame = FieldFrames::atFocus;
    Handle dragged = Handle::none;
    juce::Point<float> grabbedAt;         ///< From the handle's middle.
    std::array<double, 6> shownValues {}; ///< Of the parameters above.
};
} // namespace antinode
