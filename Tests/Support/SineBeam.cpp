#include "Support/SineBeam.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace antinode::test
{
ModalModel sineBeam (int modes, int ceramics, double qualityFactor)
{
    constexpr double length = 0.2, width = 0.015, thickness = 0.002, young = 70e9, density = 2700;
    constexpr double momentPerVolt = -1.3e-3; // N m / V
    constexpr int points = 401;
    constexpr double pi = std::numbers::pi;
    const auto lineMass = density * width * thickness;
    const auto stiffness = young * width * thickness * thickness * thickness / 12;
    const auto scale = std::sqrt (2 / (lineMass * length));

    ModalModel model;
    model.name = "sine beam";
    auto& surface = model.surface;
    surface.xMinimum = -length / 2;
    surface.xMaximum = length / 2;
    surface.points = Eigen::MatrixX2d::Zero (points, 2);
    surface.points.col (0) = Eigen::VectorXd::LinSpaced (points, -length / 2, length / 2);
    surface.areas = Eigen::VectorXd::Constant (points, length * width / (points - 1));
    surface.areas[0] /= 2;
    surface.areas[points - 1] /= 2;
    surface.masses = surface.areas * density * thickness;
    model.angularFrequencies.resize (modes);
    model.dampingRatios = Eigen::VectorXd::Constant (modes, 0.5 / qualityFactor);
    model.shapes.resize (points, modes);
    model.slopes.resize (points, modes);
    model.participation.resize (modes, ceramics);
    model.fullScaleVoltage = 150;

    for (int i = 0; i < ceramics; ++i)
    {
        // Uneven places and lengths, so that no mode is blind to all of them.
        const auto centre = -0.085 + 0.17 * (i + 0.1 * std::sin (3.0 * i)) / std::max (ceramics - 1, 1);
        const auto half = 0.004 + 0.0015 * (i % 3);
        model.ceramics.push_back ({ "C" + std::to_string (i + 1), centre - half, centre + half, 0, 0, 150 });
    }

    for (int k = 0; k < modes; ++k)
    {
        const auto wave = (k + 1) * pi / length;
        const Eigen::ArrayXd phase = wave * (surface.points.col (0).array() + length / 2);
        model.angularFrequencies[k] = wave * wave * std::sqrt (stiffness / lineMass);
        model.shapes.col (k) = scale * phase.sin().matrix();
        model.slopes.col (k) = scale * wave * phase.cos().matrix();

        for (int i = 0; i < ceramics; ++i)
        {
            const auto& ceramic = model.ceramics[static_cast<std::size_t> (i)];
            const auto slope = [&] (double x) { return scale * wave * std::cos (wave * (x + length / 2)); };
            model.participation (k, i) = momentPerVolt * (slope (ceramic.xMaximum) - slope (ceramic.xMinimum));
        }
    }

    return model;
}
} // namespace antinode::test
