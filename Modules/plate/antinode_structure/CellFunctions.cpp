#include "CellFunctions.h"

#include <algorithm>

namespace antinode
{
namespace
{
double binomial (int n, int k)
{
    return k == 0 || k == n ? 1 : n; // Up to 3 over 1 and 2, which is all that is needed.
}
} // namespace

CellFunctions::CellFunctions (const ImmersedSpace& space, const ImmersedCell& cell,
                              const std::vector<Eigen::Vector2d>& placesToUse, int highest)
    : places (placesToUse)
{
    const auto number = static_cast<Eigen::Index> (places.size());
    Eigen::VectorXd x (number), y (number);

    for (Eigen::Index i = 0; i < number; ++i)
    {
        x[i] = places[static_cast<std::size_t> (i)].x();
        y[i] = places[static_cast<std::size_t> (i)].y();
    }

    for (int d = 0; d <= highest; ++d)
    {
        alongX.push_back (space.axisX.onCell (cell.column, x, d).values);
        alongY.push_back (space.axisY.onCell (cell.row, y, d).values);
    }

    const auto addFunctions = [&] (const std::vector<Eigen::Index>& unknownOf, const KinkFunction* kink)
    {
        for (Eigen::Index j = 0; j < space.countY[static_cast<std::size_t> (cell.row)]; ++j)
            for (Eigen::Index i = 0; i < space.countX[static_cast<std::size_t> (cell.column)]; ++i)
                if (const auto unknown = unknownOf[static_cast<std::size_t> (
                        space.tensorIndex (space.firstX[static_cast<std::size_t> (cell.column)] + i,
                                           space.firstY[static_cast<std::size_t> (cell.row)] + j))];
                    unknown >= 0)
                {
                    members.push_back ({ i, j, kink });
                    numbers.push_back (unknown);
                }
    };

    addFunctions (space.unknownOf, nullptr);

    // Where a kink's function is 0, all that it is a factor of are.
    for (const auto& family : space.families)
        if (std::any_of (places.begin(), places.end(),
                         [&] (const Eigen::Vector2d& place) { return family.kink (place) > 0; }))
            addFunctions (family.unknownOf, &family.kink);
}

Eigen::VectorXd CellFunctions::kinkDerivative (const KinkFunction& kink, int dx, int dy) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero (static_cast<Eigen::Index> (places.size()));

    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const Eigen::Vector2d offset = places[i] - kink.centre;
        const auto s = kink (places[i]);

        if (s <= 0)
            continue;

        // Of s^2, whose second derivatives are the same along x and y, and 0 across.
        const Eigen::Vector2d slope = kink.gradient + kink.curvature * offset;
        const auto along = dx >= dy ? slope.x() : slope.y(), across = dx >= dy ? slope.y() : slope.x();
        const auto most = std::max (dx, dy), least = std::min (dx, dy);
        const auto value = most == 0                 ? s * s
                           : most == 1 && least == 0 ? 2 * s * along
                           : most == 1               ? 2 * along * across
                           : most == 2 && least == 0 ? 2 * (along * along + s * kink.curvature)
                           : most == 2 && least == 1 ? 2 * across * kink.curvature
                           : most == 3 && least == 0 ? 6 * along * kink.curvature
                                                     : 0;
        result[static_cast<Eigen::Index> (i)] = value;
    }

    return result;
}

Eigen::MatrixXd CellFunctions::derivative (int dx, int dy) const
{
    Eigen::MatrixXd result (static_cast<Eigen::Index> (places.size()), static_cast<Eigen::Index> (members.size()));
    writeDerivative (dx, dy, result);
    return result;
}

void CellFunctions::writeDerivative (int dx, int dy, Eigen::Ref<Eigen::MatrixXd> result) const
{
    const KinkFunction* last = nullptr;
    std::vector<Eigen::VectorXd> factors; // Of the kink's derivatives, i along x and j along y.

    for (std::size_t m = 0; m < members.size(); ++m)
    {
        const auto& member = members[m];
        auto column = result.col (static_cast<Eigen::Index> (m));
        const auto product = [&] (int x, int y)
        {
            return alongX[static_cast<std::size_t> (x)]
                .col (member.ofX)
                .cwiseProduct (alongY[static_cast<std::size_t> (y)].col (member.ofY));
        };

        if (member.kink == nullptr)
        {
            column = product (dx, dy);
            continue;
        }

        if (member.kink != last)
        {
            factors.clear();
            last = member.kink;

            for (int j = 0; j <= dy; ++j)
                for (int i = 0; i <= dx; ++i)
                    factors.emplace_back (binomial (dx, i) * binomial (dy, j) * kinkDerivative (*last, i, j));
        }

        auto factor = factors.cbegin();

        for (int j = 0; j <= dy; ++j)
            for (int i = 0; i <= dx; ++i, ++factor)
                if (i == 0 && j == 0)
                    column = factor->cwiseProduct (product (dx, dy));
                else
                    column += factor->cwiseProduct (product (dx - i, dy - j));
    }
}
} // namespace antinode
