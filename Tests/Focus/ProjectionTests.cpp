#include "Support/SinePlate.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/Projection.h>
#include <antinode_focus/TargetField.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
/** A pinned string-like line of unit mass with sine shapes, which are orthonormal over it. */
ModalModel sineModel (int modes, int points)
{
    ModalModel model;
    model.name = "sines";
    model.surface.xMaximum = 1;
    model.surface.points = Eigen::MatrixX2d::Zero (points, 2);
    model.surface.points.col (0) = Eigen::VectorXd::LinSpaced (points, 0, 1);
    model.surface.masses = Eigen::VectorXd::Constant (points, 1.0 / (points - 1));
    model.surface.areas = model.surface.masses;
    model.angularFrequencies.resize (modes);
    model.dampingRatios = Eigen::VectorXd::Constant (modes, 0.01);
    model.shapes.resize (points, modes);
    model.participation = Eigen::MatrixXd::Ones (modes, 1);
    model.ceramics.resize (1);

    for (int k = 0; k < modes; ++k)
    {
        model.angularFrequencies[k] = 1000.0 * (k + 1) * (k + 1);
        model.shapes.col (k) =
            std::numbers::sqrt2 * ((k + 1) * std::numbers::pi * model.surface.points.col (0).array()).sin().matrix();
    }

    return model;
}
} // namespace

TEST_CASE ("The projection by mass weights recovers the amplitudes of modes", "[focus]")
{
    const auto model = sineModel (10, 201);
    Eigen::VectorXd amplitudes = Eigen::VectorXd::Zero (10);
    amplitudes[2] = 0.3;
    amplitudes[7] = -0.1;
    const auto target = projectField (model, model.shapes * amplitudes);
    CHECK ((target.modalVelocities - amplitudes).norm() < 1e-13);
    CHECK (target.energy == Approx (0.1).epsilon (1e-12));
}

TEST_CASE ("Where shapes cover a part only, the least-squares projection is right and mass weights are not", "[focus]")
{
    auto model = sineModel (6, 201);
    const auto part = Eigen::seq (0, 140);
    model.shapes = Eigen::MatrixXd (model.shapes (part, Eigen::all));
    model.surface.points = Eigen::MatrixX2d (model.surface.points (part, Eigen::all));
    model.surface.masses = Eigen::VectorXd (model.surface.masses (part));
    const Eigen::VectorXd amplitudes = (Eigen::VectorXd (6) << 1, -2, 0.5, 0, 3, 1).finished();
    const Eigen::VectorXd field = model.shapes * amplitudes;
    CHECK ((projectField (model, field).modalVelocities - amplitudes).norm() > 0.5);
    model.coversWholeBody = false;
    CHECK ((projectField (model, field).modalVelocities - amplitudes).norm() < 1e-10);
}

TEST_CASE ("Modes are chosen by energy, by frequency, by captured energy or by a highest frequency", "[focus]")
{
    const auto model = sineModel (8, 201);
    const Eigen::VectorXd amplitudes = (Eigen::VectorXd (8) << 0.1, 3, 0.2, 0, 4, 0, 0, 1).finished();
    const auto target = projectField (model, model.shapes * amplitudes);
    const auto total = amplitudes.squaredNorm();

    const auto byEnergy = selectModes (model, target, { 2, ModeOrder::energy, {}, {}, {} });
    CHECK (byEnergy.modes == std::vector<int> { 1, 4 });
    CHECK (byEnergy.captured == Approx (std::sqrt (25 / total)));
    CHECK (selectModes (model, target, { 2, ModeOrder::frequency, {}, {}, {} }).modes == std::vector<int> { 0, 1 });
    CHECK (selectModes (model, target, { {}, ModeOrder::energy, 0.99, {}, {} }).modes == std::vector<int> { 1, 4, 7 });
    CHECK (selectModes (model, target, { {}, ModeOrder::energy, {}, 9100 / (2 * std::numbers::pi), {} }).modes
           == std::vector<int> { 0, 1, 2 });
    CHECK ((byEnergy.truncated - 3 * model.shapes.col (1) - 4 * model.shapes.col (4)).norm() < 1e-11);
}

TEST_CASE ("A mode that no ceramic excites is not chosen", "[focus]")
{
    auto model = sineModel (4, 101);
    model.participation (1, 0) = 0;
    const auto target = projectField (model, model.shapes * Eigen::Vector4d (1, 5, 2, 3));
    CHECK (selectModes (model, target, { 2, ModeOrder::energy, {}, {}, {} }).modes == std::vector<int> { 2, 3 });
    CHECK_THROWS_WITH (selectModes (model, target, { 4, ModeOrder::energy, {}, {}, {} }),
                       Catch::Contains ("focus: number of modes: is 4; allowed: 1 to 3, the simulated modes of "));
    model.participation.setZero();
    CHECK_THROWS_AS (selectModes (model, target, {}), InputError);
}

TEST_CASE ("A captured fraction that cannot be reached is an error that gives the largest possible one", "[focus]")
{
    const auto model = sineModel (3, 101);
    const Eigen::VectorXd field = Eigen::VectorXd::Ones (101);
    CHECK_THROWS_WITH (selectModes (model, projectField (model, field), { {}, ModeOrder::energy, 0.999, {}, {} }),
                       Catch::Contains ("captured fraction: is 0.999; allowed: up to 0.9")
                           && Catch::Contains ("all 3 modes together capture"));
}

namespace
{
/** How many modes a capture takes when every count is tried, in the order that selectModes gives. */
ModeSelection firstThatCaptures (const ModalModel& model, const ProjectedTarget& target, double wanted)
{
    for (int count = 1; count <= static_cast<int> (model.modes()); ++count)
    {
        auto selection = selectModes (model, target, { count, ModeOrder::energy, {}, {}, {} });

        if (selection.captured >= wanted)
            return selection;
    }

    return {};
}
} // namespace

TEST_CASE ("The modes for a capture are those that trying every count gives", "[focus]")
{
    auto dependent = test::scatteredPlate (24, 60);
    dependent.shapes.col (7) = 2 * dependent.shapes.col (3) - dependent.shapes.col (1);

    for (const auto& model : { test::SinePlate().model (60), test::scatteredPlate (40, 300), dependent })
    {
        const auto target = projectField (
            model, targetField (model.surface, { { TargetShape::gaussian, 0.07, 0.08, 0.035, 0.04, 1 } }, {}));

        for (const auto wanted : { 0.2, 0.5, 0.8, 0.9, 0.92 })
        {
            INFO (model.surface.points.rows() << " points, captured " << wanted);
            const auto expected = firstThatCaptures (model, target, wanted);
            const auto selection = selectModes (model, target, { {}, ModeOrder::energy, wanted, {}, {} });
            CHECK (selection.modes == expected.modes);
            CHECK (selection.captured == expected.captured);
            CHECK (selection.truncated == expected.truncated);
        }
    }
}

TEST_CASE ("On a plate the modal velocities of a target are its Fourier coefficients", "[focus]")
{
    // A separable gaussian far from the edges: the integrals are those over the whole plane, product of
    // sqrt (pi / c) exp (-k^2 / 4c) sin (k x_c) with c = 4 ln 2 / width^2. What is cut off at the edges is below exp
    // (-40).
    const test::SinePlate plate;
    const auto model = plate.model (40);
    const Target wanted { TargetShape::gaussian, 0.09, 0.08, 0.02, 0.04, 1, TargetProfile::separable, 0.016 };
    const auto target = projectField (model, targetField (model.surface, { wanted }, {}));
    const auto halves = plate.halfWaves (40);
    const auto factor = [] (double wave, double centre, double width)
    {
        const auto c = 4 * std::numbers::ln2 / (width * width);
        return std::sqrt (std::numbers::pi / c) * std::exp (-wave * wave / (4 * c)) * std::sin (wave * centre);
    };

    for (Eigen::Index mode = 0; mode < 40; ++mode)
    {
        const auto [m, n] = halves[static_cast<std::size_t> (mode)];
        const auto expected = plate.massPerArea() * plate.amplitude() * 0.04
                              * factor (m * std::numbers::pi / plate.lengthX, 0.09, 0.02)
                              * factor (n * std::numbers::pi / plate.lengthY, 0.08, 0.016);
        CHECK (target.modalVelocities[mode] == Approx (expected).margin (1e-9));
    }
}

TEST_CASE ("Modes that measured points hide are controlled only where somebody asks", "[focus]")
{
    Eigen::MatrixX2d grid (96, 2);

    for (Eigen::Index p = 0; p < grid.rows(); ++p)
        grid.row (p) << static_cast<double> (p / 8), static_cast<double> (p % 8);

    // 15 modes in the plane have waves of which 96 points are 2.5 a half wave, 4 modes those of 11 points on a line.
    CHECK (pointsPerHalfWave (grid, 15) > enoughPointsPerHalfWave);
    CHECK (pointsPerHalfWave (grid, 16) < enoughPointsPerHalfWave);

    auto model = sineModel (8, 11);
    const auto target = projectField (model, model.shapes * Eigen::VectorXd::Ones (8));
    CHECK (resolvedModes (model) == 8);
    CHECK (selectModes (model, target, {}).modes.size() == 8);
    model.origin = { ModeSource::measured, 11, 0.01, true };
    CHECK (resolvedModes (model) == 4);
    CHECK (selectModes (model, target, {}).modes == std::vector<int> { 0, 1, 2, 3 });
    CHECK (selectModes (model, target, { 8, ModeOrder::frequency, {}, {}, {} }).modes.size() == 8);
}
