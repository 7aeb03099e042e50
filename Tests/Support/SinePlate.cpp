#include "Support/SinePlate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace antinode::test
{
std::vector<std::pair<int, int>> SinePlate::halfWaves (int modes) const
{
    std::vector<std::pair<int, int>> pairs;

    for (int m = 1; m <= 2 * modes; ++m)
        for (int n = 1; m * n <= 2 * modes; ++n)
            pairs.emplace_back (m, n);

    const auto wave = [&] (const std::pair<int, int>& p)
    { return std::pow (p.first / lengthX, 2) + std::pow (p.second / lengthY, 2); };
    std::sort (pairs.begin(), pairs.end(), [&] (const auto& p, const auto& q) { return wave (p) < wave (q); });
    pairs.resize (static_cast<std::size_t> (modes));
    return pairs;
}

std::vector<Ceramic> SinePlate::ceramics() const
{
    std::vector<Ceramic> list;

    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
        {
            const auto number = static_cast<int> (list.size()) + 1;
            const auto x = lengthX * (i + 0.5 + 0.12 * std::sin (2.0 * number)) / columns;
            const auto y = lengthY * (j + 0.5 + 0.12 * std::cos (3.0 * number)) / rows;
            list.push_back ({ "C" + std::to_string (number), x - ceramicLength / 2, x + ceramicLength / 2,
                              y - ceramicWidth / 2, y + ceramicWidth / 2, 150 });
        }

    return list;
}

double SinePlate::participation (const Ceramic& ceramic, std::pair<int, int> half) const
{
    const auto k = half.first * std::numbers::pi / lengthX, l = half.second * std::numbers::pi / lengthY;
    const auto alongX = (std::cos (k * ceramic.xMinimum) - std::cos (k * ceramic.xMaximum)) / k;
    const auto alongY = (std::cos (l * ceramic.yMinimum) - std::cos (l * ceramic.yMaximum)) / l;
    return -momentPerVolt * (k * k + l * l) * amplitude() * alongX * alongY;
}

Surface SinePlate::surface() const
{
    const auto axis = [&] (double length)
    {
        return gridAxis (Eigen::VectorXd::LinSpaced (segments + 1, 0, length),
                         Eigen::VectorXi::Constant (segments, placesPerSegment));
    };
    Surface result;
    result.kind = SurfaceKind::plate;
    result.xMaximum = lengthX;
    result.yMaximum = lengthY;
    result.grid = PlateGrid { axis (lengthX), axis (lengthY) };
    const auto countX = result.grid->x.places.size(), countY = result.grid->y.places.size();
    result.points.resize (countX * countY, 2);
    result.areas.resize (countX * countY);

    for (Eigen::Index j = 0; j < countY; ++j)
    {
        const auto row = Eigen::seqN (j * countX, countX);
        result.points (row, 0) = result.grid->x.places;
        result.points (row, 1).setConstant (result.grid->y.places[j]);
        result.areas (row) = result.grid->x.weights * result.grid->y.weights[j];
    }

    result.masses = result.areas * massPerArea();
    return result;
}

ModalModel SinePlate::model (int modes) const
{
    const auto stiffness = young * std::pow (thickness, 3) / (12 * (1 - poisson * poisson));
    const auto halves = halfWaves (modes);
    ModalModel result;
    result.name = "sine plate";
    result.surface = surface();
    result.ceramics = ceramics();
    result.fullScaleVoltage = 150;
    result.dampingRatios = Eigen::VectorXd::Constant (modes, 0.5 / quality);
    result.angularFrequencies.resize (modes);
    result.shapes.resize (result.surface.points.rows(), modes);
    result.participation.resize (modes, static_cast<Eigen::Index> (result.ceramics.size()));

    for (int mode = 0; mode < modes; ++mode)
    {
        const auto half = halves[static_cast<std::size_t> (mode)];
        const auto k = half.first * std::numbers::pi / lengthX, l = half.second * std::numbers::pi / lengthY;
        result.angularFrequencies[mode] = (k * k + l * l) * std::sqrt (stiffness / massPerArea());
        result.shapes.col (mode) = (amplitude() * (k * result.surface.points.col (0).array()).sin()
                                    * (l * result.surface.points.col (1).array()).sin())
                                       .matrix();

        for (Eigen::Index i = 0; i < result.participation.cols(); ++i)
            result.participation (mode, i) = participation (result.ceramics[static_cast<std::size_t> (i)], half);
    }

    return result;
}

double SinePlate::amplitude() const
{
    return 2 / std::sqrt (massPerArea() * lengthX * lengthY);
}

ModalModel scatteredPlate (int modes, int points)
{
    const SinePlate plate;
    auto model = plate.model (modes);
    auto& surface = model.surface;
    surface.grid.reset();
    surface.points.resize (points, 2);

    // Halton's sequence with bases 2 and 3: even, and on no grid.
    const auto halton = [] (int index, int base)
    {
        double fraction = 1, result = 0;

        for (; index > 0; index /= base)
            result += (fraction /= base) * (index % base);

        return result;
    };

    for (int i = 0; i < points; ++i)
        surface.points.row (i) << plate.lengthX * halton (i + 1, 2), plate.lengthY * halton (i + 1, 3);

    surface.areas = Eigen::VectorXd::Constant (points, plate.lengthX * plate.lengthY / points);
    surface.masses = surface.areas * plate.massPerArea();
    model.coversWholeBody = false;
    model.shapes.resize (points, modes);
    const auto halves = plate.halfWaves (modes);

    for (int mode = 0; mode < modes; ++mode)
    {
        const auto [m, n] = halves[static_cast<std::size_t> (mode)];
        const auto k = m * std::numbers::pi / plate.lengthX, l = n * std::numbers::pi / plate.lengthY;
        model.shapes.col (mode) = (plate.amplitude() * (k * surface.points.col (0).array()).sin()
                                   * (l * surface.points.col (1).array()).sin())
                                      .matrix();
    }

    return model;
}
} // namespace antinode::test
