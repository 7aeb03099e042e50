#pragma once

#include <juce_graphics/juce_graphics.h>

#include <cstdint>

namespace antinode
{
/** A context whose pixels have the size of its units, as JUCE 7 and JUCE 8 ask it: 8 hands on glyphs by the line. */
class VectorContext : public juce::LowLevelGraphicsContext
{
public:
    bool isVectorDevice() const override { return true; }

    /** Draws a glyph of the font that is set. */
    virtual void showGlyph (int glyphNumber, const juce::AffineTransform&) = 0;

#if JUCE_MAJOR_VERSION >= 8
    float getPhysicalPixelScaleFactor() const override
    {
        return 1;
    }
    std::uint64_t getFrameId() const override
    {
        return 0;
    }

    void drawGlyphs (juce::Span<const std::uint16_t> glyphs, juce::Span<const juce::Point<float>> places,
                     const juce::AffineTransform& transform) override
    {
        for (std::size_t i = 0; i < glyphs.size(); ++i)
            showGlyph (glyphs[i], juce::AffineTransform::translation (places[i]).followedBy (transform));
    }
#else
    float getPhysicalPixelScaleFactor() override
    {
        return 1;
    }
    void drawGlyph (int number, const juce::AffineTransform& transform) override
    {
        showGlyph (number, transform);
    }
#endif
};
} // namespace antinode
