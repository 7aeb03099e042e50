#include "OutlineReader.h"

#include "FileUnits.h"

#include <antinode_base/InputError.h>
#include <antinode_outline/Drawing.h>
#include <antinode_outline/OutlineChecks.h>
#include <antinode_outline/PathBuilder.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr std::size_t maximumHoles = 1000;

double lengthOf (const JsonObject& object, std::string_view key)
{
    return fromMillimetres (object.required (key).number (ranges::lengthMillimetre));
}

Eigen::Vector2d readSizes (const JsonObject& object)
{
    return { lengthOf (object, "size_x_mm"), lengthOf (object, "size_y_mm") };
}

double readAngle (const JsonObject& object)
{
    const auto given = object.optional ("angle_deg");
    return given ? given->number (ranges::angleDegrees) * std::numbers::pi / 180 : 0.0;
}

Eigen::Vector2d centreOr (const JsonObject& object, const Eigen::Vector2d& usual)
{
    const auto given = object.optional ("centre_mm");
    return given ? readPlaneMillimetres (*given) : usual;
}

/** A path with the names of its edges, numbered from 0. */
struct NamedPath
{
    ClosedPath path;
    std::vector<std::string> edges;
};

std::array<double, 4> readRadii (const JsonObject& object, const Eigen::Vector2d& size)
{
    const auto given = object.optional ("radius_mm");

    if (! given)
        return { 0, 0, 0, 0 };

    const auto most = 500 * size.minCoeff();
    const auto radii =
        given->isList() ? given->numbers (4, 4, { 0, most }) : std::vector<double> (4, given->number ({ 0, most }));
    return { fromMillimetres (radii[0]), fromMillimetres (radii[1]), fromMillimetres (radii[2]),
             fromMillimetres (radii[3]) };
}

NamedPath readRectangle (const JsonValue& value)
{
    const auto object =
        value.object ({ "shape", "size_x_mm", "size_y_mm", "radius_mm", "centre_mm", "angle_deg", "holes" });
    const auto size = readSizes (object);
    return { rectanglePath (centreOr (object, size / 2), size, readAngle (object), readRadii (object, size), 0),
             { "bottom", "right", "top", "left" } };
}

NamedPath readCircle (const JsonValue& value)
{
    const auto object = value.object ({ "shape", "diameter_mm", "centre_mm", "holes" });
    return { circlePath (centreOr (object, { 0, 0 }), lengthOf (object, "diameter_mm") / 2, 0), { "outer" } };
}

NamedPath readEllipse (const JsonValue& value)
{
    const auto object = value.object ({ "shape", "size_x_mm", "size_y_mm", "centre_mm", "angle_deg", "holes" });
    return { ellipsePath (centreOr (object, { 0, 0 }), readSizes (object) / 2, readAngle (object), 0), { "outer" } };
}

std::vector<std::string> numberedEdges (std::size_t count)
{
    std::vector<std::string> names;

    for (std::size_t i = 1; i <= count; ++i)
        names.push_back (std::to_string (i));

    return names;
}

NamedPath readPolygon (const JsonValue& value)
{
    const auto object = value.object ({ "shape", "vertices_mm", "holes" });
    std::vector<Eigen::Vector2d> vertices;

    for (const auto& vertex : object.required ("vertices_mm").items (3, ranges::maximumPoints))
        vertices.push_back (readPlaneMillimetres (vertex));

    return { polygonPath (vertices, 0), numberedEdges (vertices.size()) };
}

/** The bulge of the arc from one place through another to a third. */
double bulgeThrough (const Eigen::Vector2d& start, const Eigen::Vector2d& through, const Eigen::Vector2d& end)
{
    const Eigen::Vector2d a = start - through, b = end - through;
    const auto cross = a.x() * b.y() - a.y() * b.x();
    const auto angle = std::atan2 (cross, a.dot (b)); // at the place between, of either sign
    return cross == 0 ? 0 : -1 / std::tan (angle / 2);
}

/** The parameter of an ellipse at a place near it. */
double angleOf (const Eigen::Vector2d& centre, const Eigen::Vector2d& cosine, const Eigen::Vector2d& sine,
                const Eigen::Vector2d& place)
{
    const auto determinant = cosine.x() * sine.y() - cosine.y() * sine.x();
    const Eigen::Vector2d offset = place - centre;
    return std::atan2 ((cosine.x() * offset.y() - cosine.y() * offset.x()) / determinant,
                       (offset.x() * sine.y() - offset.y() * sine.x()) / determinant);
}

void addPiece (PathBuilder& path, const JsonObject& piece, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               int edge)
{
    if (const auto through = piece.optional ("through_mm"))
    {
        path.arcTo (to, bulgeThrough (from, readPlaneMillimetres (*through), to), edge);
        return;
    }

    if (const auto given = piece.optional ("centre_mm"))
    {
        const auto centre = readPlaneMillimetres (*given);
        const auto cosine = readPlaneMillimetres (piece.required ("cosine_mm")),
                   sine = readPlaneMillimetres (piece.required ("sine_mm"));
        const auto begin = angleOf (centre, cosine, sine, from);
        const auto turn = angleOf (centre, cosine, sine, to) - begin;
        path.ellipseTo (centre, cosine, sine, begin, begin + std::remainder (turn, 2 * std::numbers::pi), edge);
        path.endAt (to);
        return;
    }

    path.lineTo (to, edge);
}

NamedPath readPieces (const JsonValue& value)
{
    const auto object = value.object ({ "shape", "start_mm", "pieces", "holes" });
    auto place = readPlaneMillimetres (object.required ("start_mm"));
    const auto start = place;
    PathBuilder builder (place);
    NamedPath result;

    for (const auto& item : object.required ("pieces").items (1, ranges::maximumPoints))
    {
        const auto piece = item.object ({ "to_mm", "through_mm", "centre_mm", "cosine_mm", "sine_mm", "edge" });
        const auto to = readPlaneMillimetres (piece.required ("to_mm"));
        const auto name = piece.optional ("edge");
        addPiece (builder, piece, place, to, static_cast<int> (result.edges.size()));
        result.edges.push_back (name ? name->text (ranges::maximumNameBytes)
                                     : std::to_string (result.edges.size() + 1));
        place = to;
    }

    if (place != start)
    {
        builder.lineTo (start, static_cast<int> (result.edges.size()));
        result.edges.push_back (std::to_string (result.edges.size() + 1));
    }

    result.path = builder.close();
    return result;
}

constexpr WordList<NamedPath (*) (const JsonValue&), 5> outlineShapes { { { "rectangle", readRectangle },
                                                                          { "circle", readCircle },
                                                                          { "ellipse", readEllipse },
                                                                          { "polygon", readPolygon },
                                                                          { "path", readPieces } } };

/** A ring is a circle with a round hole. */
NamedOutline readRing (const JsonValue& value)
{
    const auto object = value.object ({ "shape", "diameter_mm", "inner_diameter_mm", "centre_mm", "holes" });
    const auto centre = centreOr (object, { 0, 0 });
    const auto diameter = lengthOf (object, "diameter_mm");
    const auto inner = object.required ("inner_diameter_mm")
                           .number ({ ranges::lengthMillimetre.minimum, diameter * 1000, false, true });
    return { { { circlePath (centre, diameter / 2, 0), circlePath (centre, fromMillimetres (inner) / 2, 1) } },
             { "outer", "inner" } };
}

/** A hole is one edge, however many pieces it has. */
void addHoles (NamedOutline& result, const std::vector<JsonValue>& holes)
{
    for (std::size_t i = 0; i < holes.size(); ++i)
    {
        auto hole = holes[i].required ("shape").choice (outlineShapes) (holes[i]).path;

        for (auto& piece : hole)
            piece.edge = static_cast<int> (result.edges.size());

        result.outline.paths.push_back (std::move (hole));
        result.edges.push_back ("hole_" + std::to_string (i + 1));
    }
}

/** The same edge by one name has one number. */
void joinNames (NamedOutline& named)
{
    std::vector<std::string> names;
    std::vector<int> numbers;

    for (const auto& name : named.edges)
    {
        const auto found = std::find (names.begin(), names.end(), name);
        numbers.push_back (static_cast<int> (found - names.begin()));

        if (found == names.end())
            names.push_back (name);
    }

    for (auto& path : named.outline.paths)
        for (auto& piece : path)
            piece.edge = numbers[static_cast<std::size_t> (piece.edge)];

    named.edges = std::move (names);
}

nlohmann::json placeToJson (const Eigen::Vector2d& place)
{
    return { toMillimetres (place.x()), toMillimetres (place.y()) };
}

nlohmann::json pathToJson (const ClosedPath& path)
{
    auto pieces = nlohmann::json::array();

    for (const auto& piece : path)
    {
        nlohmann::json item { { "to_mm", placeToJson (piece.end) }, { "edge", writtenEdgeName (piece) } };

        if (! piece.isStraight)
        {
            item["centre_mm"] = placeToJson (piece.centre);
            item["cosine_mm"] = placeToJson (piece.cosine);
            item["sine_mm"] = placeToJson (piece.sine);
        }

        pieces.push_back (std::move (item));
    }

    return { { "shape", "path" }, { "start_mm", placeToJson (path.front().start) }, { "pieces", std::move (pieces) } };
}
} // namespace

Eigen::Vector2d readPlaneMillimetres (const JsonValue& value)
{
    const auto numbers = value.numbers (2, 2, ranges::positionMillimetre);
    return { fromMillimetres (numbers[0]), fromMillimetres (numbers[1]) };
}

NamedOutline readOutline (const JsonValue& value)
{
    const auto shape = value.required ("shape");
    NamedOutline result;

    if (shape.isWord ("ring"))
        result = readRing (value);
    else
    {
        auto outer = shape.choice (outlineShapes) (value);
        result.outline.paths.push_back (std::move (outer.path));
        result.edges = std::move (outer.edges);
    }

    if (const auto holes = value.find ("holes"))
        addHoles (result, holes->items (0, maximumHoles));

    joinNames (result);

    try
    {
        checkOutline (result.outline, "");
    }
    catch (const InputError& error)
    {
        value.fail (error.what());
    }

    return result;
}

std::string writtenEdgeName (const PathPiece& piece)
{
    return std::to_string (piece.edge + 1);
}

nlohmann::json outlineToJson (const Outline& outline)
{
    auto json = pathToJson (outline.paths.front());

    for (std::size_t i = 1; i < outline.paths.size(); ++i)
        json["holes"].push_back (pathToJson (outline.paths[i]));

    return json;
}

namespace
{
void embed (nlohmann::json& owner, const std::filesystem::path& folder, const OutlineFileReader& read)
{
    if (! owner.is_object() || ! owner.contains ("outline"))
        return;

    auto& outline = owner["outline"];

    if (outline.is_object() && outline.contains ("file") && outline["file"].is_string())
        outline = outlineToJson (read (folder / outline["file"].get<std::string>(), outline));
}
} // namespace

void embedOutlineFiles (nlohmann::json& device, const std::filesystem::path& folder, const OutlineFileReader& read)
{
    embed (device, folder, read);

    if (device.is_object() && device.contains ("areas") && device["areas"].is_array())
        for (auto& area : device["areas"])
            embed (area, folder, read);
}

namespace
{
constexpr WordList<double, 8> drawingUnits { { { "mm", 1e-3 },
                                               { "cm", 1e-2 },
                                               { "m", 1 },
                                               { "in", 0.0254 },
                                               { "ft", 0.3048 },
                                               { "mil", 25.4e-6 },
                                               { "pt", 0.0254 / 72 },
                                               { "px", 0.0254 / 96 } } };
} // namespace

Outline readDrawnOutline (const std::filesystem::path& drawing, const nlohmann::json& keys)
{
    const auto object = JsonValue (keys, "outline").object ({ "file", "layer", "unit" });
    DrawingChoice choice;

    if (const auto layer = object.optional ("layer"))
        choice.layer = layer->text (ranges::maximumNameBytes);

    if (const auto unit = object.optional ("unit"))
        choice.unit = unit->choice (drawingUnits);

    return readOutlineFile (drawing, choice);
}
} // namespace antinode
