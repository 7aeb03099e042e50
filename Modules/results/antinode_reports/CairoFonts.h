#pragma once

#include "Lettering.h"

#include <cairo.h>

#include <memory>

namespace antinode
{
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
} // namespace antinode
