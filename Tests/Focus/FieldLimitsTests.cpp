#include "Support/SineBeam.h"
#include "Support/SinePlate.h"

#include <antinode_documents/Inputs.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Projection.h>
#include <antinode_model/RigidMotion.h>
#include <antinode_structure/DeviceDescription.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace antinode;

namespace
{
FocusDescription sincOf (double width, int modes)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, width, 0.04, 1 } };
    focus.focusTime = 0.025;
    focus.modes.count = modes;
    return focus;
}

ModalModel beamWithEnds (const std::string& left, const std::string& right)
{
    return solveStructure (loadDevice ("beam", { "device.ends.left=" + left, "device.ends.right=" + right }));
}
} // namespace

TEST_CASE ("What modes leave out adds up to what is not captured", "[focus][limits]")
{
    auto model = test::sineBeam (20, 8);
    model.participation.row (4).setZero();
    const auto design = designFocus (model, sincOf (0.02, 8), {}, DesignExtent::playable);
    const auto& moment = design.moments.front();
    const auto losses = captureLosses (model, design, moment);
    const auto energy = moment.target.energy;
    CHECK (losses.blind == Approx (std::pow (moment.target.modalVelocities[4], 2) / energy));

    // Parseval: the shapes are sines, whose energies add up to that of the field.
    CHECK (moment.captured * moment.captured + losses.uncontrolled + losses.blind + losses.beyond
           == Approx (1).epsilon (1e-9));
    CHECK (losses.beyond == Approx (1 - moment.target.modalVelocities.squaredNorm() / energy).margin (1e-9));
}

TEST_CASE ("The sentence names what is missing most and the key to change", "[focus][limits]")
{
    auto model = test::sineBeam (20, 8);
    model.unknowns = 400;
    const auto limitOf = [&] (const FocusDescription& focus)
    {
        const auto design = designFocus (model, focus, {}, DesignExtent::playable);
        return lossInWords (model, design, design.moments.front());
    };
    CHECK_THAT (limitOf (sincOf (0.02, 6)),
                Catch::Contains ("the 6 controlled of 20") && Catch::Contains ("focus.modes.captured"));

    // All modes are controlled: asking for more of them would be no advice.
    CHECK_THAT (limitOf (sincOf (0.005, 20)), Catch::Contains ("all 20 of the device")
                                                  && Catch::Contains ("device.modes.count above 20")
                                                  && ! Catch::Contains ("focus.modes"));
    model.unknowns = 0;
    CHECK_THAT (limitOf (sincOf (0.005, 20)), ! Catch::Contains ("device.modes.count"));

    model.participation.row (2).setZero();
    CHECK_THAT (limitOf (sincOf (0.03, 12)), Catch::Contains ("Ceramics limit the field"));
}

TEST_CASE ("What is captured is of what a free device can have, and its rigid motion is said", "[focus][limits]")
{
    const auto model = beamWithEnds ("free", "free");
    REQUIRE (model.rigidBodyModes == 2);
    const Eigen::VectorXd plane = 0.3 + 2 * model.surface.points.col (0).array();
    const auto target = projectField (model, plane + 0.05 * model.shapes.col (2));
    CHECK (target.energy == Approx (0.05 * 0.05).epsilon (5e-3));
    CHECK (target.rigidEnergy == Approx (model.surface.masses.dot (plane.cwiseAbs2())).epsilon (1e-4));
    CHECK (restrictToModes (model, target, { 2 }).captured == Approx (1).epsilon (5e-3));

    auto focus = sincOf (0.03, 20);
    focus.targets[0].shape = TargetShape::bump;
    const auto held = designFocus (beamWithEnds ("clamped", "clamped"), focus, {}, DesignExtent::playable);
    const auto bump = designFocus (model, focus, {}, DesignExtent::playable);
    CHECK (bump.captured > 0.99);
    const auto isRigid = [] (const std::string& warning) { return warning.find ("rigid body") != std::string::npos; };
    CHECK (std::any_of (bump.warnings.begin(), bump.warnings.end(), isRigid));
    CHECK (std::none_of (held.warnings.begin(), held.warnings.end(), isRigid));
}

TEST_CASE ("Motions on soft springs are no modes that a focus controls", "[focus][limits]")
{
    const auto free = beamWithEnds ("free", "free");
    auto model = withRigidMotion (free);
    REQUIRE (model.modes() == free.modes() + 2);
    CHECK (suspensionModes (model) == 2);
    CHECK (suspensionModes (free) == 0);
    // 1 Hz, and driven by rounding: to control them would need thousands of volts.
    model.participation.topRows (2).setConstant (1e-6);
    ModeChoice upTo;
    upTo.maximumFrequency = 2000;
    const auto modes = selectModes (model, projectField (model, free.shapes.col (0)), upTo).modes;
    CHECK (modes.front() == 2);

    // Through three points every shape is a plane: that says nothing.
    auto sparse = model;
    const std::vector<Eigen::Index> rows { 5, 20, 40 };
    sparse.shapes = model.shapes (rows, Eigen::all).eval();
    sparse.surface.points = model.surface.points (rows, Eigen::all).eval();
    sparse.surface.masses = model.surface.masses (rows).eval();
    CHECK (suspensionModes (sparse) == 0);

    // A clamped beam's first shape is nearly a plane, and stays a mode.
    CHECK (suspensionModes (beamWithEnds ("clamped", "free")) == 0);
}

TEST_CASE ("A focus that comes too early is reported with its error", "[focus][limits]")
{
    const auto model = test::sineBeam (30, 3);
    auto focus = sincOf (0.025, 8);
    CHECK (designFocus (model, focus, {}).warnings.empty());
    focus.modes.count = 2;
    focus.focusTime = 0.0025;
    focus.allocation.voltageLimit = 1e4;
    const auto warnings = designFocus (model, focus, {}).warnings;
    REQUIRE_FALSE (warnings.empty());
    CHECK_THAT (warnings.back(),
                Catch::Contains ("Time limits the field: 2.5 ms") && Catch::Contains ("focus.focus_time_ms"));
}
