#include "DxfEntities.h"

#include "DxfSpline.h"

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
using std::numbers::pi;

/** A corner of a polyline, and the bulge of what follows it. */
struct BulgedVertex
{
    Eigen::Vector2d place;
    double bulge = 0;
};

/** One entity as it is read. */
struct DxfEntity
{
    const DxfRecord& record;
    const DxfSetting& setting;
    int& edge;

    double number (int code, double otherwise = 0) const { return record.number (code, otherwise, setting.source); }
    int flags() const { return record.integer (70, 0, setting.source); }

    Eigen::Vector2d place (int code) const
    {
        return setting.unit * Eigen::Vector2d (number (code), number (code + 10));
    }

    std::string name() const
    {
        return setting.source + ": " + printable (record.type) + " in line " + std::to_string (record.line);
    }

    /** Whether an entity is seen from behind, which mirrors it. */
    bool isMirrored() const
    {
        const Eigen::Vector3d normal (number (210), number (220), number (230, 1));

        if (normal.head<2>().norm() > 1e-6 * std::abs (normal.z()) || normal.z() == 0)
            throw InputError (name(), "lies in a plane of its own; allowed: a drawing in the plane of x and y");

        return normal.z() < 0;
    }
};

std::vector<PathPiece> mirroredIf (bool isMirrored, std::vector<PathPiece> pieces)
{
    if (isMirrored)
        transform (pieces, Eigen::Affine2d (Eigen::Scaling (Eigen::Vector2d (-1, 1))));

    return pieces;
}

std::vector<PathPiece> ellipseBetween (const Eigen::Vector2d& centre, const Eigen::Vector2d& cosine,
                                       const Eigen::Vector2d& sine, double from, double to, int edge)
{
    PathBuilder path (centre + std::cos (from) * cosine + std::sin (from) * sine);
    path.ellipseTo (centre, cosine, sine, from, to, edge);
    return path.drawn();
}

/** The end of an arc, at most a full turn behind its start. */
double endBehind (double from, double to)
{
    constexpr double rounding = 1e-6; // Files have six digits or more.
    const auto turns = (to - from) / (2 * pi);
    const auto behind = turns - std::floor (turns);
    return from + 2 * pi * (behind > rounding && behind < 1 - rounding ? behind : 1.0);
}

std::vector<PathPiece> readLine (const DxfEntity& entity)
{
    PathBuilder path (entity.place (10));
    path.lineTo (entity.place (11), entity.edge++);
    return path.drawn();
}

std::vector<PathPiece> readArc (const DxfEntity& entity, bool isWhole)
{
    const auto radius = entity.setting.unit * entity.number (40);

    if (! (radius > 0))
        throw InputError (entity.name(), "has a radius of " + numberText (entity.number (40)) + "; allowed: above 0");

    const auto from = isWhole ? 0.0 : std::remainder (entity.number (50), 360) * pi / 180;
    const auto to = isWhole ? 2 * pi : endBehind (from, entity.number (51) * pi / 180);
    return mirroredIf (entity.isMirrored(),
                       ellipseBetween (entity.place (10), { radius, 0 }, { 0, radius }, from, to, entity.edge++));
}

std::vector<PathPiece> readEllipse (const DxfEntity& entity)
{
    const auto major = entity.place (11);
    const auto ratio = entity.number (40, 1) * (entity.isMirrored() ? -1 : 1);

    if (! (major.norm() > 0) || ratio == 0)
        throw InputError (entity.name(), "has an axis of length 0; allowed: above 0");

    const auto from = std::remainder (entity.number (41), 2 * pi);
    return ellipseBetween (entity.place (10), major, ratio * Eigen::Vector2d (-major.y(), major.x()), from,
                           endBehind (from, entity.number (42, 2 * pi)), entity.edge++);
}

std::vector<PathPiece> pathThrough (const std::vector<BulgedVertex>& vertices, bool isClosed, int& edge)
{
    if (vertices.empty())
        return {};

    PathBuilder path (vertices.front().place);

    for (std::size_t i = 0; i + (isClosed ? 0 : 1) < vertices.size(); ++i)
        path.arcTo (vertices[(i + 1) % vertices.size()].place, vertices[i].bulge, edge++);

    return path.drawn();
}

std::vector<PathPiece> readLightPolyline (const DxfEntity& entity)
{
    const auto& source = entity.setting.source;
    std::vector<BulgedVertex> vertices;

    for (const auto& group : entity.record.groups)
        if (group.code == 10)
            vertices.push_back ({ { entity.setting.unit * dxfNumber (group, source), 0 }, 0 });
        else if (group.code == 20 && ! vertices.empty())
            vertices.back().place.y() = entity.setting.unit * dxfNumber (group, source);
        else if (group.code == 42 && ! vertices.empty())
            vertices.back().bulge = dxfNumber (group, source);

    return mirroredIf (entity.isMirrored(), pathThrough (vertices, (entity.flags() & 1) != 0, entity.edge));
}

/** The older kind, whose vertices are records of their own. */
std::vector<PathPiece> readPolyline (const DxfEntity& entity, const DxfRecord* rest, const DxfRecord* end)
{
    constexpr int closed = 1, mesh = 16, faces = 64, controlPoint = 16;

    if ((entity.flags() & (mesh | faces)) != 0)
        throw InputError (entity.name(), "is a mesh; allowed: lines and arcs in a plane");

    std::vector<BulgedVertex> vertices;

    for (; rest != end && rest->type == "VERTEX"; ++rest)
    {
        const DxfEntity vertex { *rest, entity.setting, entity.edge };

        if ((vertex.flags() & controlPoint) == 0)
            vertices.push_back ({ vertex.place (10), vertex.number (42) });
    }

    return mirroredIf (entity.isMirrored(), pathThrough (vertices, (entity.flags() & closed) != 0, entity.edge));
}
} // namespace

bool isDxfCurve (std::string_view type)
{
    static constexpr std::array<std::string_view, 7> curves { "LINE",       "ARC",      "CIRCLE", "ELLIPSE",
                                                              "LWPOLYLINE", "POLYLINE", "SPLINE" };
    return std::find (curves.begin(), curves.end(), type) != curves.end();
}

std::vector<PathPiece> dxfPieces (const DxfRecord& record, const DxfRecord* rest, const DxfRecord* end,
                                  const DxfSetting& setting, int& edge)
{
    const DxfEntity entity { record, setting, edge };

    if (record.type == "LINE")
        return readLine (entity);

    if (record.type == "ARC" || record.type == "CIRCLE")
        return readArc (entity, record.type == "CIRCLE");

    if (record.type == "ELLIPSE")
        return readEllipse (entity);

    if (record.type == "LWPOLYLINE")
        return readLightPolyline (entity);

    if (record.type == "POLYLINE")
        return readPolyline (entity, rest, end);

    return dxfSplinePieces (record, entity.name(), setting, edge);
}
} // namespace antinode
