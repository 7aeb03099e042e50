#include "Support/GridModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace antinode::test
{
ModalModel gridModel (int modesAlongX, int ceramics, int placesASegment)
{
    constexpr double a = 0.2, b = 0.12, surfaceMass = 2.7, pi = std::numbers::pi;
    ModalModel model;
    model.name = "pane";
    model.fullScaleVoltage = 150;
    model.unknowns = 1234;
    auto& surface = model.surface;
    surface.kind = SurfaceKind::plate;
    surface.xMaximum = a;
    surface.yMaximum = b;
    surface.held = { true, false, true, false };
    surface.grid = { gridAxis (Eigen::Vector4d (0, 0.05, 0.08, a), Eigen::Vector3i::Constant (placesASegment)),
                     gridAxis (Eigen::Vector3d (0, 0.07, b), Eigen::Vector2i::Constant (placesASegment)) };
    const auto& [x, y] = *surface.grid;
    const auto count = x.places.size() * y.places.size();
    surface.points.resize (count, 2);
    surface.areas.resize (count);
    model.shapes.resize (count, modesAlongX);

    for (Eigen::Index j = 0; j < y.places.size(); ++j)
        for (Eigen::Index i = 0; i < x.places.size(); ++i)
        {
            const auto p = i + j * x.places.size();
            surface.points.row (p) << x.places[i], y.places[j];
            surface.areas[p] = x.weights[i] * y.weights[j];

            for (int k = 0; k < modesAlongX; ++k)
                model.shapes (p, k) = 2 / std::sqrt (surfaceMass * a * b) * std::sin ((k + 1) * pi * x.places[i] / a)
                                      * std::sin ((k % 2 + 1) * pi * y.places[j] / b);
        }

    surface.masses = surfaceMass * surface.areas;

    model.angularFrequencies = Eigen::VectorXd::LinSpaced (modesAlongX, 1e3 / 3, 1e3 * modesAlongX);
    model.dampingRatios = Eigen::VectorXd::LinSpaced (modesAlongX, 0.003, 0.007);
    model.frequencyErrors = Eigen::VectorXd::LinSpaced (modesAlongX, 1e-9, 1e-5);
    model.participation = Eigen::MatrixXd::NullaryExpr (
        modesAlongX, ceramics, [] (Eigen::Index k, Eigen::Index i) { return std::sin (1.0 + double (k * 7 + i)) / 3; });

    for (int i = 0; i < ceramics; ++i)
        model.ceramics.push_back ({ "C" + std::to_string (i + 1), 0.01 * i, 0.01 * i + 0.008, 0.02, 0.03, 150 });

    return model;
}
} // namespace antinode::test
