#include "StructureExamples.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace antinode;
using namespace antinode::examples;

namespace
{
BeamDescription beamWithCeramics()
{
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::simplySupported);
    auto oneSided = ceramicPair (0.06, 0.02, 0.01, 0.3e-3);
    oneSided.mounting = CeramicMounting::oneSide;
    beam.common.ceramics = { ceramicPair (-0.05, 0.03, 0.008, 0.5e-3), oneSided };
    return beam;
}

/** The same body seen from behind: x becomes -x. */
BeamDescription mirrored (BeamDescription beam)
{
    std::swap (beam.left, beam.right);

    for (auto& ceramic : beam.common.ceramics)
        ceramic.x = -ceramic.x - ceramic.sizeX;

    return beam;
}

StapleDescription mirrored (StapleDescription staple)
{
    for (auto& ceramic : staple.common.ceramics)
        ceramic.x = -ceramic.x - ceramic.sizeX;

    return staple;
}

template <typename Body>
void checkMirror (const Body& body, int modes)
{
    const auto model = solved (body, modes);
    const auto image = solved (mirrored (body), modes);
    REQUIRE (image.points() == model.points());
    CHECK ((image.surface.points.col (0).reverse() + model.surface.points.col (0)).norm() < 1e-12);
    CHECK ((image.angularFrequencies - model.angularFrequencies).norm() < 1e-10 * model.angularFrequencies.norm());

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const Eigen::VectorXd reflected = image.shapes.col (k).reverse();
        const auto sign = reflected.dot (model.shapes.col (k)) > 0 ? 1.0 : -1.0;
        CAPTURE (k);
        CHECK ((sign * reflected - model.shapes.col (k)).norm() < 1e-7 * model.shapes.col (k).norm());
        CHECK ((sign * image.participation.row (k) - model.participation.row (k)).norm()
               < 1e-7 * model.participation.row (k).norm());
    }
}
} // namespace

TEST_CASE ("a beam's shapes are orthonormal in its mass", "[structure]")
{
    const auto free = solved (uniformBeam (EdgeCondition::free, EdgeCondition::free));
    CHECK ((gramMatrix (free) - Eigen::MatrixXd::Identity (40, 40)).cwiseAbs().maxCoeff() < 1e-9);

    const auto loaded = solved (beamWithCeramics(), 20);
    CHECK ((gramMatrix (loaded) - Eigen::MatrixXd::Identity (20, 20)).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE ("a beam's masses sum up to substrate and ceramics", "[structure]")
{
    const auto model = solved (beamWithCeramics(), 5);
    const auto ceramics = 7800 * (2 * 0.03 * 0.008 * 0.5e-3 + 0.02 * 0.01 * 0.3e-3);
    CHECK (model.surface.masses.sum() == Approx (2700 * 0.2 * 0.01 * 1e-3 + ceramics).epsilon (1e-12));
    CHECK (model.surface.areas.sum() == Approx (0.2 * 0.01).epsilon (1e-12));
    CHECK (model.surface.points.col (0).minCoeff() == model.surface.xMinimum);
    CHECK (model.surface.points.col (0).maxCoeff() == model.surface.xMaximum);
}

TEST_CASE ("a pinned beam's shapes are sines, at the points and between them", "[structure]")
{
    const auto beam = uniformBeam (EdgeCondition::simplySupported, EdgeCondition::simplySupported);
    const auto model = solved (beam);
    const auto amplitude = std::sqrt (2 / (2700 * 0.2 * 0.01 * 1e-3));
    double worst = 0;

    for (int i = 0; i <= 500; ++i)
    {
        const auto x = -0.1 + 0.2 * i / 500;
        const auto shapes = shapesAt (model, x, 0);

        for (Eigen::Index k = 0; k < 40; ++k)
        {
            const auto exact = amplitude * std::sin (std::numbers::pi * static_cast<double> (k + 1) * (x + 0.1) / 0.2);
            worst = std::max (worst, std::abs (shapes[k] - exact));
        }
    }

    CHECK (worst < 3e-7 * amplitude);
}

TEST_CASE ("slopes are the derivatives of shapes", "[structure]")
{
    const auto beam = uniformBeam (EdgeCondition::simplySupported, EdgeCondition::simplySupported);
    const auto model = solved (beam, 10);
    const auto amplitude = std::sqrt (2 / (2700 * 0.2 * 0.01 * 1e-3));

    for (Eigen::Index k = 0; k < 10; ++k)
    {
        const auto waveNumber = std::numbers::pi * static_cast<double> (k + 1) / 0.2;
        const Eigen::ArrayXd exact =
            amplitude * waveNumber * (waveNumber * (model.surface.points.col (0).array() + 0.1)).cos();
        CHECK ((model.slopes.col (k).array() - exact).abs().maxCoeff() < 1e-6 * amplitude * waveNumber);
    }
}

TEST_CASE ("a clamped end neither moves nor turns, a guided one does not turn", "[structure]")
{
    const auto model = solved (uniformBeam (EdgeCondition::clamped, EdgeCondition::guided), 10);
    const auto last = model.points() - 1;
    CHECK (model.shapes.row (0).cwiseAbs().maxCoeff() < 1e-12 * model.shapes.cwiseAbs().maxCoeff());
    CHECK (model.slopes.row (0).cwiseAbs().maxCoeff() < 1e-12 * model.slopes.cwiseAbs().maxCoeff());
    CHECK (model.slopes.row (last).cwiseAbs().maxCoeff() < 1e-9 * model.slopes.cwiseAbs().maxCoeff());
    CHECK (model.shapes.row (last).cwiseAbs().minCoeff() > 0.5 * model.shapes.cwiseAbs().maxCoeff());
}

TEST_CASE ("a mirrored device has mirrored shapes and the same participations", "[structure]")
{
    checkMirror (beamWithCeramics(), 10);
    checkMirror (demonstrator(), 14);
}

TEST_CASE ("a shape is positive where it first exceeds a tenth of its largest amplitude", "[structure]")
{
    const auto model = solved (demonstrator(), 16);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const Eigen::VectorXd shape = model.shapes.col (k);
        const auto threshold = 0.1 * shape.cwiseAbs().maxCoeff();
        const auto* first = std::find_if (shape.data(), shape.data() + shape.size(),
                                          [threshold] (double value) { return std::abs (value) > threshold; });
        CHECK (*first > 0);
    }
}

TEST_CASE ("the same description gives the same model to the bit", "[structure]")
{
    const auto first = solved (demonstrator(), 16);
    const auto second = solved (demonstrator(), 16);
    CHECK (first.angularFrequencies == second.angularFrequencies);
    CHECK (first.shapes == second.shapes);
    CHECK (first.participation == second.participation);
}
