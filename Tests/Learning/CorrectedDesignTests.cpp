#include "LearningBench.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>
#include <antinode_learning/LearntDesign.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Velocities of all modes of a model at the focus. */
Eigen::VectorXd velocitiesOf (const ModalModel& model, const FocusDesign& design)
{
    return modalVelocities (model, predictStates (model, design.program, design.program.focusTime));
}

/** A focus on the nominal beam, and what it lacks on the one that is there. */
struct Missed
{
    Bench bench { 0.002, 3 };
    FocusDesign design = designFocus (bench.nominal.model, sincFocus(), { Reconstruction::bandLimited, benchRate },
                                      DesignExtent::compared);
    Eigen::VectorXd missing = velocitiesOf (bench.nominal.model, design) - velocitiesOf (bench.truth, design);
};
} // namespace

TEST_CASE ("A correction adds what a design lacks on another device, for little voltage", "[learning]")
{
    const Missed missed;
    const auto wanted = velocitiesOf (missed.bench.nominal.model, missed.design);
    REQUIRE (missed.missing.norm() > 0.01 * wanted.norm());
    const auto corrected = correctedDesign (missed.design, missed.bench.truth, missed.missing);
    REQUIRE (corrected);
    CHECK ((velocitiesOf (missed.bench.truth, *corrected) - wanted).norm() < 1e-6 * wanted.norm());
    CHECK (peakVoltage (*corrected) < 1.2 * peakVoltage (missed.design));

    // What was played before is played still.
    const auto before = missed.design.program.allocation.cols();
    CHECK (corrected->program.allocation.leftCols (before) == missed.design.program.allocation);
}

TEST_CASE ("Where a design lacks nothing, nothing is added", "[learning]")
{
    const Missed missed;
    const auto corrected =
        correctedDesign (missed.design, missed.bench.truth, Eigen::VectorXd::Zero (missed.missing.size()));
    REQUIRE (corrected);
    const auto added = corrected->program.allocation.cols() - missed.design.program.allocation.cols();
    CHECK (corrected->program.allocation.rightCols (added).isZero (0));
    CHECK (peakVoltage (*corrected) == peakVoltage (missed.design));
}

TEST_CASE ("Designs that leave no room below their limits are not corrected, nor are trains", "[learning]")
{
    Missed missed;

    SECTION ("limit")
    {
        missed.design.certificate.peakRatio = 1;
        CHECK_FALSE (correctedDesign (missed.design, missed.bench.truth, missed.missing));
    }

    SECTION ("train")
    {
        missed.design.moments.push_back (missed.design.moments.front());
        CHECK_FALSE (correctedDesign (missed.design, missed.bench.truth, missed.missing));
    }
}

TEST_CASE ("After its first designs a focus is corrected, and has drives for one correction only", "[learning]")
{
    const Bench bench (0.005, 2);
    auto settings = threePasses();
    settings.passes = 4;
    const auto learnt = learnFocus (bench.nominal, sincFocus(), bench.sensors(),
                                    sameSpread (allModes, 0.005, 0.1, 0.05), std::cref (bench), settings);
    REQUIRE (learnt.refusal.empty());
    const auto second = learnt.passes[1].design.program.oscillations.size(),
               third = learnt.passes[2].design.program.oscillations.size();
    CHECK (third > second);
    CHECK (learnt.design.program.oscillations.size() == third);
    CHECK (learnt.design.program.allocation.leftCols (static_cast<Eigen::Index> (second))
           == learnt.passes[1].design.program.allocation);
}
