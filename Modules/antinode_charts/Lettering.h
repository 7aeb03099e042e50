#pragma once

#include <juce_graphics/juce_graphics.h>

#include <string_view>

namespace antinode
{
/** The style of text. */
struct TextStyle
{
    float height = 13; ///< Of a line, in pixels at scale 1.
    bool bold = false;
    juce::Colour colour;
};

/** The width of a text in pixels at scale 1. The font is compiled in: no machine needs one. [any] */
float textWidth (std::string_view utf8, const TextStyle&);

/** Draws one line, shortened with an ellipsis where it is wider than its area. Glyphs are filled outlines that all
   threads share: any number of threads may draw, each on its own Graphics. [any] */
void drawText (juce::Graphics&, std::string_view utf8, juce::Rectangle<float> area, juce::Justification,
               const TextStyle&);

/** Draws one line that reads upwards, in the middle of its area; made smaller, then shortened, where it is longer.
    [any] */
void drawTextUpwards (juce::Graphics&, std::string_view utf8, juce::Rectangle<float> area, const TextStyle&);
} // namespace antinode
