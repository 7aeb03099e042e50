#include "DxfEntities.h"

#include "PathBuilder.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace antinode
{
namespace
{
std::string_view trimmed (std::string_view text)
{
    const auto first = text.find_first_not_of (" \t\r");
    return first == std::string_view::npos ? std::string_view {}
                                           : text.substr (first, text.find_last_not_of (" \t\r") + 1 - first);
}

/** The next line; nothing at the end. */
std::optional<std::string_view> nextLine (std::string_view& rest)
{
    if (rest.empty())
        return std::nullopt;

    const auto end = rest.find ('\n');
    const auto line = rest.substr (0, end);
    rest.remove_prefix (end == std::string_view::npos ? rest.size() : end + 1);
    return trimmed (line);
}
} // namespace

std::string_view DxfRecord::text (int code) const
{
    const auto found =
        std::find_if (groups.begin(), groups.end(), [code] (const auto& group) { return group.code == code; });
    return found == groups.end() ? std::string_view {} : found->value;
}

double DxfRecord::number (int code, double otherwise, const std::string& source) const
{
    const auto found =
        std::find_if (groups.begin(), groups.end(), [code] (const auto& group) { return group.code == code; });
    return found == groups.end() ? otherwise : dxfNumber (*found, source);
}

int DxfRecord::integer (int code, int otherwise, const std::string& source) const
{
    return static_cast<int> (std::clamp (number (code, otherwise, source), -1e9, 1e9));
}

std::vector<double> DxfRecord::numbers (int code, const std::string& source) const
{
    std::vector<double> values;

    for (const auto& group : groups)
        if (group.code == code)
            values.push_back (dxfNumber (group, source));

    return values;
}

double dxfNumber (const DxfGroup& group, const std::string& source)
{
    double value = 0;
    auto text = group.value;

    if (! text.empty() && text.front() == '+')
        text.remove_prefix (1);

    const auto [end, error] = std::from_chars (text.data(), text.data() + text.size(), value);

    if (error != std::errc() || end != text.data() + text.size() || ! std::isfinite (value))
        throw InputError (source + ": line " + std::to_string (group.line), inQuotes (group.value) + " stands in group "
                                                                                + std::to_string (group.code)
                                                                                + "; allowed: a number");

    return value;
}

std::vector<DxfRecord> readDxf (std::string_view bytes, const std::string& source)
{
    if (bytes.substr (0, 18) == "AutoCAD Binary DXF")
        throw InputError (source, "is a binary DXF file; allowed: DXF as text");

    std::vector<DxfRecord> records;

    for (long line = 1;; line += 2)
    {
        const auto code = nextLine (bytes);
        const auto value = nextLine (bytes);

        if (! code || (code->empty() && ! value))
            return records;

        DxfGroup group { 0, value.value_or (""), line + 1 };
        const auto [end, error] = std::from_chars (code->data(), code->data() + code->size(), group.code);

        if (error != std::errc() || end != code->data() + code->size() || ! value)
            throw InputError (source + ": line " + std::to_string (line),
                              inQuotes (*code)
                                  + " stands there; allowed: an SVG file, or DXF's codes and values, "
                                    "each in a line of its own");

        if (group.code == 0)
            records.push_back ({ group.value, {}, group.line });
        else if (! records.empty())
            records.back().groups.push_back (group);
    }
}

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

namespace
{
/** A rational spline. Control points as (weight x, weight y, weight), in m. */
struct RationalSpline
{
    int degree = 3;
    std::vector<double> knots;
    std::vector<Eigen::Vector3d> points;

    double first() const { return knots[static_cast<std::size_t> (degree)]; }
    double last() const { return knots[points.size()]; }

    /** Its place, homogeneous, and the derivative of that, by de Boor's triangle. */
    std::pair<Eigen::Vector3d, Eigen::Vector3d> at (double parameter) const
    {
        const auto p = static_cast<std::size_t> (degree);
        const auto begin = knots.begin() + degree;
        const auto end = knots.begin() + static_cast<std::ptrdiff_t> (points.size());
        const auto above = std::upper_bound (begin, end, parameter);
        auto span = static_cast<std::size_t> (above - knots.begin()) - 1;

        while (span > p && knots[span] == knots[span + 1])
            --span;

        std::vector<Eigen::Vector3d> row (points.begin() + static_cast<std::ptrdiff_t> (span - p),
                                          points.begin() + static_cast<std::ptrdiff_t> (span + 1));
        Eigen::Vector3d slope = Eigen::Vector3d::Zero();

        for (std::size_t level = 1; level <= p; ++level)
        {
            if (level == p)
                slope = degree * (row[p] - row[p - 1]) / std::max (knots[span + 1] - knots[span], 1e-300);

            for (auto j = p; j >= level; --j)
            {
                const auto low = knots[j + span - p], width = knots[j + 1 + span - level] - low;
                const auto share = width > 0 ? (parameter - low) / width : 0.0;
                row[j] = (1 - share) * row[j - 1] + share * row[j];
            }
        }

        return { row[p], slope };
    }
};

RationalSpline readSpline (const DxfRecord& record, const std::string& name, const DxfSetting& setting)
{
    constexpr int highest = 10;
    const auto x = record.numbers (10, setting.source), y = record.numbers (20, setting.source);
    const auto weights = record.numbers (41, setting.source);
    RationalSpline spline;
    spline.degree = record.integer (71, 3, setting.source);
    spline.knots = record.numbers (40, setting.source);

    if (x.empty())
        throw InputError (name, "has no control points; allowed: splines by control points (convert it to a polyline)");

    if (spline.degree < 1 || spline.degree > highest || x.size() != y.size()
        || x.size() <= static_cast<std::size_t> (spline.degree)
        || spline.knots.size() != x.size() + static_cast<std::size_t> (spline.degree) + 1
        || (! weights.empty() && weights.size() != x.size())
        || ! std::is_sorted (spline.knots.begin(), spline.knots.end()))
        throw InputError (name, "has " + std::to_string (x.size()) + " control points, "
                                    + std::to_string (spline.knots.size()) + " knots and degree "
                                    + std::to_string (spline.degree)
                                    + "; allowed: as many ascending knots as points, and degree + 1 more");

    for (std::size_t i = 0; i < x.size(); ++i)
    {
        const auto weight = weights.empty() ? 1.0 : weights[i];
        const Eigen::Vector2d place = setting.unit * Eigen::Vector2d (x[i], y[i]);

        if (! (weight > 0) || ! isWithinReach (place))
            throw InputError (name, "has a weight that is not above 0, or a point farther than 1000 m from the origin");

        spline.points.emplace_back (weight * place.x(), weight * place.y(), weight);
    }

    return spline;
}
} // namespace

std::vector<PathPiece> dxfSplinePieces (const DxfRecord& record, const std::string& name, const DxfSetting& setting,
                                        int& edge)
{
    const auto spline = readSpline (record, name, setting);
    const FreeCurve curve { [&] (double t) -> Eigen::Vector2d { return spline.at (t).first.hnormalized(); },
                            [&] (double t) -> Eigen::Vector2d
                            {
                                const auto [place, slope] = spline.at (t);
                                return (slope.head<2>() - slope.z() * place.hnormalized()) / place.z();
                            } };
    PathBuilder path (curve.at (spline.first()));

    // Only between knots is it smooth.
    for (auto i = static_cast<std::size_t> (spline.degree); i < spline.points.size(); ++i)
        if (spline.knots[i + 1] > spline.knots[i])
            drawCurve (path, curve, spline.knots[i], spline.knots[i + 1], setting.deviation, edge);

    ++edge;
    return path.drawn();
}
} // namespace antinode
