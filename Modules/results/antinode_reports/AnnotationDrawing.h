#pragma once

#include "Chart.h"
#include "PlotFrame.h"

#include <vector>

namespace antinode
{
/** The room that labels of markers and spans need above a plot. [any] */
float heightAbove (const std::vector<Marker>&, const std::vector<Span>&, const Theme&);

/** The room that labels of limits need at the right of a plot. [any] */
float widthBeside (const std::vector<LimitLine>&, const Theme&);

/** Shades the spans and names them above the plot: below the data. [any] */
void drawSpans (juce::Graphics&, const PlotFrame&, const std::vector<Span>&, const Theme&);

/** Draws the markers through the plot and names them above it, in up to two rows; a name that would touch another is
    left out. [any] */
void drawMarkers (juce::Graphics&, const PlotFrame&, const std::vector<Marker>&, float firstRowBottom, const Theme&);

/** Draws the limits through the plot and names them at its right. [any] */
void drawLimits (juce::Graphics&, const PlotFrame&, const std::vector<LimitLine>&, const Theme&);

/** The lower edge of the first row of marker names: above the names of the spans. [any] */
float markerRowBottom (const PlotFrame&, const std::vector<Span>&, const Theme&);
} // namespace antinode
