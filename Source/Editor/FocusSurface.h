#pragma once

#include "SurfaceFingers.h"
#include "SurfaceView.h"

#include <Processor/AntinodeProcessor.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace antinode
{
/** The surface with the spot, the probe and fingers. They can be dragged; spot and probe move with arrow keys too, and
    a menu puts fingers on the surface. [message thread] */
class FocusSurface final : public SurfaceView
{
public:
    FocusSurface (AntinodeProcessor&, History&);

    /** Draws spot, probe and fingers where they are. */
    void refresh();

    /** The positions of spot and probe, in pixels of this component. */
    juce::Point<float> spot() const;
    juce::Point<float> probe() const { return pixels (probePlace); }

    SurfaceFingers& fingers() { return touching; }

    /** What can be done with fingers at a place. @param at  in pixels of this component */
    juce::PopupMenu fingerMenu (juce::Point<float> at);

    /** The action of Space and Return. */
    std::function<void()> onFire;

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

    Handle handleAt (juce::Point<float>) const;
    std::optional<std::size_t> fingerAt (juce::Point<float> at) const { return touching.at (at, plot()); }
    std::array<double, 6> values() const;
    juce::Point<double> metresAt (juce::Point<float>) const;
    void nudge (const Place&, double xPercent, double yPercent);
    bool changeFingers (const juce::KeyPress&);
    void paintOnTop (juce::Graphics&) override;
    void paintSpot (juce::Graphics&) const;
    void paintProbe (juce::Graphics&) const;

    juce::RangedAudioParameter *width, *height;
    Place spotPlace, probePlace;
    SurfaceFingers touching;
    std::optional<std::size_t> draggedFinger;
    juce::Point<float> fingerFrom;        ///< The dragged one's middle.
    std::array<double, 6> shownValues {}; ///< Of the parameters above.
};
} // namespace antinode
