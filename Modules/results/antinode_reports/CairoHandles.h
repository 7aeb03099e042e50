#pragma once

#include <cairo.h>

#include <memory>

namespace antinode
{
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
