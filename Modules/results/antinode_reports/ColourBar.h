#pragma once

#include "PlotFrame.h"

namespace antinode
{
/** The width that a colour bar with its labels takes at the right of a plot of this height. [any] */
float colourBarWidth (const ChartAxis&, float height, const Theme&);

/** Draws the scale of the colours of a map.
    @param area  as wide as colourBarWidth says [any] */
void drawColourBar (juce::Graphics&, juce::Rectangle<float> area, const ChartAxis&, const ColourMap&, const Theme&);
} // namespace antinode
