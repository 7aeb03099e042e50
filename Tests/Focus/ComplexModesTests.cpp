#include "Support/ErrorText.h"
#include "Support/LeastPeak.h"
#include "Support/ViscousChain.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/ModeDrives.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/Tolerance.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double damper = 10, strongDamper = 40; // N s/m: collinearities from 0.82 and from 0.30 on

FocusDescription chainFocus()
{
    FocusDescription focus;
    focus.targets = { { TargetShape::gaussian, 0.03, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.025;
    focus.modes.count = 8;
    return focus;
}

Eigen::VectorXd velocitiesOf (const ViscousChain& chain, const FocusDesign& design, double time)
{
    return chainMotion (chain, design.program, time).tail (chain.size());
}

/** What the chain itself does at the focus, against the wanted field. */
double fieldError (const ViscousChain& chain, const ModalModel& model, const FocusDesign& design)
{
    return scoreField (model.surface, velocitiesOf (chain, design, design.program.focusTime), design.truncatedField)
        .fieldError;
}
} // namespace

TEST_CASE ("Complex modes move as the equations of motion say, to 1e-9", "[focus][complex]")
{
    const auto chain = viscousChain (8, 5, strongDamper);
    const auto model = complexModel (chain);
    CHECK_NOTHROW (validate (model));
    CHECK (phaseCollinearities (model).minCoeff() < 0.6);
    auto description = chainFocus();
    description.transients.brakeDuration = 0.01;
    const auto design = designFocus (model, description, {});
    const ProgramMotion motion (model, design.program);

    for (const auto time : { 0.017, 0.024, 0.025, 0.0254, 0.031 })
    {
        const auto wanted = chainMotion (chain, design.program, time);
        const auto states = predictStates (model, design.program, time);
        const Eigen::VectorXd velocity = model.shapes * modalVelocities (model, states);
        const Eigen::VectorXd displacement = model.shapes * modalDisplacements (model, states);
        INFO (time);
        CHECK ((velocity - wanted.tail (8)).norm() / wanted.tail (8).norm() <= 1e-9);
        CHECK ((displacement - wanted.head (8)).norm() / wanted.head (8).norm() <= 1e-9);
        CHECK ((motion.statesAt (time) - states).norm() <= 1e-9 * states.norm());
    }
}

TEST_CASE ("Exact rows bring complex modes to the wanted field as they bring real ones", "[focus][complex]")
{
    for (const auto used : { 0.0, damper, strongDamper })
    {
        const auto chain = viscousChain (8, 5, used);
        const auto model = complexModel (chain);
        const auto design = designFocus (model, chainFocus(), {});
        INFO ("damper " << used);
        CHECK (fieldError (chain, model, design) < 1e-5);
        CHECK (design.captured == Approx (1));
    }
}

TEST_CASE ("Methods that are no longer offered have exact rows where samples would need real modes", "[focus][complex]")
{
    const auto chain = viscousChain (8, 5, strongDamper);
    const auto model = complexModel (chain);
    const auto exact = designFocus (model, chainFocus(), {});

    for (const auto& retired : retiredMethods)
    {
        if (retired.method == AllocationMethod::paper)
            continue; // Never took complex modes.

        auto focus = chainFocus();
        focus.allocation = withRetired (focus.allocation, retired);
        const auto design = designFocus (model, focus, {});
        CHECK (design.program.allocation == exact.program.allocation);
        REQUIRE_FALSE (design.warnings.empty());
        CHECK_THAT (design.warnings.front(),
                    Catch::Contains ("'" + std::string (retired.word) + "'") && Catch::Contains ("'exact' is used"));
    }
}

TEST_CASE ("Modes that are left alone and imaginary parts of shapes are guarded", "[focus][complex]")
{
    auto description = chainFocus();
    description.targets.front() = { TargetShape::gaussian, 0.05, 0, 0.04, 0.02, 1 };

    for (const auto used : { 0.0, damper })
    {
        const auto chain = viscousChain (12, 6, used);
        const auto model = complexModel (chain);
        const auto design = designFocus (model, description, {});
        INFO ("damper " << used);
        CHECK (fieldError (chain, model, design) < 0.0015);
    }
}

TEST_CASE ("A limit is kept with complex modes, and the field is as exact", "[focus][complex]")
{
    const auto chain = viscousChain (8, 5, strongDamper);
    const auto model = complexModel (chain);
    auto description = chainFocus();
    const auto free = designFocus (model, description, {});
    const auto least = leastPeakVoltage (model, description);
    REQUIRE (least < 0.97 * peakVoltage (free));
    description.allocation.voltageLimit = 0.5 * (peakVoltage (free) + least);
    const auto design = designFocus (model, description, {});
    CHECK (design.certificate.status == AllocationStatus::optimal);
    CHECK (design.certificate.gap < 1e-6);
    CHECK (peakVoltage (design) <= *description.allocation.voltageLimit);
    CHECK (fieldError (chain, model, design) < 1e-5);
}

TEST_CASE ("A brake brings a chain with complex modes to rest", "[focus][complex][brake]")
{
    const auto chain = viscousChain (8, 5, strongDamper);
    const auto model = complexModel (chain);
    auto description = chainFocus();
    description.transients.brakeDuration = 0.006;
    const auto design = designFocus (model, description, {});
    const auto focus = velocitiesOf (chain, design, 0.025).cwiseAbs().maxCoeff();
    const auto rest = velocitiesOf (chain, design, 0.025 + *design.restTime).cwiseAbs().maxCoeff();
    description.transients.brakeDuration.reset();
    const auto unbraked = designFocus (model, description, {});
    const auto free = velocitiesOf (chain, unbraked, 0.025 + *design.restTime).cwiseAbs().maxCoeff();
    CHECK (rest < 1e-4 * focus);
    CHECK (free > 20 * rest);
}

TEST_CASE ("A train of foci, the samples of a render and its field are right with complex modes", "[focus][complex]")
{
    const auto chain = viscousChain (8, 5, strongDamper);
    const auto model = complexModel (chain);

    for (const auto reconstruction : { Reconstruction::bandLimited, Reconstruction::zeroOrderHold })
    {
        auto description = chainFocus();
        description.targets.push_back (description.targets.front());
        description.targets.back().time = 0.032;
        description.targets.back().x = 0.05;
        const Playback playback { reconstruction, 96000 };
        const auto design = designFocus (model, description, playback);
        RenderSettings settings;
        settings.playback = playback;
        settings.duration = 0.04;
        settings.probeShapes = model.shapes;
        const auto render = renderOffline (model, design.program, settings);
        REQUIRE (design.moments.size() == 2);

        for (const auto& moment : design.moments)
        {
            const auto sample =
                render.focusSample + std::llround ((moment.time - design.program.focusTime) * playback.sampleRate);
            const auto score = scoreField (model.surface, render.probeVelocities.col (sample), moment.truncatedField);
            CHECK (score.fieldError < 1e-4);
            CHECK (score.vScore > 0.9999);
        }
    }
}

TEST_CASE ("What takes real modes only refuses complex ones in a sentence", "[focus][complex]")
{
    const auto model = complexModel (viscousChain (8, 5, strongDamper));
    const auto refusal = [&] (const auto& change)
    {
        auto description = chainFocus();
        change (description);
        return errorText ([&] { designFocus (model, description, { Reconstruction::bandLimited, 96000 }); });
    };
    CHECK (refusal ([] (auto& f) { f.allocation.method = AllocationMethod::paper; })
           == "device 'chain': has complex modes, but designs by the method 'paper' take real modes only; use a "
              "device with real modes, and no fingers that the design knows");
    CHECK_THAT (refusal ([] (auto& f) { f.allocation.method = AllocationMethod::leastVoltage; }),
                Catch::Contains ("'least_voltage'"));
    CHECK_THAT (refusal ([] (auto& f) { f.allocation.robust = Robustness {}; }), Catch::Contains ("robust designs"));
    CHECK_THAT (refusal ([] (auto& f) { f.allocation.isUndisplaced = true; }), Catch::Contains ("displacement 'zero'"));
    const auto design = designFocus (model, chainFocus(), {});
    CHECK_THAT (errorText ([&] { evaluateTolerance (model, design, {}, {}); }), Catch::Contains ("tolerance studies"));
}
