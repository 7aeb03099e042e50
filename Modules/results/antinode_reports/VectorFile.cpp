#include "VectorFile.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace antinode
{
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

VectorFile::VectorFile (VectorFormat formatToWrite, int width, int height)
    : format (formatToWrite), surface (makeSurface (format, bytes, width * pointsPerPixel, height * pointsPerPixel)),
      drawing (cairo_create (surface.get())), context (drawing.get()), drawn (context)
{
    cairo_scale (drawing.get(), pointsPerPixel, pointsPerPixel);
}

std::string VectorFile::finish()
{
    requireSuccess (cairo_status (drawing.get()));
    cairo_surface_finish (surface.get());
    requireSuccess (cairo_surface_status (surface.get()));
    return format == VectorFormat::svg ? renumbered (bytes) : std::move (bytes);
}
} // namespace antinode
