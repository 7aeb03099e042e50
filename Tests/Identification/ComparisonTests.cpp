#include "Support/ModelOfStructure.h"

#include <antinode_identification/Comparison.h>
#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** A beam of eight modes as a model of a device. */
KnownStructure eightModes()
{
    return lowestModes (knownBeam (11, 40, 4), 8);
}

FrequencyResponses measured (const KnownStructure& structure)
{
    auto responses = idealResponses (structure, lines (200, 7000, 2));
    addNoise (responses, 40, 6);
    return responses;
}
} // namespace

TEST_CASE ("The MAC of a shape with itself is 1, with one at a right angle 0, whatever its size", "[identification]")
{
    Eigen::MatrixXd one (3, 2), other (3, 2);
    one << 1, 0, 2, 1, 2, -1;
    other << -3, 4, -6, 0, -6, 4;
    const auto assurance = modalAssurance (one, other, {});
    CHECK (assurance (0, 0) == Approx (1));
    CHECK (assurance (1, 0) == Approx (0).margin (1e-15));
    // (0, 1, -1) and (4, 0, 4): cosine -4 / (sqrt 2 sqrt 32).
    CHECK (assurance (1, 1) == Approx (0.25));
}

TEST_CASE ("Identified and computed modes are paired by shape, not by number", "[identification]")
{
    const auto structure = eightModes();
    auto model = makeModel (structure);
    // The computed device lacks a mode, and its frequencies are wrong by up to 6 %.
    const std::vector<Eigen::Index> kept { 0, 1, 3, 4, 5, 6, 7 };
    model.angularFrequencies = model.angularFrequencies (kept).eval() * 1.06;
    model.dampingRatios = model.dampingRatios (kept).eval();
    model.shapes = model.shapes (Eigen::all, kept).eval();
    model.slopes = model.slopes (Eigen::all, kept).eval();
    model.participation = model.participation (kept, Eigen::all).eval();
    model.frequencyErrors.resize (0);
    const Eigen::MatrixXd participation = model.participation;
    model.participation *= 1.3; // As when a data sheet's d31 is too large.
    const auto identified = identify (measured (structure), {});
    REQUIRE (identified.modes() == 8);
    const auto comparison = compareModes (identified, model);
    REQUIRE (comparison.pairs.size() == 7);

    for (const auto& pair : comparison.pairs)
    {
        CHECK (pair.identified == kept[static_cast<std::size_t> (pair.computed)]);
        CHECK (pair.assurance > 0.999);
        CHECK (pair.relativeDifference == Approx (1 / 1.06 - 1).margin (1e-4));
    }

    const auto moved = transferred (model, identified, comparison);
    CHECK ((moved.angularFrequencies / (2 * std::numbers::pi) - structure.frequencies (kept)).cwiseAbs().maxCoeff()
           < 0.1);
    CHECK ((moved.dampingRatios - structure.dampingRatios (kept)).cwiseAbs().maxCoeff() < 1e-4);
    CHECK ((moved.participation - participation).norm() < 1e-2 * participation.norm());
    CHECK (moved.origin.source == ModeSource::retuned);
}

TEST_CASE ("An identified device has its points' shares of the surface as weights", "[identification]")
{
    const auto identified = identify (measured (eightModes()), {});
    const auto model = toModalModel (identified, {});
    CHECK (model.surface.kind == SurfaceKind::line);
    CHECK (model.surface.areas.sum() == Approx (0.15));
    CHECK (model.surface.areas[0] == Approx (model.surface.areas[1] / 2));
    CHECK (model.slopes.rows() == 40);
    CHECK (model.ceramics[3].name == "C4");
    // Median shape of modal mass 1.
    const Eigen::VectorXd modal = model.shapes.cwiseAbs2().transpose() * model.surface.masses;
    CHECK (modal.minCoeff() > 0.9);
    CHECK (modal.maxCoeff() < 1.1);
}

TEST_CASE ("On a grid of points the cells are those of the trapezoidal rule, on scattered ones they fill the rectangle",
           "[identification]")
{
    IdentifiedModes modes;
    modes.points.resize (6, 2);
    modes.points << 0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1;
    modes.angularFrequencies.setConstant (1, 100);
    modes.dampingRatios.setConstant (1, 0.01);
    modes.shapes.setOnes (6, 1);
    modes.participation.setOnes (1, 1);
    modes.references = { { "C1", {} } };
    modes.deviations.angularFrequencies.setZero (1);
    const auto model = toModalModel (modes, {});
    CHECK (model.surface.areas[0] == Approx (0.25));
    CHECK (model.surface.areas[1] == Approx (0.5));
    CHECK (model.surface.areas.sum() == Approx (2));

    modes.points.row (4) << 1.3, 0.6;
    CHECK (toModalModel (modes, {}).surface.areas.sum() == Approx (2));

    modes.points.row (4) = modes.points.row (1);
    CHECK_THROWS_WITH (toModalModel (modes, {}), Catch::Contains ("have the same position"));
}
