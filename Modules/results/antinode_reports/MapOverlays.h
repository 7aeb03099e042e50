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

/** A shape of a map as a path on the picture, inside by even and odd. [any] */
juce::Path pathOf (const MapShape&, const PlotFrame&);

/** Draws the outline of a surface over a map, where there is one. [any] */
void drawSurface (juce::Graphics&, const PlotFrame&, const MapShape&, const Theme&);
} // namespace antinode
