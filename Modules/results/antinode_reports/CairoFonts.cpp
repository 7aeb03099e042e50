#include "CairoFonts.h"

#include <antinode_fonts.h>

#include <cairo-ft.h>

#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace antinode
{
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
