#pragma once

#include "Chart.h"

#include <juce_graphics/juce_graphics.h>

#include <vector>

namespace antinode
{
/** Colours for values from 0 to 1, from few evenly spaced stops, mixed in Oklab so that equal steps look equal. */
class ColourMap
{
public:
    /** @param stops  2 or more */
    explicit ColourMap (const std::vector<juce::Colour>& stops);

    /** The colour of a value; values outside 0 to 1 get the ends. [any] */
    juce::Colour at (double value) const;

private:
    std::vector<juce::Colour> table;
};

/** The look of all drawings: one value for the screen, the report and print. Sizes in pixels at scale 1.
    The series' colours are those of Okabe and Ito ("Color Universal Design", 2008), distinguished with every kind of
   colour vision, made darker or lighter where the background needs it. */
struct Theme
{
    juce::Colour background, plotBackground, grid, axis, text, mutedText;
    juce::Colour limit; ///< Limits, and values beyond them.
    juce::Colour span;  ///< Shaded parts of an axis.
    std::vector<juce::Colour> series;
    ColourMap sequential, diverging;
    float titleHeight = 17, labelHeight = 14, tickHeight = 13; ///< Line heights of the text.
    bool boldTitle = true;
    float lineWidth = 1.6f;
    float padding = 12; ///< Round a chart.

    /** For a white page. [any] */
    static const Theme& light();

    /** For a dark page. [any] */
    static const Theme& dark();

    /** For print: black on white, thin lines, small titles. [any] */
    static const Theme& print();
};

/** The same theme for smaller panels: smaller text, thinner lines. [any] */
Theme compact (Theme);

/** The colour of a series.
    @param colour  as chosen in the chart
    @param order   the place of the series in it, from 0 [any] */
juce::Colour seriesColour (const Theme&, int colour, std::size_t order);
} // namespace antinode
