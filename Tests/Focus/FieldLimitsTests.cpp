#include "Support/SineBeam.h"
#include "Support/SinePlate.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FieldLimits.h>

#include <catch2/catch.hpp>

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
    CHECK (losses.rigid == 0);

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

TEST_CASE ("Motion as a rigid body is found where the device is free", "[focus][limits]")
{
    auto model = test::sineBeam (20, 8);
    model.rigidBodyModes = 2;
    auto design = designFocus (model, sincOf (0.02, 20), {}, DesignExtent::playable);
    auto& moment = design.moments.front();

    // A wanted field of which the flexible modes are said to have none: a plane, all of it rigid.
    moment.captured = 0;
    moment.target.modalVelocities.setZero();
    moment.target.field = (0.3 + 2 * model.surface.points.col (0).array()).matrix();
    CHECK (captureLosses (model, design, moment).rigid == Approx (1).epsilon (1e-9));
    CHECK_THAT (lossInWords (model, design, moment), Catch::Contains ("rigid body"));
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
