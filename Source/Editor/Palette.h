#pragma once

#include <antinode_reports/Theme.h>

#include <juce_graphics/juce_graphics.h>

namespace antinode
{
/** The colours of the editor: those of the charts, and what they have no need of. */
struct Palette
{
    Theme charts;         ///< How charts look inside of it.
    juce::Colour window;  ///< Between the panels.
    juce::Colour panel;   ///< The charts' background.
    juce::Colour raised;  ///< Controls.
    juce::Colour outline; ///< Round panels and controls.
    juce::Colour text, mutedText;
    juce::Colour accent;   ///< Values, and what has the keyboard.
    juce::Colour fire;     ///< The wanted spot and what fires it.
    juce::Colour armed;    ///< Outputs that play.
    juce::Colour warning;  ///< Limits, errors, STOP.
    juce::Colour caution;  ///< What plays, but not all of it.
    juce::Colour onStrong; ///< Text on the strong colours above.
    bool isDark = true;

    /** [any] */
    static const Palette& dark();
    static const Palette& light();
};
} // namespace antinode
