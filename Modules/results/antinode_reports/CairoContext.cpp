#include "CairoContext.h"

#include <antinode_fonts.h>
#include <cairo-ft.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace antinode
{
namespace
{
cairo_matrix_t matrix (const juce::AffineTransform& t)
{
    return { static_cast<double> (t.mat00), static_cast<double> (t.mat10), static_cast<double> (t.mat01),
             static_cast<double> (t.mat11), static_cast<double> (t.mat02), static_cast<double> (t.mat12) };
}

void addRectangle (cairo_t* cairo, juce::Rectangle<float> area)
{
    const auto r = area.toDouble();
    cairo_rectangle (cairo, r.getX(), r.getY(), r.getWidth(), r.getHeight());
}

void addStops (cairo_pattern_t* pattern, const juce::ColourGradient& gradient, float opacity)
{
    for (int i = 0; i < gradient.getNumColours(); ++i)
    {
        const auto colour = gradient.getColour (i).withMultipliedAlpha (opacity);
        cairo_pattern_add_color_stop_rgba (
            pattern, gradient.getColourPosition (i), static_cast<double> (colour.getFloatRed()),
            static_cast<double> (colour.getFloatGreen()), static_cast<double> (colour.getFloatBlue()),
            static_cast<double> (colour.getFloatAlpha()));
    }
}

CairoPattern gradientPattern (const juce::ColourGradient& gradient, float opacity)
{
    const auto from = gradient.point1.toDouble(), to = gradient.point2.toDouble();
    CairoPattern pattern (
        gradient.isRadial ? cairo_pattern_create_radial (from.x, from.y, 0, from.x, from.y, from.getDistanceFrom (to))
                          : cairo_pattern_create_linear (from.x, from.y, to.x, to.y));
    addStops (pattern.get(), gradient, opacity);
    return pattern;
}

/** The pixels of an image, copied. */
CairoSurface imageSurface (const juce::Image& image)
{
    const auto argb = image.convertedToFormat (juce::Image::ARGB);
    const juce::Image::BitmapData pixels (argb, juce::Image::BitmapData::readOnly);
    CairoSurface surface (cairo_image_surface_create (CAIRO_FORMAT_ARGB32, pixels.width, pixels.height));
    cairo_surface_flush (surface.get());
    auto* to = cairo_image_surface_get_data (surface.get());
    const auto stride = cairo_image_surface_get_stride (surface.get());

    // Both hold premultiplied ARGB in the order of the machine.
    for (int y = 0; y < pixels.height; ++y)
        std::copy_n (pixels.getLinePointer (y), 4 * pixels.width, to + y * stride);

    cairo_surface_mark_dirty (surface.get());
    return surface;
}

cairo_filter_t filter (juce::Graphics::ResamplingQuality quality)
{
    return quality == juce::Graphics::lowResamplingQuality ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD;
}
} // namespace

void CairoContext::setOrigin (juce::Point<int> origin)
{
    cairo_translate (cairo, origin.x, origin.y);
}

void CairoContext::addTransform (const juce::AffineTransform& transform)
{
    const auto m = matrix (transform);
    cairo_transform (cairo, &m);
}

bool CairoContext::clipToRectangle (const juce::Rectangle<int>& area)
{
    addRectangle (cairo, area.toFloat());
    cairo_clip (cairo);
    return ! isClipEmpty();
}

bool CairoContext::clipToRectangleList (const juce::RectangleList<int>& areas)
{
    for (const auto& area : areas)
        addRectangle (cairo, area.toFloat());

    cairo_clip (cairo);
    return ! isClipEmpty();
}

void CairoContext::excludeClipRectangle (const juce::Rectangle<int>& area)
{
    addRectangle (cairo, getClipBounds().toFloat());
    addRectangle (cairo, area.toFloat());
    cairo_set_fill_rule (cairo, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_clip (cairo);
}

void CairoContext::clipToPath (const juce::Path& path, const juce::AffineTransform& transform)
{
    usePath (path, transform);
    cairo_clip (cairo);
}

void CairoContext::clipToImageAlpha (const juce::Image&, const juce::AffineTransform&)
{
    throw std::logic_error ("a drawing for print cannot be clipped to an image");
}

bool CairoContext::clipRegionIntersects (const juce::Rectangle<int>& area)
{
    return getClipBounds().intersects (area);
}

juce::Rectangle<int> CairoContext::getClipBounds() const
{
    double left = 0, top = 0, right = 0, bottom = 0;
    cairo_clip_extents (cairo, &left, &top, &right, &bottom);
    return juce::Rectangle<double>::leftTopRightBottom (left, top, right, bottom).getSmallestIntegerContainer();
}

void CairoContext::saveState()
{
    cairo_save (cairo);
    saved.push_back (state);
}

void CairoContext::restoreState()
{
    cairo_restore (cairo);
    state = saved.back();
    saved.pop_back();
}

void CairoContext::beginTransparencyLayer (float opacity)
{
    saveState();
    cairo_push_group (cairo);
    layerOpacities.push_back (opacity);
}

void CairoContext::endTransparencyLayer()
{
    cairo_pop_group_to_source (cairo);
    cairo_paint_with_alpha (cairo, static_cast<double> (layerOpacities.back()));
    layerOpacities.pop_back();
    restoreState();
}

void CairoContext::fillRect (const juce::Rectangle<int>& area, bool)
{
    fillRect (area.toFloat());
}

void CairoContext::fillRect (const juce::Rectangle<float>& area)
{
    addRectangle (cairo, area);
    fill();
}

void CairoContext::fillRectList (const juce::RectangleList<float>& areas)
{
    for (const auto& area : areas)
        addRectangle (cairo, area);

    fill();
}

void CairoContext::fillPath (const juce::Path& path, const juce::AffineTransform& transform)
{
    usePath (path, transform);
    fill();
}

void CairoContext::drawImage (const juce::Image& image, const juce::AffineTransform& transform)
{
    const auto surface = imageSurface (image);
    cairo_save (cairo);
    addTransform (transform);
    cairo_set_source_surface (cairo, surface.get(), 0, 0);
    cairo_pattern_set_filter (cairo_get_source (cairo), filter (state.quality));
    cairo_paint_with_alpha (cairo, static_cast<double> (state.fill.getOpacity()));
    cairo_restore (cairo);
}

void CairoContext::drawLine (const juce::Line<float>& line)
{
    juce::Path path;
    path.addLineSegment (line, 1);
    fillPath (path, {});
}

void CairoContext::showGlyph (int glyphNumber, const juce::AffineTransform& transform)
{
    const auto outline = glyphOutline (*state.font.getTypefacePtr(), glyphNumber);
    const auto height = state.font.getHeight();
    fillPath (outline,
              juce::AffineTransform::scale (height * state.font.getHorizontalScale(), height).followedBy (transform));
}

void CairoContext::showText (const PlacedText& text)
{
    useFill();
    CairoFonts::shared().show (cairo, text);
}

/** Makes it the path of Cairo. */
void CairoContext::usePath (const juce::Path& path, const juce::AffineTransform& transform)
{
    const auto at = [&transform] (float x, float y)
    { return juce::Point<float> (x, y).transformedBy (transform).toDouble(); };
    cairo_new_path (cairo);
    juce::Point<double> last;

    for (juce::Path::Iterator i (path); i.next();)
    {
        const auto one = at (i.x1, i.y1);

        switch (i.elementType)
        {
            case juce::Path::Iterator::startNewSubPath:
                cairo_move_to (cairo, one.x, one.y);
                last = one;
                break;
            case juce::Path::Iterator::lineTo:
                cairo_line_to (cairo, one.x, one.y);
                last = one;
                break;
            case juce::Path::Iterator::quadraticTo:
            {
                // The cubic that is the same curve.
                const auto end = at (i.x2, i.y2), first = last + (one - last) * (2.0 / 3),
                           second = end + (one - end) * (2.0 / 3);
                cairo_curve_to (cairo, first.x, first.y, second.x, second.y, end.x, end.y);
                last = end;
                break;
            }
            case juce::Path::Iterator::cubicTo:
            {
                const auto two = at (i.x2, i.y2), end = at (i.x3, i.y3);
                cairo_curve_to (cairo, one.x, one.y, two.x, two.y, end.x, end.y);
                last = end;
                break;
            }
            case juce::Path::Iterator::closePath:
                cairo_close_path (cairo);
                break;
        }
    }

    cairo_set_fill_rule (cairo, path.isUsingNonZeroWinding() ? CAIRO_FILL_RULE_WINDING : CAIRO_FILL_RULE_EVEN_ODD);
}

/** Makes the fill the source of Cairo. */
void CairoContext::useFill()
{
    const auto opacity = state.fill.getOpacity();

    if (state.fill.isColour())
    {
        const auto colour = state.fill.colour;
        cairo_set_source_rgba (
            cairo, static_cast<double> (colour.getFloatRed()), static_cast<double> (colour.getFloatGreen()),
            static_cast<double> (colour.getFloatBlue()), static_cast<double> (colour.getFloatAlpha()));
        return;
    }

    auto toPattern = matrix (state.fill.transform);
    cairo_matrix_invert (&toPattern);
    const auto pattern = state.fill.isGradient()
                             ? gradientPattern (*state.fill.gradient, opacity)
                             : CairoPattern (cairo_pattern_create_for_surface (imageSurface (state.fill.image).get()));
    cairo_pattern_set_matrix (pattern.get(), &toPattern);

    if (state.fill.isTiledImage())
        cairo_pattern_set_extend (pattern.get(), CAIRO_EXTEND_REPEAT);

    cairo_set_source (cairo, pattern.get());
}

void CairoContext::fill()
{
    useFill();
    cairo_fill (cairo);
}

/** A font file that is compiled in. */
class CairoFonts::Font
{
public:
    Font (FT_Library freeType, std::string_view name)
    {
        for (const auto& file : fonts::files())
            if (name == file.name)
                FT_New_Memory_Face (freeType, reinterpret_cast<const FT_Byte*> (file.begin),
                                    static_cast<FT_Long> (file.text().size()), 0, &face);

        if (face == nullptr)
            throw std::logic_error ("the font " + std::string (name) + " is not compiled in");

        font = cairo_ft_font_face_create_for_ft_face (face, FT_LOAD_NO_HINTING);
    }

    /** Em of a line height of 1. */
    double em() const { return static_cast<double> (face->units_per_EM) / (face->ascender - face->descender); }

    unsigned long glyph (char32_t character) const { return FT_Get_Char_Index (face, character); }
    cairo_font_face_t* get() const { return font; }

private:
    FT_Face face = nullptr;
    cairo_font_face_t* font = nullptr;
};

CairoFonts::CairoFonts()
{
    FT_Library freeType = nullptr;

    if (FT_Init_FreeType (&freeType) != 0)
        throw std::runtime_error ("FreeType cannot be started");

    regular = std::make_unique<Font> (freeType, "DejaVuSans.ttf");
    bold = std::make_unique<Font> (freeType, "DejaVuSans-Bold.ttf");
}

CairoFonts::~CairoFonts() = default;

const CairoFonts& CairoFonts::shared()
{
    // To the end of the program: Cairo keeps fonts that it has drawn with.
    static const auto* const fonts = new CairoFonts;
    return *fonts;
}

void CairoFonts::show (cairo_t* cairo, const PlacedText& text) const
{
    static std::mutex mutex; // FreeType's faces are for one thread at a time.
    const std::lock_guard lock (mutex);
    const auto& font = text.isBold ? *bold : *regular;
    std::string utf8;
    std::vector<cairo_glyph_t> glyphs;
    std::vector<cairo_text_cluster_t> clusters;

    for (std::size_t i = 0; i < text.characters.size(); ++i)
    {
        const auto character =
            juce::String::charToString (static_cast<juce::juce_wchar> (text.characters[i])).toStdString();
        utf8 += character;
        clusters.push_back ({ static_cast<int> (character.size()), 1 });
        glyphs.push_back ({ font.glyph (text.characters[i]), static_cast<double> (text.start.x + text.offsets[i]),
                            static_cast<double> (text.start.y) });
    }

    cairo_set_font_face (cairo, font.get());
    cairo_set_font_size (cairo, font.em() * static_cast<double> (text.height));
    const auto count = static_cast<int> (glyphs.size());
    cairo_show_text_glyphs (cairo, utf8.data(), static_cast<int> (utf8.size()), glyphs.data(), count, clusters.data(),
                            count, static_cast<cairo_text_cluster_flags_t> (0));
}
} // namespace antinode
