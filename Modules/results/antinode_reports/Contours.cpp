#include "Contours.h"

#include <antinode_base/Watch.h>

#include <array>
#include <cmath>

namespace antinode
{
namespace
{
/** Where lines cross the edges of squares: two edges belong to each value, to its right and above it. */
class Crossings
{
public:
    Crossings (const Eigen::MatrixXd& valuesToUse, double levelToUse)
        : values (valuesToUse), level (levelToUse), links (static_cast<std::size_t> (2 * values.size()), { -1, -1 })
    {
        for (Eigen::Index column = 0; column + 1 < values.cols(); ++column)
        {
            checkWatch();
            for (Eigen::Index row = 0; row + 1 < values.rows(); ++row)
                linkSquare (row, column);
        }
    }

    /** Lines with ends at the matrix's border first, then closed ones. */
    std::vector<ContourLine> lines()
    {
        std::vector<ContourLine> result;
        for (const auto isClosed : { false, true })
            for (std::size_t edge = 0; edge < links.size(); ++edge)
                if (links[edge][0] >= 0 && (isClosed || links[edge][1] < 0))
                    result.push_back (lineFrom (static_cast<Eigen::Index> (edge)));
        return result;
    }

private:
    Eigen::Index edgeIndex (Eigen::Index row, Eigen::Index column, bool isUpwards) const
    {
        return 2 * (row + column * values.rows()) + (isUpwards ? 1 : 0);
    }

    void link (Eigen::Index one, Eigen::Index other)
    {
        for (const auto& [from, to] : { std::pair { one, other }, std::pair { other, one } })
        {
            auto& ends = links[static_cast<std::size_t> (from)];
            (ends[0] < 0 ? ends[0] : ends[1]) = to;
        }
    }

    void linkSquare (Eigen::Index row, Eigen::Index column)
    {
        const auto square = values.block<2, 2> (row, column);
        if (! square.allFinite())
            return;
        const auto isAbove = [&] (int i, int j) { return square (i, j) > level; };
        const std::array<Eigen::Index, 4> edges { edgeIndex (row, column, false), edgeIndex (row, column + 1, true),
                                                  edgeIndex (row + 1, column, false), edgeIndex (row, column, true) };
        const std::array<bool, 4> crossed { isAbove (0, 0) != isAbove (0, 1), isAbove (0, 1) != isAbove (1, 1),
                                            isAbove (1, 0) != isAbove (1, 1), isAbove (0, 0) != isAbove (1, 0) };
        std::vector<Eigen::Index> found;
        for (std::size_t k = 0; k < edges.size(); ++k)
            if (crossed[k])
                found.push_back (edges[k]);
        if (found.size() == 2)
            link (found[0], found[1]);
        if (found.size() < 4)
            return;
        // A saddle: the mean says which of the two opposite corners belong together.
        const auto joinsFirst = (square.mean() > level) == isAbove (0, 0);
        link (edges[0], edges[joinsFirst ? 1 : 3]);
        link (edges[2], edges[joinsFirst ? 3 : 1]);
    }

    Eigen::Vector2d pointOnEdge (Eigen::Index edge) const
    {
        const auto row = edge / 2 % values.rows(), column = edge / 2 / values.rows();
        const auto isUpwards = edge % 2 == 1;
        const auto first = values (row, column);
        const auto second = isUpwards ? values (row + 1, column) : values (row, column + 1);
        const auto share = (level - first) / (second - first);
        return { static_cast<double> (column) + (isUpwards ? 0 : share),
                 static_cast<double> (row) + (isUpwards ? share : 0) };
    }

    // Takes the links that it follows away, so that no line is found twice.
    ContourLine lineFrom (Eigen::Index edge)
    {
        ContourLine line { pointOnEdge (edge) };
        for (auto next = takeLink (edge); next >= 0; next = takeLink (edge))
        {
            auto& back = links[static_cast<std::size_t> (next)];
            (back[0] == edge ? back[0] : back[1]) = -1;
            edge = next;
            line.push_back (pointOnEdge (edge));
        }
        return line;
    }

    Eigen::Index takeLink (Eigen::Index edge)
    {
        auto& ends = links[static_cast<std::size_t> (edge)];
        auto& end = ends[0] >= 0 ? ends[0] : ends[1];
        const auto next = end;
        end = -1;
        return next;
    }

    const Eigen::MatrixXd& values;
    double level;
    std::vector<std::array<Eigen::Index, 2>> links; ///< Of each edge to those that its line continues to; -1 for none.
};
} // namespace

std::vector<ContourLine> contourLines (const Eigen::MatrixXd& values, double level)
{
    return Crossings (values, level).lines();
}
} // namespace antinode
