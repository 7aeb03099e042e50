#pragma once

#include "PlotFrame.h"
#include "Theme.h"
#include "Ticks.h"

#include <Eigen/Core>
#include <juce_graphics/juce_graphics.h>

namespace antinode
{
/** A matrix brought to the given number of pixels: interpolated between cells where it is coarser, averaged where it is
   finer.
    @param values  one or more rows and columns
    @return        rows x columns; not finite where a value that takes part is not [any] */
Eigen::MatrixXd resampled (const Eigen::MatrixXd& values, int rows, int columns);

/** A matrix brought to the given number of pixels, each that of the cell that it lies in. [any] */
Eigen::MatrixXd repeated (const Eigen::MatrixXd& values, int rows, int columns);

/** A matrix of pixels as colours, its first row at the bottom; transparent where a value is not finite. [any] */
juce::Image colourImage (const Eigen::MatrixXd& pixels, AxisRange, const ColourMap&);

/** The width that a colour bar with its labels takes at the right of a plot of this height. [any] */
float colourBarWidth (const ChartAxis&, float height, const Theme&);

/** Draws the scale of the colours of a map.
    @param area  as wide as colourBarWidth says [any] */
void drawColourBar (juce::Graphics&, juce::Rectangle<float> area, const ChartAxis&, const ColourMap&, const Theme&);
} // namespace antinode
