#pragma once

#include "ColourMap.h"
#include "Ticks.h"

#include <juce_graphics/juce_graphics.h>

#include <Eigen/Core>

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
} // namespace antinode
