#include "ModalSurface.h"

#include "FileUnits.h"
#include "OutlineReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_model/Surface.h>
#include <antinode_text/JsonReader.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

namespace antinode
{
namespace
{
constexpr NumberRange weight { 0, 1e12 };
constexpr NumberRange anyExact { -1e12, 1e12 };

void readPoints (const JsonValue& list, const std::optional<JsonObject>& exact, Surface& surface)
{
    const auto points = list.items (1, ranges::maximumPoints);
    const auto exactPoints =
        exact ? exact->required ("points_m").items (points.size(), points.size()) : std::vector<JsonValue> {};
    surface.points.resize (static_cast<Eigen::Index> (points.size()), 2);

    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const auto place = points[i].numbers (2, 2, ranges::positionMillimetre);
        auto row = surface.points.row (static_cast<Eigen::Index> (i));
        row << fromMillimetres (place[0]), fromMillimetres (place[1]);

        if (exact)
        {
            const auto exactPlace = exactPoints[i].items (2, 2);
            row << refined (row[0], exactPlace[0]), refined (row[1], exactPlace[1]);
        }
    }
}

Eigen::VectorXd readWeights (const JsonValue& list, Eigen::Index points)
{
    const auto count = static_cast<std::size_t> (points);
    const auto numbers = list.numbers (count, count, weight);
    Eigen::VectorXd weights = Eigen::Map<const Eigen::VectorXd> (numbers.data(), points);

    if (! (weights.sum() > 0))
        list.fail ("is zero everywhere; allowed: at least one number above 0");

    return weights;
}

/** The points' order along a line. */
std::vector<Eigen::Index> orderAlong (const JsonValue& list, const Eigen::VectorXd& x)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (x.size()));
    std::iota (order.begin(), order.end(), Eigen::Index { 0 });
    std::stable_sort (order.begin(), order.end(), [&] (auto a, auto b) { return x[a] < x[b]; });
    const auto same = std::adjacent_find (order.begin(), order.end(), [&] (auto a, auto b) { return x[a] == x[b]; });

    if (same != order.end())
        list.fail ("has entries " + std::to_string (*same) + " and " + std::to_string (*std::next (same))
                   + " at the same position; allowed on a line: distinct positions");

    return order;
}

Eigen::VectorXd lineShares (const Eigen::VectorXd& x)
{
    const auto n = x.size();
    Eigen::VectorXd shares = Eigen::VectorXd::Constant (n, n == 1 ? 1 : 0);
    const Eigen::VectorXd halves = (x.tail (n - 1) - x.head (n - 1)) / 2;
    shares.head (n - 1) += halves;
    shares.tail (n - 1) += halves;
    return shares;
}

void readExtent (const std::optional<JsonObject>& exact, Surface& surface)
{
    surface.xMinimum = surface.points.col (0).minCoeff();
    surface.xMaximum = surface.points.col (0).maxCoeff();
    surface.yMinimum = surface.points.col (1).minCoeff();
    surface.yMaximum = surface.points.col (1).maxCoeff();

    if (! exact)
        return;

    const auto extent = exact->required ("extent_m").items (4, 4);
    surface.xMinimum = extent[0].number ({ anyExact.minimum, surface.xMinimum });
    surface.xMaximum = extent[1].number ({ surface.xMaximum, anyExact.maximum });
    surface.yMinimum = extent[2].number ({ anyExact.minimum, surface.yMinimum });
    surface.yMaximum = extent[3].number ({ surface.yMaximum, anyExact.maximum });
}
} // namespace

double refined (double value, const JsonValue& exact)
{
    const auto result = exact.number (anyExact);

    if (std::abs (result - value) > 1e-9 * (std::abs (value) + 1e-3))
        exact.fail (exact.description() + "; allowed: " + numberText (value)
                    + " as in the key with the unit; a file that is edited by hand should omit 'exact'");

    return result;
}

GivenSurface readSurface (const JsonObject& device, const std::optional<JsonObject>& exact)
{
    GivenSurface given;
    auto& surface = given.surface;
    const auto list = device.required ("points_mm");
    readPoints (list, exact, surface);
    const auto points = surface.points.rows();
    const auto isLine = (surface.points.col (1).array() == surface.points (0, 1)).all();
    surface.kind = isLine ? SurfaceKind::line : SurfaceKind::plate;
    surface.masses = readWeights (device.required ("weights_kg"), points);
    const auto areas = device.optional ("areas_m2");
    surface.areas = areas ? readWeights (*areas, points) : surface.masses;

    if (! isLine)
    {
        given.order.resize (static_cast<std::size_t> (points));
        std::iota (given.order.begin(), given.order.end(), Eigen::Index { 0 });
        readExtent (exact, surface);
        return given;
    }

    given.order = orderAlong (list, surface.points.col (0));
    surface.points = surface.points (given.order, Eigen::all).eval();
    surface.points.col (1).setZero();
    surface.masses = surface.masses (given.order).eval();
    surface.areas = areas ? surface.areas (given.order).eval() : lineShares (surface.points.col (0));
    readExtent (exact, surface);
    return given;
}

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

namespace
{
constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr Eigen::Index bytesPerNumber = 4;
constexpr std::size_t bytesOf3 = 3, digitsOf3 = 4; // Three bytes are four digits of six bits.

std::string bytesOf (const Eigen::VectorXd& numbers)
{
    std::string bytes;
    bytes.reserve (static_cast<std::size_t> (bytesPerNumber * numbers.size()));

    for (const auto number : numbers)
    {
        const auto bits = std::bit_cast<std::uint32_t> (static_cast<float> (number));

        for (unsigned shift = 0; shift < 32; shift += 8)
            bytes += static_cast<char> (bits >> shift & 0xffU);
    }

    return bytes;
}

/** -1 of a letter that is no digit. */
std::array<int, 256> digitValues()
{
    std::array<int, 256> values {};
    values.fill (-1);

    for (std::size_t i = 0; i < digits.size(); ++i)
        values[static_cast<unsigned char> (digits[i])] = static_cast<int> (i);

    return values;
}
} // namespace

std::string compactNumbers (const Eigen::VectorXd& numbers)
{
    const auto bytes = bytesOf (numbers);
    std::string text;
    text.reserve (digitsOf3 * (bytes.size() / bytesOf3 + 1));

    for (std::size_t i = 0; i < bytes.size(); i += bytesOf3)
    {
        std::uint32_t three = 0;

        for (std::size_t j = 0; j < bytesOf3; ++j)
            three = three << 8U | (i + j < bytes.size() ? static_cast<unsigned char> (bytes[i + j]) : 0U);

        for (std::size_t j = 0; j < digitsOf3; ++j)
            text += i + j <= bytes.size() ? digits[three >> (18 - 6 * j) & 63U] : '=';
    }

    return text;
}

Eigen::VectorXd readCompactNumbers (const JsonValue& value, Eigen::Index count)
{
    static const auto values = digitValues();
    const auto byteCount = static_cast<std::size_t> (bytesPerNumber * count);
    const auto length = digitsOf3 * ((byteCount + bytesOf3 - 1) / bytesOf3);
    const auto text = value.text (length);
    const auto fail = [&]
    {
        value.fail ("is no text of " + std::to_string (count)
                    + " numbers of 4 bytes; allowed: base64 of finite little-endian numbers of 4 bytes, or a list");
    };

    if (text.size() != length)
        fail();

    std::string bytes;
    std::uint32_t bits = 0;
    int known = 0;

    for (std::size_t i = 0; i < text.size() && bytes.size() < byteCount; ++i)
    {
        const auto digit = values[static_cast<unsigned char> (text[i])];

        if (digit < 0)
            fail();

        bits = bits << 6U | static_cast<std::uint32_t> (digit);
        known += 6;

        if (known >= 8)
            bytes += static_cast<char> (bits >> static_cast<unsigned> (known -= 8) & 0xffU);
    }

    Eigen::VectorXd numbers (count);

    for (Eigen::Index k = 0; k < count; ++k)
    {
        std::uint32_t number = 0;

        for (Eigen::Index j = bytesPerNumber; j-- > 0;)
            number =
                number << 8U | static_cast<unsigned char> (bytes[static_cast<std::size_t> (bytesPerNumber * k + j)]);

        numbers[k] = std::bit_cast<float> (number);

        if (! std::isfinite (numbers[k]))
            fail();
    }

    return numbers;
}
} // namespace antinode
