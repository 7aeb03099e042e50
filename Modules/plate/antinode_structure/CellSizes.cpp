#include "CellSizes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace antinode
{
namespace
{
double sizeAt (double place, double cell, const std::vector<SmallCells>& small)
{
    for (const auto& near : small)
        cell = std::min (cell, near.cell + near.growth * std::abs (place - near.place));

    return cell;
}

/** Appends the breaks of a segment, without its first place. */
void addSegment (std::vector<double>& places, double from, double to, double cell, const std::vector<SmallCells>& small)
{
    constexpr double step = 0.05; // Of a cell.
    std::vector<double> at { from }, cells { 0 };

    while (at.back() < to)
    {
        const auto here = at.back();
        const auto guess = std::min (to, here + step * sizeAt (here, cell, small));
        const auto next = std::min (to, here + step * sizeAt ((here + guess) / 2, cell, small));
        const auto middle = sizeAt ((here + next) / 2, cell, small);
        cells.push_back (cells.back() + (next - here) / middle);
        at.push_back (next);
    }

    const auto count = std::max (1, static_cast<int> (std::ceil (cells.back() - 1e-6)));

    for (int i = 1; i < count; ++i)
    {
        const auto wanted = cells.back() * i / count;
        const auto above = std::upper_bound (cells.begin(), cells.end(), wanted) - cells.begin();
        const auto k = static_cast<std::size_t> (above);
        places.push_back (at[k - 1] + (at[k] - at[k - 1]) * (wanted - cells[k - 1]) / (cells[k] - cells[k - 1]));
    }

    places.push_back (to);
}
} // namespace

SplineBreaks breaksBetween (double from, double to, double cell, const std::vector<SmallCells>& small)
{
    std::vector<SmallCells> lines;
    const auto nearest = 1e-9 * (to - from);
    std::copy_if (small.begin(), small.end(), std::back_inserter (lines),
                  [&] (const SmallCells& s)
                  { return s.multiplicity > 0 && s.place > from + nearest && s.place < to - nearest; });
    std::sort (lines.begin(), lines.end(), [] (const auto& a, const auto& b) { return a.place < b.place; });

    std::vector<double> places { from };
    std::vector<int> multiplicity { 1 };

    for (const auto& line : lines)
    {
        if (line.place <= places.back() + nearest)
        {
            multiplicity.back() = std::max (multiplicity.back(), line.multiplicity);
            continue;
        }

        addSegment (places, places.back(), line.place, cell, small);
        multiplicity.resize (places.size(), 1);
        multiplicity.back() = line.multiplicity;
    }

    addSegment (places, places.back(), to, cell, small);
    multiplicity.resize (places.size(), 1);
    return { Eigen::Map<const Eigen::VectorXd> (places.data(), static_cast<Eigen::Index> (places.size())),
             Eigen::Map<const Eigen::VectorXi> (multiplicity.data(), static_cast<Eigen::Index> (multiplicity.size())) };
}
} // namespace antinode
