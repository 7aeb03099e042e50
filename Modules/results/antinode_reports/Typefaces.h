#pragma once

#include <juce_graphics/juce_graphics.h>

namespace antinode
{
// What typefaces say, as JUCE 7 and JUCE 8 ask them: 8 has two kinds of metrics, and its old one is that of 7. [worker]

/** The glyphs of a text and where each begins, with the end of the last, for a line height of 1. */
inline void findGlyphPositions (juce::Typeface& typeface, const juce::String& text, juce::Array<int>& glyphs,
                                juce::Array<float>& offsets)
{
#if JUCE_MAJOR_VERSION >= 8
    typeface.getGlyphPositions (juce::TypefaceMetricsKind::legacy, text, glyphs, offsets);
#else
    typeface.getGlyphPositions (text, glyphs, offsets);
#endif
}

/** The outline of a glyph for a line height of 1, its origin on the baseline. */
inline juce::Path glyphOutline (juce::Typeface& typeface, int glyph)
{
    juce::Path outline;
#if JUCE_MAJOR_VERSION >= 8
    typeface.getOutlineForGlyph (juce::TypefaceMetricsKind::legacy, glyph, outline);
#else
    typeface.getOutlineForGlyph (glyph, outline);
#endif
    return outline;
}

/** How far the line reaches above the baseline, of its height. */
inline float ascentOf (const juce::Typeface& typeface)
{
#if JUCE_MAJOR_VERSION >= 8
    return typeface.getMetrics (juce::TypefaceMetricsKind::legacy).ascent;
#else
    return typeface.getAscent();
#endif
}

/** A font of JUCE's own choice. */
inline juce::Font anyFont()
{
#if JUCE_MAJOR_VERSION >= 8
    return juce::Font (juce::FontOptions());
#else
    return {};
#endif
}
} // namespace antinode
