#pragma once

#include "Chart.h"
#include "PlotFrame.h"

#include <Eigen/Core>

#include <vector>

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

/** A line of equal values through a matrix: places as columns and rows, counted from 0 at the first value. A closed
   line ends where it starts. */
using ContourLine = std::vector<Eigen::Vector2d>;

/** All lines at a level, by marching squares: straight through each square of four values, where a saddle is cut as its
   mean says. Squares with a value that is not finite have none. The same lines in the same order on every run. [any] */
std::vector<ContourLine> contourLines (const Eigen::MatrixXd& values, double level);
} // namespace antinode
