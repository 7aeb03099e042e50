#include "PlateLayout.h"

#include "DescriptionChecks.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double closestLines = 1.0 / 5000; // of the shorter side

/** The distinct ones of some places on a side, ascending; both ends of the side are among them. */
std::vector<double> distinct (std::vector<double> places, double length, double tolerance)
{
    std::sort (places.begin(), places.end());
    std::vector<double> lines { 0 };

    for (const auto place : places)
        if (place > lines.back() + tolerance && place < length - tolerance)
            lines.push_back (place);

    lines.push_back (length);
    return lines;
}

Eigen::Index nearest (const std::vector<double>& lines, double place)
{
    const auto above = std::lower_bound (lines.begin(), lines.end(), place) - lines.begin();
    const auto last = static_cast<std::ptrdiff_t> (lines.size()) - 1;
    const auto right = std::clamp<std::ptrdiff_t> (above, 1, last);
    const auto at = [&] (std::ptrdiff_t index) { return lines[static_cast<std::size_t> (index)]; };
    return place - at (right - 1) < at (right) - place ? right - 1 : right;
}

Eigen::VectorXd scaled (const std::vector<double>& lines, double unit)
{
    return Eigen::Map<const Eigen::VectorXd> (lines.data(), static_cast<Eigen::Index> (lines.size())) / unit;
}

int heldDerivatives (EdgeCondition condition)
{
    return condition == EdgeCondition::clamped ? 2 : condition == EdgeCondition::simplySupported ? 1 : 0;
}

/** The distances from a segment's end at which its first or last cell is divided further. */
std::vector<double> layerDistances (double cell, const PlateResolution& resolution)
{
    constexpr double narrowest = 1.0 / 1500; // of the longer side: much narrower cells cost more digits than they bring
    std::vector<double> distances;

    for (int layer = 0; layer < resolution.layers && cell * resolution.layerRatio > narrowest; ++layer)
        distances.insert (distances.begin(), cell *= resolution.layerRatio);

    return distances;
}
/** Segments longer than two cells get more of them: in short ones the layers at the ends help. */
int cellsOn (double length, double largestCell)
{
    const auto cells = length / largestCell;
    return std::max (1, static_cast<int> (std::ceil (cells + 0.8 * std::max (0.0, cells - 2) - 1e-9)));
}
} // namespace

PlateLayout makeLayout (const PlateDescription& plate)
{
    const auto tolerance = closestLines * std::min (plate.lengthX, plate.lengthY);
    std::vector<double> x, y;

    for (const auto& ceramic : plate.common.ceramics)
    {
        x.insert (x.end(), { ceramic.x, ceramic.x + ceramic.sizeX });
        y.insert (y.end(), { ceramic.y, ceramic.y + ceramic.sizeY });
    }

    x = distinct (std::move (x), plate.lengthX, tolerance);
    y = distinct (std::move (y), plate.lengthY, tolerance);

    PlateLayout layout;
    layout.unit = std::max (plate.lengthX, plate.lengthY);
    layout.linesX = scaled (x, layout.unit);
    layout.linesY = scaled (y, layout.unit);

    for (std::size_t i = 0; i < plate.common.ceramics.size(); ++i)
    {
        const auto& ceramic = plate.common.ceramics[i];
        const PlatePatch patch { nearest (x, ceramic.x), nearest (x, ceramic.x + ceramic.sizeX), nearest (y, ceramic.y),
                                 nearest (y, ceramic.y + ceramic.sizeY) };

        if (patch.left == patch.right || patch.bottom == patch.top)
            throw InputError (ceramicPlace (i, ceramic), "is too narrow; allowed: at least 1/5000 of the plate's "
                                                         "shorter side");

        layout.patches.push_back (patch);
    }

    return layout;
}

CeramicDescription onLines (const PlateDescription& plate, const PlateLayout& layout, std::size_t index)
{
    auto ceramic = plate.common.ceramics[index];
    const auto& [left, right, bottom, top] = layout.patches[index];
    ceramic.x = layout.unit * layout.linesX[left];
    ceramic.y = layout.unit * layout.linesY[bottom];
    ceramic.sizeX = layout.unit * (layout.linesX[right] - layout.linesX[left]);
    ceramic.sizeY = layout.unit * (layout.linesY[top] - layout.linesY[bottom]);
    return ceramic;
}

SplineBreaks divide (const Eigen::VectorXd& lines, const PlateResolution& resolution, EdgeCondition start,
                     EdgeCondition end)
{
    std::vector<double> places { lines[0] };
    std::vector<int> multiplicity { 1 };
    const auto add = [&] (double place, int times)
    {
        places.push_back (place);
        multiplicity.push_back (times);
    };

    for (Eigen::Index s = 0; s + 1 < lines.size(); ++s)
    {
        const auto length = lines[s + 1] - lines[s];
        const auto cells = cellsOn (length, resolution.largestCell);
        const auto cell = length / cells;
        const auto layers = layerDistances (cell, resolution);

        for (const auto distance : layers)
            add (lines[s] + distance, 1);

        for (int i = 1; i < cells; ++i)
            add (lines[s] + i * cell, 1);

        for (auto distance = layers.rbegin(); distance != layers.rend(); ++distance)
            add (lines[s + 1] - *distance, 1);

        add (lines[s + 1], resolution.degree - 1);
    }

    SplineBreaks breaks;
    breaks.places = Eigen::Map<const Eigen::VectorXd> (places.data(), static_cast<Eigen::Index> (places.size()));
    breaks.multiplicity =
        Eigen::Map<const Eigen::VectorXi> (multiplicity.data(), static_cast<Eigen::Index> (multiplicity.size()));
    breaks.heldAtStart = heldDerivatives (start);
    breaks.heldAtEnd = heldDerivatives (end);
    return breaks;
}
} // namespace antinode
