#include "PlateExamples.h"

#include <antinode_structure/SolvedPlate.h>

#include <algorithm>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** The relative deviations of each mode's integrals of the Laplacian over the ceramics from the reference, signs aside.
 */
std::vector<double> participationDeviations (const ModalModel& model, const nlohmann::json& integrals, double moment)
{
    std::vector<double> deviations;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        Eigen::RowVectorXd expected (model.actuators());

        for (Eigen::Index i = 0; i < expected.size(); ++i)
            expected[i] = integrals[static_cast<std::size_t> (i)][static_cast<std::size_t> (k)].get<double>();

        const Eigen::RowVectorXd actual = model.participation.row (k) / moment;
        deviations.push_back (std::min ((actual - expected).norm(), (actual + expected).norm()) / expected.norm());
    }

    std::sort (deviations.begin(), deviations.end());
    return deviations;
}

PlateDescription withOneCeramic (CeramicMounting mounting, CeramicWiring wiring, int polarity)
{
    auto plate = barePlate ("CFFF", 0.1, 0.08);
    plate.common.ceramics = { plateCeramic (0.02, 0.03, 0.03, 0.02) };
    plate.common.ceramics[0].mounting = mounting;
    plate.common.ceramics[0].wiring = wiring;
    plate.common.ceramics[0].polarity = polarity;
    return plate;
}
} // namespace

TEST_CASE ("Plate A with eight pairs of ceramics: 50 frequencies to 1e-4, participation to 1.5e-3 in the median",
           "[structure][plate]")
{
    const auto& reference = plateReferences()["patched_plate"];
    const auto plate = patchedPlate();
    const auto model = solved (plate, 50);
    CHECK (largestDeviation (model.angularFrequencies / (2 * std::numbers::pi), reference["frequency_Hz"]) < 1e-4);
    CHECK (model.frequencyErrors.maxCoeff() < 3e-4);

    const auto& ceramic = plate.common.ceramics[0];
    const auto force = ceramic.material.d31 * ceramic.material.youngsModulus / (1 - ceramic.material.poissonRatio);
    const auto moment = 2 * force * (plate.common.thickness + ceramic.thickness) / 2;
    const auto deviations = participationDeviations (model, reference["laplacian_integrals"], moment);
    CHECK (deviations[25] < 1.5e-3);
    CHECK (deviations.back() < 1e-2);
}

TEST_CASE ("Weights make the shapes of plate A orthonormal, and polynomials carry them between the points",
           "[structure][plate]")
{
    const auto model = solved (patchedPlate(), 50);
    CHECK ((gramMatrix (model) - Eigen::MatrixXd::Identity (50, 50)).cwiseAbs().maxCoeff() < 3e-5);
    const auto bare = 0.2 * 0.12 * 2.7, ceramics = 8 * 0.025 * 0.025 * 2 * 0.5e-3 * 7800;
    CHECK (model.surface.masses.sum() == Approx (bare + ceramics).epsilon (1e-12));
    CHECK (model.surface.areas.sum() == Approx (0.2 * 0.12).epsilon (1e-12));

    // The splines themselves on a coarse grid of other places; signs are settled on the model's own.
    const auto solution = solvePlateModes (patchedPlate(), 50);
    const PlateGrid between { gridAxis (Eigen::Vector2d (0, 0.2), Eigen::VectorXi::Constant (1, 7)),
                              gridAxis (Eigen::Vector2d (0, 0.12), Eigen::VectorXi::Constant (1, 5)) };
    const auto exact = shapesOn (between, solution.problem, solution.layout.unit, solution.coefficients);
    const auto amplitude =
        exact.rowwise()
            .norm()
            .maxCoeff(); // Places are chosen for a 3e-5th of a mode's; at ceramics its curvature jumps.

    for (Eigen::Index p = 0; p < exact.rows(); ++p)
    {
        const auto shapes = shapesAt (model, between.x.places[p % 7], between.y.places[p / 7]);
        CHECK ((shapes.cwiseAbs() - exact.row (p).cwiseAbs()).norm() < 2e-4 * amplitude);
    }

    CHECK (shapesAt (model, 0, 0.05).norm() < 1e-4 * shapesAt (model, 0.2, 0.05).norm());
}

TEST_CASE ("Wiring, polarity and mounting of a plate's ceramic", "[structure][plate]")
{
    const auto parallel = solved (withOneCeramic (CeramicMounting::bothSides, CeramicWiring::parallel, 1), 6);
    const auto series = solved (withOneCeramic (CeramicMounting::bothSides, CeramicWiring::series, 1), 6);
    const auto reversed = solved (withOneCeramic (CeramicMounting::bothSides, CeramicWiring::parallel, -1), 6);
    const auto oneSide = solved (withOneCeramic (CeramicMounting::oneSide, CeramicWiring::parallel, 1), 6);
    CHECK ((parallel.participation - 2 * series.participation).norm() < 1e-12 * parallel.participation.norm());
    CHECK ((parallel.participation + reversed.participation).norm() < 1e-12 * parallel.participation.norm());
    CHECK (oneSide.surface.masses.sum() < parallel.surface.masses.sum());
}

TEST_CASE ("A ceramic on one side of a like substrate bends about the middle of both", "[structure][plate]")
{
    // One plate of twice the thickness, glued from two halves: the neutral plane is the joint.
    auto glued = barePlate ("CFFF", 0.1, 0.08);
    auto ceramic = plateCeramic (0, 0, 0.1, 0.08, 1e-3);
    ceramic.material = { 200e9, 0.3, 8000, -1e-10, 0 };
    ceramic.mounting = CeramicMounting::oneSide;
    glued.common.ceramics = { ceramic };
    auto solid = barePlate ("CFFF", 0.1, 0.08);
    solid.common.thickness = 2e-3;
    const auto a = solved (glued, 8), b = solved (solid, 8);
    CHECK ((a.angularFrequencies - b.angularFrequencies).norm() < 3e-6 * b.angularFrequencies.norm());
}

TEST_CASE ("Two ceramics that touch are one", "[structure][plate]")
{
    auto halves = barePlate ("SSSS", 0.1, 0.08), whole = halves;
    halves.common.ceramics = { plateCeramic (0.02, 0.03, 0.015, 0.02), plateCeramic (0.035, 0.03, 0.015, 0.02) };
    whole.common.ceramics = { plateCeramic (0.02, 0.03, 0.03, 0.02) };
    const auto a = solved (halves, 10), b = solved (whole, 10);
    CHECK ((a.angularFrequencies - b.angularFrequencies).norm() < 1e-4 * b.angularFrequencies.norm());
    CHECK ((a.participation.rowwise().sum() - b.participation.col (0)).norm() < 1e-2 * b.participation.norm());
}

TEST_CASE ("Frequencies change smoothly as a gap between ceramics closes", "[structure][plate]")
{
    double before = 0;

    for (const auto gap : { 1e-3, 2e-4, 5e-5, 2.5e-5, 0.0 })
    {
        auto plate = barePlate ("CFFF", 0.2, 0.12);
        plate.common.ceramics = { plateCeramic (0.05, 0.02, 0.03, 0.03), plateCeramic (0.08 + gap, 0.02, 0.03, 0.03) };
        const auto model = solved (plate, 5);
        CAPTURE (gap, before);
        CHECK (model.frequencyErrors.maxCoeff() < 2e-4);

        if (before > 0)
        {
            CHECK (model.frequencyHz (0) > before * (1 - 1e-6));
            CHECK (model.frequencyHz (0) < before * 1.01);
        }

        before = model.frequencyHz (0);
    }
}

TEST_CASE ("A plate covered by one ceramic is a laminate", "[structure][plate]")
{
    // Navier's frequencies of the simply supported laminate: omega = (i^2 + j^2) pi^2 / L^2 sqrt (D / m).
    auto plate = barePlate ("SSSS", 0.1, 0.1);
    plate.common.ceramics = { plateCeramic (0, 0, 0.1, 0.1) };
    const auto& ceramic = plate.common.ceramics[0];
    const auto reduced = [] (double youngsModulus, double ratio) { return youngsModulus / (1 - ratio * ratio); };
    const auto distance = 0.75e-3;
    const auto stiffness = reduced (200e9, 0.3) * 1e-9 / 12
                           + reduced (ceramic.material.youngsModulus, ceramic.material.poissonRatio)
                                 * (std::pow (0.5e-3, 3) / 6 + 2 * distance * distance * 0.5e-3);
    const auto mass = 8.0 + 2 * 7800 * 0.5e-3;
    const auto omega = 2 * std::pow (std::numbers::pi / 0.1, 2) * std::sqrt (stiffness / mass);
    CHECK (solved (plate, 4).angularFrequencies[0] == Approx (omega).epsilon (1e-8));
}
