#include "SurfaceReader.h"

#include "FileUnits.h"

#include <antinode_base/MessageText.h>
#include <antinode_text/PhysicalRanges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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
} // namespace antinode
