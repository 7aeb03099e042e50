#pragma once

#include "HeatMap.h"
#include "PlotFrame.h"

namespace antinode
{
/** Draws the contours of a map. [any] */
void drawContours (juce::Graphics&, const PlotFrame&, const HeatMap&, const Theme&);

/** Draws rectangles with their names where these fit and hide no cross, and crosses with theirs: legible on every
    colour. [any] */
void drawPlaces (juce::Graphics&, const PlotFrame&, const std::vector<MapRectangle>&, const std::vector<MapPoint>&,
                 const Theme&);
} // namespace antinode
