#include "Support/HeldPlate.h"
#include "Support/SineBeam.h"
#include "Support/SinePlate.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_fingers/LoadedModel.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
/** The largest difference of any velocity from that of the plate in M, C and K, relative to the largest. */
double worstDifference (const ModalModel& bare, const std::vector<Finger>& fingers)
{
    const Playback playback { Reconstruction::zeroOrderHold, 48000 };
    const auto loaded = loadedModel (bare, fingers);
    CHECK_NOTHROW (validate (loaded));
    PlateModel plate (loaded, playback, loaded.shapes);
    test::HeldPlate independent (bare, fingers, 1 / playback.sampleRate);
    const auto actuators = bare.actuators();
    Eigen::VectorXd voltages = Eigen::VectorXd::Zero (actuators);
    Eigen::MatrixXd velocities (loaded.points(), 1);
    double worst = 0, largest = 0;

    for (int n = 0; n < 400; ++n)
    {
        for (Eigen::Index i = 0; i < actuators; ++i)
            voltages[i] = n < 200 ? 30 * std::sin (0.001 * (n + 3.0) * n * (1.0 + 0.3 * static_cast<double> (i))) : 0;

        const Eigen::MatrixXd before = velocities; // of the time before this sample acts
        plate.process (voltages, velocities);
        const Eigen::VectorXd wanted = bare.shapes * independent.state.tail (bare.modes());
        worst = std::max (worst, (velocities - wanted).cwiseAbs().maxCoeff());
        largest = std::max (largest, wanted.cwiseAbs().maxCoeff());
        independent.after (bare.participation * voltages);
    }

    return worst / largest;
}

std::vector<Finger> fingersAlong (int count)
{
    const char* const kinds[] { "medium", "light", "firm", "medium", "light" };
    std::vector<Finger> fingers;

    for (int i = 0; i < count; ++i)
        fingers.push_back (builtInFinger (kinds[i], -0.071 + 0.033 * i, 0));

    return fingers;
}
} // namespace

TEST_CASE ("One to five fingers on a beam: the loaded modes move as M, C and K with the fingers do", "[fingers]")
{
    const auto bare = test::sineBeam (20, 5);

    for (int count = 1; count <= 5; ++count)
        CHECK (worstDifference (bare, fingersAlong (count)) < 1e-9);
}

TEST_CASE ("Fingers of which parts are missing, at a point, at an edge, or so strong that a motion does not oscillate",
           "[fingers]")
{
    const auto bare = test::sineBeam (12, 4);
    auto finger = builtInFinger ("medium", 0.021, 0);

    SECTION ("a mass alone")
    {
        finger.damping = finger.stiffness = 0;
    }

    SECTION ("a damper alone")
    {
        finger.mass = finger.stiffness = 0;
    }

    SECTION ("a spring alone, at a point")
    {
        finger.mass = finger.damping = finger.radius = 0;
    }

    SECTION ("at the edge")
    {
        finger.x = 0.0985;
    }

    SECTION ("in the middle, where every second mode has a node")
    {
        finger.x = 0;
        finger.radius = 0;
    }

    SECTION ("a damper so strong that the beam is held")
    {
        finger.damping = 300;
    }

    CHECK (worstDifference (bare, { finger }) < 1e-9);
}

TEST_CASE ("A plate whose modes come in pairs of one frequency, under two fingers", "[fingers]")
{
    test::SinePlate square;
    square.lengthX = square.lengthY = 0.15;
    const auto bare = square.model (16);
    CHECK (worstDifference (bare, { builtInFinger ("medium", 0.04, 0.06), builtInFinger ("firm", 0.1, 0.11) }) < 1e-9);
    CHECK (worstDifference (bare, { builtInFinger ("light", 0.05, 0.05), builtInFinger ("light", 0.1, 0.1) }) < 1e-9);
}

TEST_CASE ("No finger changes nothing, and fingers that cannot be are refused in a sentence", "[fingers]")
{
    const auto bare = test::sineBeam (6, 2);
    CHECK (loadedModel (bare, {}).shapes == bare.shapes);
    CHECK_THROWS_WITH (loadedModel (bare, { builtInFinger ("medium", 0.2, 0) }),
                       Catch::Contains ("finger 1 x") && Catch::Contains ("allowed: -100 to 100 mm"));
    CHECK_THROWS_WITH (loadedModel (bare, { builtInFinger ("medium", 0, 0), builtInFinger ("medium", 0.004, 0) }),
                       Catch::Contains ("finger 2") && Catch::Contains ("allowed: at least 10 mm"));
    CHECK_THROWS_WITH (builtInFinger ("thumb", 0, 0), Catch::Contains ("light, medium, firm"));
    CHECK_THROWS_AS (loadedModel (loadedModel (bare, fingersAlong (1)), fingersAlong (1)), InputError);
}
