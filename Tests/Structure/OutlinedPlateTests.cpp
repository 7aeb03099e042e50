#include "PlateExamples.h"

#include "Immersed/BendingExamples.h"
#include "Support/CircularPlates.h"

#include <antinode_base/InputError.h>
#include <antinode_outline/PathBuilder.h>
#include <antinode_structure/OutlinedModel.h>
#include <antinode_structure/PlacementCandidates.h>

#include <random>

using namespace antinode;
using namespace antinode::examples;

namespace
{
CeramicDescription disc (double x, double y, double diameter)
{
    auto ceramic = plateCeramic (x - diameter / 2, y - diameter / 2, diameter, diameter);
    ceramic.shape = CeramicShape::disc;
    return ceramic;
}

/** 200 x 120 mm with corners of 15 mm radius and a hole, and something of everything. */
OutlinedPlate richPlate()
{
    OutlinedPlate plate;
    plate.common = plainCommon (1e-3);
    plate.outline.paths = { rectanglePath ({ 0.1, 0.06 }, { 0.2, 0.12 }, 0, { 0.015, 0.015, 0.015, 0.015 }, 0),
                            circlePath ({ 0.15, 0.08 }, 0.012, 4) };
    plate.edges.resize (5);
    plate.edges[0].condition = EdgeCondition::clamped;
    plate.edges[2] = { EdgeCondition::free, 2e5, 0.5, 0.1 };
    auto turned = plateCeramic (0.06, 0.05, 0.025, 0.02);
    turned.angle = 0.5;
    plate.common.ceramics = { disc (0.04, 0.085, 0.02), turned };
    plate.areas = { { { { circlePath ({ 0.11, 0.03 }, 0.01, 0) } }, 1e7, 0.2, 1.5 } };
    plate.points = { { 0.18, 0.03, 5e3, 0, 0, 2e-3 } };
    return plate;
}

Eigen::MatrixXd gram (const ModalModel& model)
{
    return model.shapes.transpose() * model.surface.masses.asDiagonal() * model.shapes;
}

OutlinedPlate circle (const PlateEdge& edge, double radius = 0.1)
{
    OutlinedPlate plate;
    plate.common = barePlate ("FFFF", 0.1, 0.1).common;
    plate.outline.paths = { circlePath ({ 0, 0 }, radius, 0) };
    plate.edges = { edge };
    return plate;
}
} // namespace

TEST_CASE ("Points and masses of an outlined plate make its shapes orthonormal to 1e-4", "[structure][outlined]")
{
    const auto model = solveOutlinedPlate ("rich", richPlate(), 40);
    const Eigen::MatrixXd error = gram (model) - Eigen::MatrixXd::Identity (40, 40);
    INFO (model.points() << " points, " << model.unknowns << " unknowns");
    CHECK (error.cwiseAbs().maxCoeff() < 1e-4);

    // The mass of all points is that of the plate with what lies on it.
    const auto area = areaOf (model.surface.boundary->outline);
    CHECK (model.surface.areas.sum() == Approx (area).epsilon (1e-9));

    // Nothing is wild where only the grid needs values.
    const auto on = pointsOn (model.surface);
    CHECK (model.shapes.cwiseAbs().maxCoeff() < 4 * model.shapes (on, Eigen::all).cwiseAbs().maxCoeff());
}

TEST_CASE ("Between the points of an outlined plate its shapes are those at exact places", "[structure][outlined]")
{
    const auto plate = richPlate();
    const auto model = solveOutlinedPlate ("rich", plate, 40);
    const auto& surface = model.surface;
    const auto on = pointsOn (surface);
    const auto amplitude = model.shapes (on, Eigen::all).cwiseAbs().maxCoeff();
    const auto gridSize = surface.grid->x.places.size() * surface.grid->y.places.size();
    double worst = 0;

    // The places in cut cells know their shapes from the modes themselves, the grid does not know of them.
    for (const auto point : on)
        if (point >= gridSize)
            worst = std::max (worst, (shapesAt (model, surface.points (point, 0), surface.points (point, 1))
                                      - model.shapes.row (point))
                                         .cwiseAbs()
                                         .maxCoeff());

    INFO (worst / amplitude);
    CHECK (worst < 2e-3 * amplitude);
    CHECK_THROWS_AS (shapesAt (model, 0.15, 0.08), InputError);
    CHECK_THROWS_AS (shapesAt (model, 0.001, 0.001), InputError);
    CHECK_NOTHROW (shapesAt (model, 0.1, 0.0));
}

TEST_CASE ("A rectangle by its outline has modes and participations of the aligned solver", "[structure][outlined]")
{
    auto plate = barePlate ("CFSF", 0.2, 0.12);
    const auto bare = solveOutlinedPlate ("outline", outlinedPlate (plate), 30);
    const auto reference = solveStructure ({ "aligned", {}, plate }, 60);
    CHECK ((bare.angularFrequencies.array() / reference.angularFrequencies.head (30).array() - 1).abs().maxCoeff()
           < 1e-6);

    plate = patchedPlate();
    const auto patched = solveOutlinedPlate ("outline", outlinedPlate (plate), 30);
    const auto aligned = solveStructure ({ "aligned", {}, plate }, 30);
    INFO (patched.unknowns << " against " << aligned.unknowns);
    CHECK ((patched.angularFrequencies.array() / aligned.angularFrequencies.array() - 1).abs().maxCoeff() < 1e-4);
    CHECK ((patched.participation - aligned.participation).cwiseAbs().maxCoeff()
           < 2e-3 * aligned.participation.cwiseAbs().maxCoeff());
}

TEST_CASE ("A circle on springs has the frequencies of Bessel's determinants", "[structure][outlined]")
{
    const PlateEdge springs { EdgeCondition::free, 1e6, 2.0, 0 };
    const auto plate = circle (springs);
    const auto model = solveOutlinedPlate ("circle", plate, 30);
    const auto& material = plate.common.material;
    const auto stiffness = material.youngsModulus1 * std::pow (plate.common.thickness, 3)
                           / (12 * (1 - material.poissonRatio12 * material.poissonRatio12));
    const tests::CircularPlate expected { 0,
                                          { { 0.1, stiffness, material.poissonRatio12,
                                              material.density * plate.common.thickness } },
                                          {},
                                          { springs.translation, springs.rotation } };
    CHECK (deviationFrom (model.angularFrequencies, expected) < 1e-5);
}

TEST_CASE ("Losses of springs damp by their share of a mode's energy", "[structure][outlined]")
{
    // Hellmann and Feynman: the share of a spring in the energy is d ln omega^2 / d ln k.
    constexpr double lossFactor = 0.1, step = 1e-3;
    const PlateEdge springs { EdgeCondition::free, 1e6, 2.0, lossFactor };
    auto more = springs, less = springs;

    for (const auto& [edge, factor] : { std::pair { &more, 1 + step }, std::pair { &less, 1 - step } })
    {
        edge->translation *= factor;
        edge->rotation *= factor;
    }

    const auto model = solveOutlinedPlate ("circle", circle (springs), 12);
    const auto up = solveOutlinedPlate ("circle", circle (more), 12);
    const auto down = solveOutlinedPlate ("circle", circle (less), 12);
    const Eigen::ArrayXd shares =
        (up.angularFrequencies.array() / down.angularFrequencies.array()).log() * 2 / (2 * step);
    const Eigen::ArrayXd expected = circle (springs).common.dampingRatios.front() + lossFactor / 2 * shares;
    CHECK ((model.dampingRatios.array() / expected - 1).abs().maxCoeff() < 1e-3);
}

TEST_CASE ("A foundation under all of a plate adds k / m to every squared frequency, and its losses",
           "[structure][outlined]")
{
    constexpr double stiffness = 2e7, lossFactor = 0.3;
    auto plate = circle ({ EdgeCondition::clamped });
    const auto bare = solveOutlinedPlate ("bare", plate, 20);
    plate.foundation = stiffness;
    plate.foundationLoss = lossFactor;
    const auto model = solveOutlinedPlate ("padded", plate, 20);
    const auto added = stiffness / (plate.common.material.density * plate.common.thickness);
    const Eigen::ArrayXd squares = model.angularFrequencies.array().square();
    CHECK ((squares / (bare.angularFrequencies.array().square() + added) - 1).abs().maxCoeff() < 1e-8);
    const Eigen::ArrayXd damping = plate.common.dampingRatios.front() + lossFactor / 2 * added / squares;
    CHECK ((model.dampingRatios.array() / damping - 1).abs().maxCoeff() < 1e-4);
}

TEST_CASE ("A dashpot damps a mode by the square of its shape", "[structure][outlined]")
{
    auto plate = circle ({ EdgeCondition::clamped });
    plate.points = { { 0.03, 0.02, 0, 0, 0.2, 0 } };
    const auto model = solveOutlinedPlate ("dashpot", plate, 10);
    const Eigen::ArrayXd shape = shapesAt (model, 0.03, 0.02).transpose();
    const Eigen::ArrayXd expected =
        plate.common.dampingRatios.front() + 0.2 * shape.square() / (2 * model.angularFrequencies.array());
    CHECK ((model.dampingRatios.array() / expected - 1).abs().maxCoeff() < 1e-3);
}

TEST_CASE ("All modes up to a frequency are as many as a larger number has below it", "[structure][outlined]")
{
    auto plate = circle ({ EdgeCondition::free });
    const auto all = solveOutlinedPlate ("circle", plate, 60);
    plate.common.maximumFrequency = (all.frequencyHz (40) + all.frequencyHz (41)) / 2 + 1;
    const auto some = solveOutlinedPlate ("circle", plate, {});
    CHECK (some.modes()
           == (all.angularFrequencies.array() <= 2 * std::numbers::pi * *plate.common.maximumFrequency).count());
    CHECK (some.rigidBodyModes == 3);
}

TEST_CASE ("Candidates on an outlined rectangle are those on a rectangle", "[structure][outlined][placement]")
{
    const auto plate = barePlate ("CFFF", 0.2, 0.12);
    CandidateGrid grid;
    grid.step = 0.02;
    grid.modes = 12;
    const auto like = plateCeramic (0, 0, 0.03, 0.02);
    const auto aligned = placementCandidates ({ "aligned", {}, plate }, like, grid);
    const auto outlined = placementCandidates ({ "outline", {}, outlinedPlate (plate) }, like, grid);
    REQUIRE (outlined.ceramics.size() == aligned.ceramics.size());
    const Eigen::MatrixXd difference = outlined.participation.cwiseAbs() - aligned.participation.cwiseAbs();
    CHECK (difference.cwiseAbs().maxCoeff() < 1e-4 * aligned.participation.cwiseAbs().maxCoeff());
    CHECK (outlined.overlap (0, 1) == aligned.overlap (0, 1));

    // Discs lie within a circle, and two overlap where their centres are nearer than a diameter.
    const auto discs = placementCandidates ({ "round", {}, circle ({ EdgeCondition::free }) }, disc (0, 0, 0.03), grid);
    REQUIRE (discs.ceramics.size() > 20);

    for (const auto& ceramic : discs.ceramics)
        CHECK (ceramic.centre().norm() < 0.1 - 0.015 + 1e-9);
}

TEST_CASE ("What cannot be an outlined plate is one sentence", "[structure][outlined]")
{
    const auto fails = [] (const OutlinedPlate& plate)
    {
        try
        {
            solveOutlinedPlate ("broken", plate, 5);
        }
        catch (const InputError& error)
        {
            return std::string (error.what()).find ("; allowed:") != std::string::npos;
        }

        return false;
    };
    auto plate = richPlate();
    plate.common.ceramics = { disc (0.15, 0.08, 0.05) }; // over the hole
    CHECK (fails (plate));
    plate.common.ceramics = { disc (0.005, 0.06, 0.02) }; // across the edge
    CHECK (fails (plate));
    plate.common.ceramics = { disc (0.05, 0.06, 0.02), disc (0.06, 0.06, 0.02) }; // on each other
    CHECK (fails (plate));
    plate = richPlate();
    plate.points.front().x = 0.15;
    plate.points.front().y = 0.08; // in the hole
    CHECK (fails (plate));
    plate = richPlate();
    plate.edges[1].translation = std::nan ("");
    CHECK (fails (plate));
    plate = richPlate();
    plate.points.front().damping = 1e9; // no mode is left
    CHECK_THROWS_AS (solveOutlinedPlate ("damped", plate, 5), InputError);
}
