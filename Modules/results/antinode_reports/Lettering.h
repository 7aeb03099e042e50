#pragma once

#include <juce_graphics/juce_graphics.h>

#include <string_view>
#include <vector>

namespace antinode
{
/** One line of text, character by character. */
struct PlacedText
{
    std::u32string_view characters;
    const std::vector<float>& offsets; ///< Of each character from the start.
    juce::Point<float> start;          ///< On the baseline.
    float height = 0;                  ///< Of a line.
    bool isBold = false;
};

/** A drawing that keeps text as text, as files for print do; others get outlines. */
class TextDrawing
{
public:
    virtual ~TextDrawing() = default;
    virtual void showText (const PlacedText&) = 0;
};

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
