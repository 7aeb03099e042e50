#include "SvgPath.h"

#include "PathBuilder.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <charconv>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
bool isBlank (char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool isLetter (char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

Eigen::Affine2d affine (double a, double b, double c, double d, double e, double f)
{
    Eigen::Affine2d map;
    map.matrix() << a, c, e, b, d, f, 0, 0, 1;
    return map;
}

/** One transform by its name and values; nothing where their number is wrong. */
std::optional<Eigen::Affine2d> namedTransform (std::string_view name, const std::vector<double>& v)
{
    const auto radians = [] (double degrees) { return degrees * std::numbers::pi / 180; };
    const auto count = v.size();

    if (name == "matrix" && count == 6)
        return affine (v[0], v[1], v[2], v[3], v[4], v[5]);

    if (name == "translate" && (count == 1 || count == 2))
        return affine (1, 0, 0, 1, v[0], count == 2 ? v[1] : 0);

    if (name == "scale" && (count == 1 || count == 2))
        return affine (v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0);

    if (name == "rotate" && (count == 1 || count == 3))
    {
        const auto sine = std::sin (radians (v[0])), cosine = std::cos (radians (v[0]));
        const Eigen::Translation2d centre (count == 3 ? v[1] : 0, count == 3 ? v[2] : 0);
        return centre * affine (cosine, sine, -sine, cosine, 0, 0) * centre.inverse();
    }

    if (name == "skewX" && count == 1)
        return affine (1, 0, std::tan (radians (v[0])), 1, 0, 0);

    if (name == "skewY" && count == 1)
        return affine (1, std::tan (radians (v[0])), 0, 1, 0, 0);

    return std::nullopt;
}
} // namespace

void SvgNumbers::skipBlanks (bool andComma)
{
    for (; ! rest.empty() && (isBlank (rest.front()) || (andComma && rest.front() == ',')); rest.remove_prefix (1))
        andComma = andComma && rest.front() != ',';
}

std::optional<double> SvgNumbers::number()
{
    skipBlanks (true);
    auto digits = rest;

    if (! digits.empty() && digits.front() == '+')
        digits.remove_prefix (1);

    // from_chars also reads "inf" and "nan".
    const auto sign = ! digits.empty() && digits.front() == '-' ? std::size_t { 1 } : 0;

    if (digits.size() <= sign || isLetter (digits[sign]))
        return std::nullopt;

    double value = 0;
    const auto [end, error] = std::from_chars (digits.data(), digits.data() + digits.size(), value);

    if (error != std::errc() || ! std::isfinite (value))
        return std::nullopt;

    rest.remove_prefix (static_cast<std::size_t> (end - rest.data()));
    return value;
}

std::optional<bool> SvgNumbers::flag()
{
    skipBlanks (true);

    if (rest.empty() || (rest.front() != '0' && rest.front() != '1'))
        return std::nullopt;

    const auto value = rest.front() == '1';
    rest.remove_prefix (1);
    return value;
}

char SvgNumbers::letter()
{
    skipBlanks (false);

    if (rest.empty() || ! isLetter (rest.front()))
        return 0;

    const auto found = rest.front();
    rest.remove_prefix (1);
    return found;
}

bool SvgNumbers::isAtEnd()
{
    skipBlanks (false);
    return rest.empty();
}

std::optional<std::vector<double>> svgNumberList (std::string_view text)
{
    SvgNumbers numbers (text);
    std::vector<double> values;

    while (! numbers.isAtEnd())
    {
        const auto value = numbers.number();

        if (! value)
            return std::nullopt;

        values.push_back (*value);
    }

    return values;
}

std::optional<Eigen::Affine2d> svgTransform (std::string_view text)
{
    Eigen::Affine2d whole = Eigen::Affine2d::Identity();

    while (true)
    {
        const auto begin = text.find_first_not_of (" \t\r\n\f,");

        if (begin == std::string_view::npos)
            return whole;

        const auto open = text.find ('(', begin), close = text.find (')', begin);

        if (open == std::string_view::npos || close == std::string_view::npos || close < open)
            return std::nullopt;

        auto name = text.substr (begin, open - begin);
        name = name.substr (0, name.find_last_not_of (" \t\r\n\f") + 1);
        const auto values = svgNumberList (text.substr (open + 1, close - open - 1));
        const auto next = values ? namedTransform (name, *values) : std::nullopt;

        if (! next)
            return std::nullopt;

        whole = whole * *next;
        text.remove_prefix (close + 1);
    }
}

namespace
{
/** Reads the commands of a path one after the other. */
class SvgPathReader
{
public:
    SvgPathReader (std::string_view data, const Eigen::Affine2d& toMetres, double allowed, std::string what,
                   int& nextEdge)
        : numbers (data), map (toMetres), deviation (allowed), name (std::move (what)), edge (nextEdge)
    {
    }

    std::vector<Stroke> read()
    {
        char command = 0;

        while (! numbers.isAtEnd())
        {
            if (const auto next = numbers.letter(); next != 0)
                command = next;
            else if (command == 0 || isClosing (command))
                fail();

            if (path == std::nullopt && ! isMoving (command))
                restart (command);

            draw (command);

            if (pieces + (path ? path->drawn().size() : 0) > maximumStrokePieces)
                throw InputError (name, "has more than " + std::to_string (maximumStrokePieces) + " lines and arcs");

            // Further places behind a move are lines.
            if (isMoving (command))
                command = command == 'M' ? 'L' : 'l';
        }

        finish();
        return std::move (strokes);
    }

private:
    static bool isClosing (char command) { return command == 'Z' || command == 'z'; }
    static bool isMoving (char command) { return command == 'M' || command == 'm'; }

    [[noreturn]] void fail() const
    {
        throw InputError (name, "has no SVG path where " + inQuotes (numbers.left().substr (0, 20))
                                    + " stands; allowed: M L H V C S Q T A Z with their numbers");
    }

    double number()
    {
        const auto value = numbers.number();

        if (! value)
            fail();

        return *value;
    }

    bool flag()
    {
        const auto value = numbers.flag();

        if (! value)
            fail();

        return *value;
    }

    Eigen::Vector2d readPlace (bool isRelative)
    {
        const auto x = number();
        return bounded (Eigen::Vector2d (x, number()) + (isRelative ? place : Eigen::Vector2d (0, 0)));
    }

    Eigen::Vector2d bounded (const Eigen::Vector2d& at) const
    {
        if (! isWithinReach (map * at))
            throw InputError (name, "has a place farther than 1000 m from the origin");

        return at;
    }

    /** Behind a closed part another may begin where that began. */
    void restart (char command)
    {
        if (strokes.empty() || isClosing (command))
            fail();

        place = first;
        path.emplace (map * place);
    }

    void finish()
    {
        if (path && ! path->drawn().empty())
        {
            pieces += path->drawn().size();
            strokes.push_back ({ name, path->drawn() });
        }

        path.reset();
    }

    void draw (char command)
    {
        const auto isRelative = command >= 'a';

        switch (isRelative ? command - 'a' + 'A' : command)
        {
            case 'M':
                moveTo (readPlace (isRelative));
                break;
            case 'L':
                lineTo (readPlace (isRelative));
                break;
            case 'H':
                lineTo ({ number() + (isRelative ? place.x() : 0), place.y() });
                break;
            case 'V':
                lineTo ({ place.x(), number() + (isRelative ? place.y() : 0) });
                break;
            case 'C':
                drawCubic (readPlace (isRelative), isRelative);
                break;
            case 'S':
                drawCubic (lastWasCubic ? Eigen::Vector2d (2 * place - handle) : place, isRelative);
                break;
            case 'Q':
                drawQuadratic (readPlace (isRelative), isRelative);
                break;
            case 'T':
                drawQuadratic (lastWasQuadratic ? Eigen::Vector2d (2 * place - handle) : place, isRelative);
                break;
            case 'A':
                drawArc (isRelative);
                break;
            case 'Z':
                close();
                break;
            default:
                fail();
        }
    }

    void moveTo (const Eigen::Vector2d& to)
    {
        finish();
        first = place = to;
        path.emplace (map * place);
        forgetHandle();
    }

    void lineTo (const Eigen::Vector2d& to)
    {
        bounded (to);
        path->lineTo (map * to, edge++);
        place = to;
        forgetHandle();
    }

    void close()
    {
        lineTo (first);
        finish();
    }

    void forgetHandle() { lastWasCubic = lastWasQuadratic = false; }

    void drawCubic (const Eigen::Vector2d& out, bool isRelative)
    {
        const auto in = readPlace (isRelative);
        const auto to = readPlace (isRelative);
        drawBezier (*path, { map * place, map * out, map * in, map * to }, deviation, edge++);
        handle = in;
        place = to;
        lastWasCubic = true;
        lastWasQuadratic = false;
    }

    void drawQuadratic (const Eigen::Vector2d& middle, bool isRelative)
    {
        const auto to = readPlace (isRelative);
        drawBezier (*path, { map * place, map * ((place + 2 * middle) / 3), map * ((to + 2 * middle) / 3), map * to },
                    deviation, edge++);
        handle = middle;
        place = to;
        lastWasCubic = false;
        lastWasQuadratic = true;
    }

    void drawArc (bool isRelative)
    {
        const auto x = number();
        const Eigen::Vector2d radii (x, number());
        const auto turn = number();
        const auto isLarge = flag();
        const auto isPositive = flag();
        const auto to = readPlace (isRelative);
        drawSvgArc (*path, place, to, radii, turn, isLarge, isPositive, map, edge++);
        place = to;
        forgetHandle();
    }

    SvgNumbers numbers;
    Eigen::Affine2d map;
    double deviation;
    std::string name;
    int& edge;
    std::vector<Stroke> strokes;
    std::size_t pieces = 0;
    std::optional<PathBuilder> path;
    Eigen::Vector2d first = Eigen::Vector2d::Zero(), place = first, handle = first;
    bool lastWasCubic = false, lastWasQuadratic = false;
};
} // namespace

std::vector<Stroke> svgPathStrokes (std::string_view data, const Eigen::Affine2d& map, double deviation,
                                    const std::string& name, int& edge)
{
    return SvgPathReader (data, map, deviation, name, edge).read();
}

void drawSvgArc (PathBuilder& path, const Eigen::Vector2d& start, const Eigen::Vector2d& end, Eigen::Vector2d radii,
                 double turn, bool isLarge, bool isPositive, const Eigen::Affine2d& map, int edge)
{
    radii = radii.cwiseAbs();

    if (! (radii.minCoeff() > 0) || start == end)
    {
        path.lineTo (map * end, edge);
        return;
    }

    // Where the ellipse is the unit circle; section F.6 of SVG 1.1.
    const Eigen::Rotation2Dd axes (turn * std::numbers::pi / 180);
    const Eigen::Vector2d half = (axes.inverse() * ((end - start) / 2)).cwiseQuotient (radii);
    const auto reach = half.norm();
    const auto isTooFar = reach >= 1; // Then the ellipse is made as large as needed.
    const auto scale = isTooFar ? reach : 1.0;
    const auto offset = isTooFar ? 0.0 : std::sqrt (1 / (reach * reach) - 1) * (isLarge == isPositive ? -1 : 1);
    const Eigen::Vector2d centre = half + offset * Eigen::Vector2d (-half.y(), half.x());
    const Eigen::Vector2d before = -centre, after = 2 * half - centre;
    const auto from = std::atan2 (before.y(), before.x());
    auto span = std::atan2 (after.y(), after.x()) - from;

    if (isPositive && span < 0)
        span += 2 * std::numbers::pi;
    else if (! isPositive && span > 0)
        span -= 2 * std::numbers::pi;

    const Eigen::Vector2d middle = start + axes * centre.cwiseProduct (radii);
    path.ellipseTo (map * middle, map.linear() * (axes * Eigen::Vector2d (scale * radii.x(), 0)),
                    map.linear() * (axes * Eigen::Vector2d (0, scale * radii.y())), from, from + span, edge);
}
} // namespace antinode
