#include "ModalBoundary.h"

#include "OutlineReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_model/BoundedSurface.h>
#include <antinode_text/PhysicalRanges.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace antinode
{
namespace
{
/** The pieces of an outline whose edges have the names. */
std::vector<PathPiece> heldPieces (const NamedOutline& named, const JsonValue& list)
{
    std::set<int> held;

    for (const auto& item : list.items (0, ranges::maximumPoints))
    {
        const auto name = item.text (ranges::maximumNameBytes);
        const auto found = std::find (named.edges.begin(), named.edges.end(), name);

        if (found == named.edges.end())
            item.fail ("is " + inQuotes (name)
                       + ", no edge of the outline; allowed: " + listed ({ named.edges.begin(), named.edges.end() }));

        held.insert (static_cast<int> (found - named.edges.begin()));
    }

    std::vector<PathPiece> pieces;

    for (const auto& path : named.outline.paths)
        std::copy_if (path.begin(), path.end(), std::back_inserter (pieces),
                      [&] (const PathPiece& piece) { return held.contains (piece.edge); });

    return pieces;
}
} // namespace

void readBoundary (const JsonObject& device, Surface& surface)
{
    const auto given = device.optional ("outline");
    const auto edges = device.optional ("held_edges");

    if (! given)
    {
        if (edges)
            edges->fail ("is given without an outline; allowed: with \"outline\"");

        return;
    }

    const auto named = readOutline (*given);
    SurfaceBoundary boundary { named.outline, edges ? heldPieces (named, *edges) : std::vector<PathPiece> {} };

    try
    {
        surface = boundedBy (surface, std::move (boundary));
    }
    catch (const InputError& error)
    {
        given->fail (error.what());
    }
}

void boundaryToJson (nlohmann::ordered_json& device, const SurfaceBoundary& boundary)
{
    const auto isHeld = [&] (const PathPiece& piece)
    {
        return std::any_of (boundary.held.begin(), boundary.held.end(),
                            [&] (const PathPiece& held) { return held.start == piece.start && held.end == piece.end; });
    };
    std::set<std::string> names;
    const auto& paths = boundary.outline.paths;

    for (std::size_t i = 0; i < paths.size(); ++i)
        for (const auto& piece : paths[i])
            if (isHeld (piece))
                names.insert (i == 0 ? writtenEdgeName (piece) : "hole_" + std::to_string (i));

    device["outline"] = outlineToJson (boundary.outline);
    device["held_edges"] = names;
}
} // namespace antinode
