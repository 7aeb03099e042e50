#include "Support/SinePlate.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_session/DesignWorker.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
WideModel wideModel()
{
    const test::SinePlate plate;
    return withModesBeyond (plate.model (24), plate.model (60));
}

DesignRequest requestOf (const std::shared_ptr<const ModalModel>& model)
{
    DesignRequest request;
    request.model = model;
    auto& target = request.focus.targets.emplace_back();
    target.shape = TargetShape::bump;
    target.x = 0.11;
    target.y = 0.07;
    target.width = 0.05;
    target.peakVelocity = 0.01;
    request.focus.focusTime = 0.02;
    request.focus.modes.count = 8;
    request.focus.allocation.method = AllocationMethod::leastVoltage;
    request.focus.allocation.timesBound = upToLimits;
    request.playback = { Reconstruction::bandLimited, 96000 };
    request.widen = [] { return wideModel(); };
    return request;
}
} // namespace

TEST_CASE ("A voltage limit that moves leaves the guards of a bank and is kept, a new focus time looks for others",
           "[graph][sampled]")
{
    const auto model = std::make_shared<const ModalModel> (test::SinePlate().model (24));
    PlaceDesigner designer;
    auto request = requestOf (model);
    designer.begin (request);
    const auto first = designer.design (request, request.focus);
    REQUIRE (first.spillOver); // It looked for modes to guard.

    request.focus.allocation.voltageLimit = 0.9 * peakVoltage (first);
    designer.begin (request);
    const auto limited = designer.design (request, request.focus);
    CHECK_FALSE (limited.spillOver);
    CHECK (peakVoltage (limited) <= *request.focus.allocation.voltageLimit * (1 + 1e-12));

    // The same samples as of a design that begins with nothing but these guards.
    const auto guarded = firstModes (wideModel().model, model->modes() + first.spillOver->guardedBeyond);
    const auto alone = designGuarding (guarded, model->modes(), request.focus, request.playback);
    CHECK (limited.program.samples.value().values == alone.program.samples.value().values);

    request.focus.focusTime = 0.025;
    designer.begin (request);
    CHECK (designer.design (request, request.focus).spillOver);
}
