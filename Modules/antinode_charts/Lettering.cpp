#include "Lettering.h"

#include "Utf8.h"

#include <antinode_fonts.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace antinode
{
namespace
{
/** An outline for a line height of 1, its origin on the baseline. */
struct Glyph
{
    juce::Path outline;
    float advance = 0;
};

/** The glyphs of one font, each loaded once. JUCE's typefaces are not made for several threads: the lock keeps them
    apart. */
class GlyphStore
{
public:
    explicit GlyphStore (std::string_view fontFile)
    {
        for (const auto& file : fonts::files())
            if (fontFile == file.name)
                typeface = juce::Typeface::createSystemTypefaceFor (file.begin, file.text().size());
        if (typeface == nullptr)
            throw std::logic_error ("the font " + std::string (fontFile) + " is not compiled in");
    }

    /** The reference stays valid: nothing is ever removed. */
    const Glyph& find (char32_t codePoint)
    {
        const std::scoped_lock lock (mutex);
        const auto [entry, isNew] = glyphs.try_emplace (codePoint);
        if (isNew)
            load (codePoint, entry->second);
        return entry->second;
    }

    float ascent() const { return typeface->getAscent(); }

private:
    void load (char32_t codePoint, Glyph& glyph) const
    {
        juce::Array<int> numbers;
        juce::Array<float> offsets;
        typeface->getGlyphPositions (juce::String::charToString (static_cast<juce::juce_wchar> (codePoint)), numbers,
                                     offsets);
        if (numbers.isEmpty())
            return;
        typeface->getOutlineForGlyph (numbers.getFirst(), glyph.outline);
        glyph.advance = offsets[1];
    }

    std::mutex mutex;
    juce::Typeface::Ptr typeface;
    std::unordered_map<char32_t, Glyph> glyphs;
};

/** Both fonts. Freed with JUCE's own shared objects, before the checks for leaks at the end of a debug program. */
class Fonts : private juce::DeletedAtShutdown
{
public:
    ~Fonts() override { clearSingletonInstance(); }

    GlyphStore regular { "DejaVuSans.ttf" };
    GlyphStore bold { "DejaVuSans-Bold.ttf" };

    JUCE_DECLARE_SINGLETON (Fonts, false)
};

JUCE_IMPLEMENT_SINGLETON (Fonts)

GlyphStore& findGlyphs (const TextStyle& style)
{
    auto& all = *Fonts::getInstance();
    return style.bold ? all.bold : all.regular;
}

float measureWidth (const std::u32string& text, const TextStyle& style)
{
    auto width = 0.0f;
    for (const auto codePoint : text)
        width += findGlyphs (style).find (codePoint).advance * style.height;
    return width;
}

std::u32string shortened (std::u32string text, float width, const TextStyle& style)
{
    constexpr char32_t ellipsis = 0x2026;
    // A little tolerance: areas are often measured with the very text that goes into them.
    if (measureWidth (text, style) <= width + 0.5f)
        return text;
    while (! text.empty() && measureWidth (text + ellipsis, style) > width)
        text.pop_back();
    return text.empty() ? text : text + ellipsis;
}

juce::Path textOutline (const std::u32string& text, const TextStyle& style)
{
    juce::Path outline;
    auto x = 0.0f;
    for (const auto codePoint : text)
    {
        const auto& glyph = findGlyphs (style).find (codePoint);
        outline.addPath (glyph.outline, juce::AffineTransform::scale (style.height).translated (x, 0));
        x += glyph.advance * style.height;
    }
    return outline;
}
} // namespace

float textWidth (std::string_view utf8, const TextStyle& style)
{
    return measureWidth (decodeUtf8 (utf8), style);
}

void drawText (juce::Graphics& g, std::string_view utf8, juce::Rectangle<float> area, juce::Justification justification,
               const TextStyle& style)
{
    const auto text = shortened (decodeUtf8 (utf8), area.getWidth(), style);
    const auto line = justification.appliedToRectangle ({ measureWidth (text, style), style.height }, area);
    const auto baseline = line.getY() + findGlyphs (style).ascent() * style.height;
    g.setColour (style.colour);
    g.fillPath (textOutline (text, style), juce::AffineTransform::translation (line.getX(), baseline));
}

void drawTextUpwards (juce::Graphics& g, std::string_view utf8, juce::Rectangle<float> area, const TextStyle& style)
{
    constexpr auto smallest = 0.75f;
    const auto width = textWidth (utf8, style);
    auto fitted = style;
    if (width > area.getHeight())
        fitted.height *= std::max (smallest, area.getHeight() / width);
    const juce::Graphics::ScopedSaveState state (g);
    g.addTransform (juce::AffineTransform::rotation (-juce::MathConstants<float>::halfPi)
                        .translated (area.getCentreX(), area.getCentreY()));
    const juce::Rectangle<float> turned (-area.getHeight() / 2, -area.getWidth() / 2, area.getHeight(),
                                         area.getWidth());
    drawText (g, utf8, turned, juce::Justification::centred, fitted);
}
} // namespace antinode
