#pragma once

#include "Lettering.h"
#include "Typefaces.h"
#include "VectorContext.h"

#include <cairo.h>

#include <memory>
#include <vector>

namespace antinode
{
/** What juce::Graphics draws, drawn by Cairo: lines stay lines, text stays text. [worker] */
class CairoContext : public VectorContext, public TextDrawing
{
public:
    /** @param target  outlives it */
    explicit CairoContext (cairo_t* target) : cairo (target) {}

    void setOrigin (juce::Point<int>) override;
    void addTransform (const juce::AffineTransform&) override;

    bool clipToRectangle (const juce::Rectangle<int>&) override;
    bool clipToRectangleList (const juce::RectangleList<int>&) override;
    void excludeClipRectangle (const juce::Rectangle<int>&) override;
    void clipToPath (const juce::Path&, const juce::AffineTransform&) override;

    /** @throws std::logic_error  always: no chart clips to an image */
    void clipToImageAlpha (const juce::Image&, const juce::AffineTransform&) override;
    bool clipRegionIntersects (const juce::Rectangle<int>&) override;
    juce::Rectangle<int> getClipBounds() const override;
    bool isClipEmpty() const override { return getClipBounds().isEmpty(); }

    void saveState() override;
    void restoreState() override;
    void beginTransparencyLayer (float opacity) override;
    void endTransparencyLayer() override;

    void setFill (const juce::FillType& fill) override { state.fill = fill; }
    void setOpacity (float opacity) override { state.fill.setOpacity (opacity); }
    void setInterpolationQuality (juce::Graphics::ResamplingQuality quality) override { state.quality = quality; }

    void fillRect (const juce::Rectangle<int>&, bool replaceExistingContents) override;
    void fillRect (const juce::Rectangle<float>&) override;
    void fillRectList (const juce::RectangleList<float>&) override;
    void fillPath (const juce::Path&, const juce::AffineTransform&) override;
    void drawImage (const juce::Image&, const juce::AffineTransform&) override;
    void drawLine (const juce::Line<float>&) override;

    void setFont (const juce::Font& font) override { state.font = font; }
    const juce::Font& getFont() override { return state.font; }
    void showGlyph (int glyphNumber, const juce::AffineTransform&) override;

    void showText (const PlacedText&) override;

private:
    struct State
    {
        juce::FillType fill;
        juce::Font font = anyFont();
        juce::Graphics::ResamplingQuality quality = juce::Graphics::mediumResamplingQuality;
    };

    void usePath (const juce::Path&, const juce::AffineTransform&);
    void useFill();
    void fill();

    cairo_t* cairo;
    State state;
    std::vector<State> saved;
    std::vector<float> layerOpacities;
};

/** The compiled-in fonts for Cairo, which embeds what is used of them. */
class CairoFonts
{
public:
    /** [worker] */
    static const CairoFonts& shared();

    /** Draws a text with Cairo's source. [worker] */
    void show (cairo_t*, const PlacedText&) const;

private:
    class Font;

    CairoFonts();
    ~CairoFonts();

    std::unique_ptr<Font> regular, bold;
};

/** Releases what Cairo counts. */
struct CairoRelease
{
    void operator() (cairo_t* cairo) const { cairo_destroy (cairo); }
    void operator() (cairo_surface_t* surface) const { cairo_surface_destroy (surface); }
    void operator() (cairo_pattern_t* pattern) const { cairo_pattern_destroy (pattern); }
};

using CairoDrawing = std::unique_ptr<cairo_t, CairoRelease>;
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoRelease>;
using CairoPattern = std::unique_ptr<cairo_pattern_t, CairoRelease>;
} // namespace antinode
