#include "Drawing.h"

#include "DxfReader.h"
#include "SvgReader.h"

#include "OutlineChecks.h"
#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** What begins with an element is XML. */
bool looksLikeXml (std::string_view bytes)
{
    const auto first = bytes.find_first_not_of (" \t\r\n\xef\xbb\xbf");
    return first != std::string_view::npos && bytes[first] == '<';
}

/** Edges in the order of the paths, from 0 on. */
void renumberEdges (Outline& outline)
{
    auto next = -1;

    for (auto& path : outline.paths)
    {
        auto drawn = -1;

        for (auto& piece : path)
        {
            next += piece.edge == drawn ? 0 : 1;
            drawn = piece.edge;
            piece.edge = next;
        }
    }
}
} // namespace

Outline outlineFromDrawing (std::string_view bytes, const std::string& source, const DrawingChoice& choice)
{
    if (bytes.substr (0, 2) == "\x1f\x8b")
        throw InputError (source, "is compressed; allowed: SVG and DXF as text");

    const auto isXml = looksLikeXml (bytes);
    auto strokes = isXml ? svgStrokes (bytes, source, choice) : dxfStrokes (bytes, source, choice);
    Outline outline { joinedStrokes (std::move (strokes), choice.joint) };

    if (outline.paths.empty())
        throw InputError (source, "shows no closed path; allowed: an outline, and holes in it");

    // The largest is the outer one; the others stay in the order in which they were drawn.
    const auto largest = std::max_element (outline.paths.begin(), outline.paths.end(),
                                           [] (const ClosedPath& a, const ClosedPath& b)
                                           { return std::abs (signedArea (a)) < std::abs (signedArea (b)); });
    std::rotate (outline.paths.begin(), largest, largest + 1);
    renumberEdges (outline);
    outline = withMonotonePieces (std::move (outline));
    checkOutline (outline, source);
    return outline;
}

Outline readOutlineFile (const std::filesystem::path& path, const DrawingChoice& choice)
{
    constexpr FileKind kind { "an SVG or DXF drawing" };
    return outlineFromDrawing (readWholeFile (path, kind), path.string(), choice);
}
} // namespace antinode
