#include "DxfSpline.h"

#include "FreeCurve.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
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
