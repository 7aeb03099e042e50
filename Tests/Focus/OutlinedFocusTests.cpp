#include "Structure/PlateExamples.h"
#include "Support/CircularPlates.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_outline/PathBuilder.h>
#include <antinode_structure/OutlinedModel.h>

#include <cmath>
#include <numbers>

using namespace antinode;
using namespace antinode::examples;

namespace
{
FocusDescription focusAt (double x, double y, double width, int modes)
{
    FocusDescription focus;
    Target target;
    target.shape = TargetShape::gaussian;
    target.x = x;
    target.y = y;
    target.width = width;
    target.peakVelocity = 0.01;
    focus.targets = { target };
    focus.focusTime = 0.03;
    focus.modes.count = modes;
    focus.modes.order = ModeOrder::frequency;
    return focus;
}

/** Modes of a clamped circle of radius 1 with D = m = 1: J_n (k r) - J_n (k) / I_n (k) I_n (k r), times cos or sin. */
struct BesselMode
{
    int diameters = 0;
    double waveNumber = 0, scale = 1;
    bool isSine = false;

    double radial (double r) const
    {
        const auto n = static_cast<double> (diameters);
        return scale
               * (std::cyl_bessel_j (n, waveNumber * r)
                  - std::cyl_bessel_j (n, waveNumber) / std::cyl_bessel_i (n, waveNumber)
                        * std::cyl_bessel_i (n, waveNumber * r));
    }

    double operator() (double x, double y) const
    {
        const auto angle = diameters * std::atan2 (y, x);
        return radial (std::hypot (x, y)) * (isSine ? std::sin (angle) : std::cos (angle));
    }
};

/** The field of a gaussian that the lowest modes represent, by quadrature in polar coordinates. */
class BesselField
{
public:
    BesselField (int count, double x, double y, double width)
    {
        constexpr int rings = 200, spokes = 256;
        const tests::CircularPlate plate { 0, { { 1, 1, 0.3, 1 } }, {}, { tests::rigid, tests::rigid } };
        auto last = -1.0;

        for (const auto& found : tests::circularModes (plate, count))
        {
            BesselMode mode { found.diameters, std::sqrt (found.angularFrequency) };
            mode.isSine = found.diameters > 0 && found.angularFrequency == last;
            last = found.angularFrequency;
            double square = 0, product = 0;

            for (int i = 0; i < rings; ++i)
                for (int j = 0; j < spokes; ++j)
                {
                    const auto r = (i + 0.5) / rings, angle = 2 * std::numbers::pi * (j + 0.5) / spokes;
                    const auto px = r * std::cos (angle), py = r * std::sin (angle), value = mode (px, py);
                    const auto distance = std::hypot (px - x, py - y) / width;
                    square += r * value * value;
                    product += r * value * std::exp (-4 * std::numbers::ln2 * distance * distance);
                }

            modes.push_back (mode);
            coefficients.push_back (product / square);
        }
    }

    double operator() (double x, double y) const
    {
        double sum = 0;

        for (std::size_t k = 0; k < modes.size(); ++k)
            sum += coefficients[k] * modes[k](x, y);

        return sum;
    }

private:
    std::vector<BesselMode> modes;
    std::vector<double> coefficients;
};
} // namespace

TEST_CASE ("A focus on a clamped circle is that of Bessel's modes", "[focus][outlined]")
{
    constexpr double radius = 0.1, x = 0.25, y = -0.1, width = 0.5;
    constexpr int count = 30;
    OutlinedPlate plate;
    plate.common = barePlate ("FFFF", 0.1, 0.1).common;
    plate.outline.paths = { circlePath ({ 0, 0 }, radius, 0) };
    plate.edges = { { EdgeCondition::clamped } };

    for (int k = 0; k < 5; ++k)
    {
        const auto angle = 2 * std::numbers::pi * k / 5 + 0.2;
        auto ceramic = plateCeramic (0.05 * std::cos (angle) - 0.008, 0.05 * std::sin (angle) - 0.008, 0.016, 0.016,
                                     1e-8); // So thin that the plate is bare.
        ceramic.shape = CeramicShape::disc;
        plate.common.ceramics.push_back (ceramic);
    }

    auto model = solveOutlinedPlate ("circle", plate, 40);

    for (auto& ceramic : model.ceramics)
        ceramic.voltageLimit = 1e12;

    model.fullScaleVoltage = 1e12;
    const auto design = designFocus (model, focusAt (x * radius, y * radius, width * radius, count), {});
    const BesselField expected (count, x, y, width);
    REQUIRE (design.controlledModes.size() == count);
    double worst = 0;

    for (const auto point : pointsOn (model.surface))
    {
        const auto& at = model.surface.points;
        worst = std::max (worst, std::abs (design.truncatedField[point] / 0.01
                                           - expected (at (point, 0) / radius, at (point, 1) / radius)));
    }

    CHECK (worst < 1e-3);
}

TEST_CASE ("A focus on a rectangle needs the same voltages by its outline", "[focus][outlined]")
{
    const auto plate = patchedPlate();
    const auto aligned = solveStructure ({ "aligned", {}, plate }, 24);
    const auto outlined = solveOutlinedPlate ("outline", outlinedPlate (plate), 24);
    auto focus = focusAt (0.13, 0.05, 0.06, 8);
    focus.targets.front().peakVelocity = 0.002;
    const auto first = designFocus (aligned, focus, {}), second = designFocus (outlined, focus, {});
    CHECK (first.captured == Approx (second.captured).epsilon (1e-4));
    CHECK (peakVoltage (first) == Approx (peakVoltage (second)).epsilon (1e-3));
}
