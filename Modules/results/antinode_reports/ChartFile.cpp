#include "ChartFile.h"

#include "CairoContext.h"
#include "Drawing.h"
#include "Theme.h"
#include "Ticks.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <juce_graphics/juce_graphics.h>
#include <png.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string_view>

namespace antinode
{
namespace
{
void requireSize (int width, int height, float scale)
{
    if (width < 16 || height < 16 || width > 8192 || height > 8192)
        throw InputError ("picture", "is " + std::to_string (width) + " x " + std::to_string (height)
                                         + " pixels; allowed: 16 to 8192 in each direction");
    if (! (scale >= 0.25f && scale <= 8.0f))
        throw InputError ("picture", "has scale " + formatNumber (scale) + "; allowed: 0.25 to 8");
}

// libpng's quick setting: up to twice the bytes of JUCE's writer in a fifth of its time. Encoding, not drawing,
// dominates.
std::string encodePng (const juce::Image& image)
{
    const juce::Image::BitmapData pixels (image, juce::Image::BitmapData::readOnly);
    png_image header {};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32> (pixels.width);
    header.height = static_cast<png_uint_32> (pixels.height);
    header.format = PNG_FORMAT_BGR;
    header.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX (header);
    std::string bytes (size, '\0');
    if (png_image_write_to_memory (&header, bytes.data(), &size, 0, pixels.data, pixels.lineStride, nullptr) == 0)
        throw std::runtime_error (std::string ("the picture could not be written: ") + header.message);
    bytes.resize (size);
    bytes.shrink_to_fit();
    return bytes;
}
} // namespace

std::string renderPng (const Chart& chart, int width, int height, float scale, const Theme& theme)
{
    requireSize (width, height, scale);
    checkWatch();
    const auto image = blankImage (width, height, scale, theme.background);
    {
        juce::Graphics g (image);
        g.addTransform (juce::AffineTransform::scale (scale));
        draw (g, juce::Rectangle<int> (width, height).toFloat(), chart, theme);
    }
    checkWatch();
    return encodePng (image);
}

namespace
{
constexpr auto pointsPerPixel = 72 / 25.4 / 5; // 5 pixels are 1 mm

cairo_status_t append (void* bytes, const unsigned char* data, unsigned int count)
{
    static_cast<std::string*> (bytes)->append (reinterpret_cast<const char*> (data), count);
    return CAIRO_STATUS_SUCCESS;
}

CairoSurface makeSurface (VectorFormat format, std::string& bytes, double width, double height)
{
    if (format == VectorFormat::svg)
    {
        CairoSurface surface (cairo_svg_surface_create_for_stream (append, &bytes, width, height));
        cairo_svg_surface_set_document_unit (surface.get(), CAIRO_SVG_UNIT_PT);
        return surface;
    }

    CairoSurface surface (cairo_pdf_surface_create_for_stream (append, &bytes, width, height));
    // The same bytes on every run: no date of today.
    cairo_pdf_surface_set_metadata (surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    cairo_pdf_surface_set_metadata (surface.get(), CAIRO_PDF_METADATA_CREATOR, "Antinode " ANTINODE_VERSION);
    return surface;
}

/** Cairo numbers what it names over the whole run of a program; numbered from the first of a file, equal figures are
   equal bytes. */
std::string renumbered (const std::string& svg)
{
    constexpr std::string_view definition = "id=\"", reference = "#";
    std::map<std::string, std::string> names;
    std::string result;

    for (std::size_t from = 0; from < svg.size();)
    {
        const auto next = std::min (svg.find (definition, from), svg.find (reference, from));
        const auto begin = next == std::string::npos ? svg.size() : next + (svg[next] == '#' ? 1 : definition.size());
        const auto end = std::min (svg.find_first_of ("\")", begin), svg.size());
        result.append (svg, from, begin - from);
        from = end;

        if (begin < end)
        {
            const auto name = svg.substr (begin, end - begin);
            const auto [entry, isNew] = names.try_emplace (name);

            if (isNew)
                entry->second = name.substr (0, name.find_first_of ("0123456789")) + std::to_string (names.size());

            result += entry->second;
        }
    }

    return result;
}

void requireSuccess (cairo_status_t status)
{
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error (std::string ("the figure could not be drawn: ") + cairo_status_to_string (status));
}
} // namespace

std::string renderVector (const Chart& chart, int width, int height, VectorFormat format)
{
    if (width < 16 || height < 16 || width > 8192 || height > 8192)
        throw InputError ("figure", "is " + std::to_string (width) + " x " + std::to_string (height)
                                        + " pixels; allowed: 16 to 8192 in each direction");

    checkWatch();
    std::string bytes;
    const auto surface = makeSurface (format, bytes, width * pointsPerPixel, height * pointsPerPixel);
    {
        const CairoDrawing drawing (cairo_create (surface.get()));
        cairo_scale (drawing.get(), pointsPerPixel, pointsPerPixel);
        CairoContext context (drawing.get());
        juce::Graphics g (context);
        draw (g, juce::Rectangle<int> (width, height).toFloat(), chart, Theme::print());
        requireSuccess (cairo_status (drawing.get()));
    }
    cairo_surface_finish (surface.get());
    requireSuccess (cairo_surface_status (surface.get()));
    return format == VectorFormat::svg ? renumbered (bytes) : bytes;
}
} // namespace antinode
