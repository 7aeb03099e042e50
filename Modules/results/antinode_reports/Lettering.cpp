#include "Lettering.h"

#include "Typefaces.h"
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

    float ascent() const { return ascentOf (*typeface); }

private:
    void load (char32_t codePoint, Glyph& glyph) const
    {
        juce::Array<int> numbers;
        juce::Array<float> offsets;
        findGlyphPositions (*typeface, juce::String::charToString (static_cast<juce::juce_wchar> (codePoint)), numbers,
                            offsets);
        if (numbers.isEmpty())
            return;
        glyph.outline = glyphOutline (*typeface, numbers.getFirst());
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

/** The offset of each character from the start of the line. */
std::vector<float> characterOffsets (const std::u32string& text, const TextStyle& style)
{
    std::vector<float> offsets;
    auto x = 0.0f;
    for (const auto codePoint : text)
    {
        offsets.push_back (x);
        x += findGlyphs (style).find (codePoint).advance * style.height;
    }
    return offsets;
}

juce::Path textOutline (const PlacedText& text, const TextStyle& style)
{
    juce::Path outline;
    for (std::size_t i = 0; i < text.characters.size(); ++i)
        outline.addPath (
            findGlyphs (style).find (text.characters[i]).outline,
            juce::AffineTransform::scale (text.height).translated (text.offsets[i] + text.start.x, text.start.y));
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
    const auto offsets = characterOffsets (text, style);
    const PlacedText placed { text, offsets, { line.getX(), baseline }, style.height, style.bold };
    g.setColour (style.colour);
    if (auto* const drawing = dynamic_cast<TextDrawing*> (&g.getInternalContext()))
        drawing->showText (placed);
    else
        g.fillPath (textOutline (placed, style));
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
