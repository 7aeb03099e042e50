#pragma once

#include "EditorLook.h"
#include "History.h"
#include "SurfaceView.h"

#include <Processor/AntinodeProcessor.h>
#include <antinode_fingers/Finger.h>
#include <antinode_model/Surface.h>
#include <antinode_reports/PlotFrame.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The fingers that rest on the surface, as they are shown and changed. Every change is one entry of the history; one
    that the surface does not allow is said and left undone. [message thread] */
class SurfaceFingers
{
public:
    SurfaceFingers (AntinodeProcessor&, History&);

    /** Gets why a change is not allowed, or nothing after one that is. */
    std::function<void (const juce::String&)> say;

    /** Takes the loaded focus's fingers, but for one that is being dragged. @return  whether they have changed */
    bool refresh();

    const std::vector<Finger>& all() const { return fingers; }

    /** The finger under a place, the nearest of several. @param place  pixels */
    std::optional<std::size_t> at (juce::Point<float> place, const PlotFrame&) const;

    /** The middle of a finger in pixels. */
    juce::Point<float> middle (std::size_t finger, const PlotFrame&) const;

    /** @param kind  of builtInFinger()
        @param x, y  m */
    void rest (const std::string& kind, double x, double y);
    void lift (std::size_t finger);
    void liftAll();
    void setKind (std::size_t finger, const std::string& kind);
    void setKnown (std::size_t finger, bool isKnown);

    /** Shows a finger elsewhere while it is dragged. @param x, y  m */
    void drag (std::size_t finger, double x, double y);

    /** Puts the dragged finger down, or lifts it where it lies outside the surface. */
    void drop();

    void paint (juce::Graphics&, const PlotFrame&, const Palette&) const;

private:
    Surface surface() const;
    void change (std::size_t finger, const std::function<void (Finger&)>&);
    void apply (std::vector<Finger>);

    AntinodeProcessor& processor;
    History& history;
    std::shared_ptr<const FocusDocument> shown;
    std::vector<Finger> fingers;
    std::optional<std::size_t> dragged;
};

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
