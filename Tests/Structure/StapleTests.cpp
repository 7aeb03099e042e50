#include "StructureExamples.h"

#include <antinode_structure/ElementChain.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::examples;

TEST_CASE ("a portal frame has the frequencies of its exact dynamic stiffness", "[structure]")
{
    // Exact dynamic stiffness of bending and stretching members, clamped feet, sharp corners, centre-line dimensions.
    constexpr std::array exact { 420.210504650357,   957.1604779566887,  1843.555996405965, 2303.0185444201384,
                                 3911.0181020973164, 5741.633090809472,  8070.459997638788, 10733.264735497565,
                                 13804.489119689912, 15926.076907146406, 17219.13253281279, 20912.720455569895,
                                 24862.85010064282,  27159.472583401242, 30832.12619248229, 30850.352435514156,
                                 36153.624933629115, 36574.94970054921 };
    auto staple = bareStaple();
    staple.common.maximumFrequency = 37000;
    const auto model = solved (staple);
    REQUIRE (model.modes() == static_cast<Eigen::Index> (exact.size()));
    CHECK (model.rigidBodyModes == 0);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const auto error = std::abs (model.frequencyHz (k) / exact[static_cast<std::size_t> (k)] - 1);
        CAPTURE (k, error);
        CHECK (error < 1e-8);
        CHECK (error <= model.frequencyErrors[k]);
        CHECK (model.frequencyErrors[k] < 1e-6);
    }
}

TEST_CASE ("the demonstrator has sixteen modes up to 31 kHz", "[structure]")
{
    // From 2 mm cubic elements, good to 2e-4 and rounded to 1 Hz.
    constexpr std::array<double, 16> known { 399,   912,   1706,  2224,  3793,  5628,  7965,  10771,
                                             13873, 14921, 17259, 21135, 25073, 27072, 30683, 30872 };
    auto staple = demonstrator();
    staple.common.maximumFrequency = 31000;
    const auto model = solved (staple);
    REQUIRE (model.modes() == 16);
    REQUIRE (model.actuators() == 8);

    for (Eigen::Index k = 0; k < 16; ++k)
        CHECK (model.frequencyHz (k) == Approx (known[static_cast<std::size_t> (k)]).margin (1));

    // The layout reaches every mode: each turns the ends of some ceramic by a tenth of its steepest slope or more.
    const auto moment = std::abs (momentPerVolt (staple.common, staple.width, staple.common.ceramics[0]));
    const Eigen::RowVectorXd turned = model.participation.cwiseAbs().rowwise().maxCoeff().transpose() / moment;
    CHECK (turned.cwiseQuotient (model.slopes.cwiseAbs().colwise().maxCoeff()).minCoeff() > 0.1);
}

TEST_CASE ("a staple's surface is its top alone", "[structure]")
{
    const auto staple = bareStaple();
    const auto model = solved (staple, 6);
    const auto topMass = 2700 * 0.15 * 0.01 * 0.002;

    CHECK (model.surface.kind == SurfaceKind::line);
    CHECK (model.surface.xMinimum == Approx (-0.075));
    CHECK (model.surface.xMaximum == Approx (0.075));
    CHECK (model.surface.masses.sum() == Approx (topMass).epsilon (1e-12));
    CHECK (model.surface.areas.sum() == Approx (0.15 * 0.01).epsilon (1e-12));
    CHECK (model.coversWholeBody);

    // The rest of each mode's unit of mass moves with the legs, and sideways.
    const Eigen::VectorXd share = gramMatrix (model).diagonal();
    CHECK (share.maxCoeff() < 1);
    CHECK (share[0] > 0.999);
    CHECK (share[2] < 0.5); // sway
}

TEST_CASE ("a staple on legs of next to no length is a clamped beam", "[structure]")
{
    auto staple = bareStaple();
    staple.topLength = 0.2;
    staple.legLength = 1e-7;
    const auto model = solved (staple, 4);
    const auto scale = stiffnessToMass (staple.common) / (staple.topLength * staple.topLength);

    CHECK (model.angularFrequencies[0] == Approx (4.730040744862704 * 4.730040744862704 * scale).epsilon (1e-5));
    CHECK (model.angularFrequencies[3] == Approx (14.137165491257464 * 14.137165491257464 * scale).epsilon (1e-5));
}
