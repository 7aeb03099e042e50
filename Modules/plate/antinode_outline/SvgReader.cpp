#include "SvgReader.h"

#include "SvgPath.h"
#include "XmlTree.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
/** The length of an attribute such as 210mm, m; nothing without a unit of length. A pixel is none: programs take 72, 90
   or 96 of them for an inch. */
std::optional<double> svgLength (std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, double>, 7> units { { { "mm", 1e-3 },
                                                                           { "cm", 1e-2 },
                                                                           { "m", 1 },
                                                                           { "in", 0.0254 },
                                                                           { "pt", 0.0254 / 72 },
                                                                           { "pc", 0.0254 / 6 },
                                                                           { "Q", 0.25e-3 } } };
    SvgNumbers numbers (text);
    const auto value = numbers.number();

    if (! value || ! (*value > 0))
        return std::nullopt;

    auto unit = numbers.left();
    unit = unit.substr (0, unit.find_last_not_of (" \t\r\n\f") + 1);
    const auto found = std::find_if (units.begin(), units.end(), [&] (const auto& each) { return each.first == unit; });
    return found == units.end() ? std::nullopt : std::optional (*value * found->second);
}

/** x, y, width and height of the page, in units of the drawing. */
std::array<double, 4> pageBox (const XmlNode& root, double unit, const std::string& source)
{
    const auto text = root.attribute ("viewBox");

    if (const auto values = svgNumberList (text); values && values->size() == 4 && (*values)[2] > 0 && (*values)[3] > 0)
        return { (*values)[0], (*values)[1], (*values)[2], (*values)[3] };

    if (! text.empty())
        throw InputError (source, "viewBox is " + inQuotes (text)
                                      + "; allowed: four numbers, the last two of which are larger than 0");

    SvgNumbers height (root.attribute ("height"));

    if (unit > 0)
        return { 0, 0, 1, height.number().value_or (0) };

    throw InputError (source, "has no viewBox, so the size of its units is unknown; allowed: a document in mm, or "
                              "a unit beside the file's name");
}

/** From the page in units of the drawing to m, y still downwards: as preserveAspectRatio says, in the middle. */
Eigen::Affine2d scaledPage (const std::array<double, 4>& box, const Eigen::Vector2d& size, bool isStretched)
{
    Eigen::Vector2d scale (size.x() / box[2], size.y() / box[3]);

    if (! isStretched)
        scale.setConstant (scale.minCoeff());

    const Eigen::Vector2d margin = (size - scale.cwiseProduct (Eigen::Vector2d (box[2], box[3]))) / 2;
    return Eigen::Translation2d (margin) * Eigen::Scaling (scale) * Eigen::Translation2d (-box[0], -box[1]);
}
} // namespace

Eigen::Affine2d svgPage (const XmlNode& root, double unit, const std::string& source)
{
    const auto box = pageBox (root, unit, source);
    const auto isStretched = root.attribute ("preserveAspectRatio").substr (0, 4) == "none";
    Eigen::Vector2d size = unit * Eigen::Vector2d (box[2], box[3]);

    if (! (unit > 0))
    {
        const auto width = svgLength (root.attribute ("width")), height = svgLength (root.attribute ("height"));

        if (! width || ! height)
            throw InputError (source, "width is " + inQuotes (root.attribute ("width")) + " and height "
                                          + inQuotes (root.attribute ("height"))
                                          + ", so the size of its units is unknown; allowed: mm, cm, m, in, pt, "
                                            "pc or Q, or a unit beside the file's name");

        size = { *width, *height };
    }

    const auto upwards = Eigen::Translation2d (0, size.y()) * Eigen::Scaling (Eigen::Vector2d (1, -1));
    return upwards
           * (unit > 0 ? Eigen::Affine2d (Eigen::Scaling (unit) * Eigen::Translation2d (-box[0], -box[1]))
                       : scaledPage (box, size, isStretched));
}

namespace
{
std::string_view withoutPrefix (std::string_view name)
{
    return name.substr (0, 4) == "svg:" ? name.substr (4) : name;
}

/** Names by which users know a part of a drawing. */
std::vector<std::string_view> namesOf (const XmlNode& node)
{
    std::vector<std::string_view> names;

    for (const auto* key : { "inkscape:label", "id" })
        if (const auto name = node.attribute (key); ! name.empty())
            names.push_back (name);

    return names;
}

bool isHidden (const XmlNode& node)
{
    std::string style;
    const auto given = node.attribute ("style");
    std::copy_if (given.begin(), given.end(), std::back_inserter (style), [] (char c) { return c != ' '; });
    return node.attribute ("display") == "none" || node.attribute ("visibility") == "hidden"
           || style.find ("display:none") != std::string::npos || style.find ("visibility:hidden") != std::string::npos;
}

/** Walks through the elements of a drawing. */
class SvgWalk
{
public:
    SvgWalk (std::string file, const DrawingChoice& wanted) : strokes { std::move (file), {} }, choice (wanted) {}

    void visit (const XmlNode& node, const Eigen::Affine2d& outer, bool isWithin)
    {
        static constexpr std::array<std::string_view, 4> groups { "svg", "g", "a", "switch" };
        const auto name = withoutPrefix (node.name);
        const auto names = namesOf (node);
        isWithin = isWithin || std::find (names.begin(), names.end(), choice.layer) != names.end();

        if (isHidden (node))
            return;

        const auto map = outer * transformOf (node);

        if (std::find (groups.begin(), groups.end(), name) == groups.end())
        {
            if (isWithin)
                draw (node, name, map);

            return;
        }

        groupNames.insert (groupNames.end(), names.begin(), names.begin() + (names.empty() ? 0 : 1));

        for (const auto& child : node.children)
            if (withoutPrefix (child.name) == "svg" && isWithin)
                throw InputError (nameOf (child), "is a drawing within the drawing; allowed: groups");
            else
                visit (child, map, isWithin);
    }

    DrawnStrokes strokes;
    std::vector<std::string_view> groupNames;

private:
    std::string nameOf (const XmlNode& node) const
    {
        const auto id = node.attribute ("id");
        return strokes.source + ": " + printable (withoutPrefix (node.name))
               + (id.empty() ? " in line " + std::to_string (node.line) : " " + inQuotes (id));
    }

    Eigen::Affine2d transformOf (const XmlNode& node) const
    {
        const auto text = node.attribute ("transform");
        const auto map = svgTransform (text);

        if (! map)
            throw InputError (nameOf (node), "transform is " + inQuotes (text)
                                                 + "; allowed: matrix, translate, scale, rotate, skewX, skewY");

        return *map;
    }

    /** A length of an attribute in the units of the drawing; mm and such are not allowed there. */
    double length (const XmlNode& node, std::string_view key, double otherwise = 0) const
    {
        const auto text = node.attribute (key);

        if (text.empty() || text == "auto")
            return otherwise;

        if (const auto values = svgNumberList (text.substr (0, text.find ("px"))); values && values->size() == 1)
            return values->front();

        throw InputError (nameOf (node),
                          std::string (key) + " is " + inQuotes (text) + "; allowed: a number without unit");
    }

    void draw (const XmlNode& node, std::string_view kind, const Eigen::Affine2d& map)
    {
        if (kind == "path")
            for (auto& stroke : svgPathStrokes (node.attribute ("d"), map, choice.deviation, nameOf (node), edge))
                strokes.add (std::move (stroke));
        else if (kind == "rect")
            drawRectangle (node, map);
        else if (kind == "circle" || kind == "ellipse")
            drawEllipse (node, map, kind == "circle");
        else if (kind == "polygon" || kind == "polyline")
            drawPolygon (node, map, kind == "polygon");
        else if (kind == "line")
            drawLine (node, map);
        else if (kind == "use")
            throw InputError (nameOf (node), "is a clone; allowed: paths and shapes (unlink clones)");
    }

    void drawRectangle (const XmlNode& node, const Eigen::Affine2d& map)
    {
        const Eigen::Vector2d corner (length (node, "x"), length (node, "y"));
        const Eigen::Vector2d size (length (node, "width"), length (node, "height"));

        if (! (size.minCoeff() > 0))
            return; // As SVG says, it is not shown.

        // One radius stands for both; neither is larger than half a side.
        const auto rx = length (node, "rx", -1), ry = length (node, "ry", -1);
        Eigen::Vector2d radii (rx >= 0 ? rx : std::max (ry, 0.0), ry >= 0 ? ry : std::max (rx, 0.0));
        radii = radii.cwiseMin (size / 2);
        const auto at = [&] (double x, double y) -> Eigen::Vector2d { return corner + Eigen::Vector2d (x, y); };
        const auto w = size.x(), h = size.y(), a = radii.x(), b = radii.y();
        const std::array<std::pair<Eigen::Vector2d, Eigen::Vector2d>, 4> sides { { { at (a, 0), at (w - a, 0) },
                                                                                   { at (w, b), at (w, h - b) },
                                                                                   { at (w - a, h), at (a, h) },
                                                                                   { at (0, h - b), at (0, b) } } };
        PathBuilder path (map * sides[0].first);

        for (std::size_t i = 0; i < 4; ++i)
        {
            path.lineTo (map * sides[i].second, edge++);
            drawSvgArc (path, sides[i].second, sides[(i + 1) % 4].first, radii, 0, false, true, map, edge++);
        }

        strokes.add ({ nameOf (node), path.drawn() });
    }

    void drawEllipse (const XmlNode& node, const Eigen::Affine2d& map, bool isCircle)
    {
        const Eigen::Vector2d centre (length (node, "cx"), length (node, "cy"));
        const Eigen::Vector2d radii = isCircle ? Eigen::Vector2d::Constant (length (node, "r"))
                                               : Eigen::Vector2d (length (node, "rx"), length (node, "ry"));

        if (! (radii.minCoeff() > 0))
            return;

        PathBuilder path (map * Eigen::Vector2d (centre.x() + radii.x(), centre.y()));
        path.ellipseTo (map * centre, map.linear().col (0) * radii.x(), map.linear().col (1) * radii.y(), 0,
                        2 * std::numbers::pi, edge++);
        strokes.add ({ nameOf (node), path.drawn() });
    }

    void drawPolygon (const XmlNode& node, const Eigen::Affine2d& map, bool isClosed)
    {
        const auto values = svgNumberList (node.attribute ("points"));

        if (! values || values->size() % 2 != 0)
            throw InputError (nameOf (node), "points are not a list of pairs of numbers; allowed: x,y x,y ...");

        if (values->size() < 4)
            return;

        const auto place = [&] (std::size_t i) -> Eigen::Vector2d
        { return map * Eigen::Vector2d ((*values)[2 * i], (*values)[2 * i + 1]); };
        PathBuilder path (place (0));

        for (std::size_t i = 1; i < values->size() / 2; ++i)
            path.lineTo (place (i), edge++);

        if (isClosed)
            path.lineTo (place (0), edge++);

        strokes.add ({ nameOf (node), path.drawn() });
    }

    void drawLine (const XmlNode& node, const Eigen::Affine2d& map)
    {
        PathBuilder path (map * Eigen::Vector2d (length (node, "x1"), length (node, "y1")));
        path.lineTo (map * Eigen::Vector2d (length (node, "x2"), length (node, "y2")), edge++);
        strokes.add ({ nameOf (node), path.drawn() });
    }

    const DrawingChoice& choice;
    int edge = 0;
};
} // namespace

std::vector<Stroke> svgStrokes (std::string_view bytes, const std::string& source, const DrawingChoice& choice)
{
    const auto root = readXml (bytes, source);

    if (withoutPrefix (root.name) != "svg")
        throw InputError (source, "is XML, but its first element is " + inQuotes (root.name) + "; allowed: svg");

    SvgWalk walk (source, choice);
    walk.visit (root, svgPage (root, choice.unit, source), choice.layer.empty());

    if (walk.strokes.list.empty() && ! choice.layer.empty())
        throw InputError (source, "shows nothing in " + inQuotes (choice.layer)
                                      + "; allowed: the name or id of a layer, group or element"
                                      + didYouMean (choice.layer, walk.groupNames));

    return std::move (walk.strokes.list);
}
} // namespace antinode
