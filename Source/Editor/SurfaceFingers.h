#pragma once

#include "History.h"
#include "Palette.h"

#include <antinode_fingers/Finger.h>
#include <antinode_model/Surface.h>
#include <antinode_reports/PlotFrame.h>

#include <functional>
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
} // namespace antinode
