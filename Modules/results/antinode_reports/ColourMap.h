#pragma once

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
} // namespace antinode
