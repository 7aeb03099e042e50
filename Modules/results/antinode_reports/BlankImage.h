#pragma once

#include <juce_graphics/juce_graphics.h>

namespace antinode
{
/** An image to draw a picture in, all of one colour: where the size times the scale is no whole number, drawings cover
   the last row and column only in part.
    @param width, height  before the scale
    @return               at least one pixel each way
    [any] */
juce::Image blankImage (int width, int height, float scale, juce::Colour);
} // namespace antinode
