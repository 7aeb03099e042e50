#include "Support/SineBeam.h"
#include "Support/SinePlate.h"

#include <antinode_allocation/BoundedWaveform.h>
#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/PlacedDesigns.h>
#include <antinode_focus/SpillOver.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

using namespace antinode;

namespace
{
constexpr Playback playback { Reconstruction::bandLimited, 192000 };

/** A focus that takes all modes of a beam of few: what its voltages move of others is not small. */
FocusDescription wideFocus (AllocationMethod method, double limit)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::bump, 0.02, 0, 0.03, 0.04, 1 } };
    focus.focusTime = 0.008;
    focus.modes.count = 12;
    focus.allocation.method = method;
    focus.allocation.timesBound = upToLimits;
    focus.allocation.voltageLimit = limit;
    return focus;
}

WideModel wideBeam()
{
    return withModesBeyond (test::sineBeam (12, 8), test::sineBeam (24, 8));
}

/** What the plate model makes of a design on all modes: RMS in those beyond / RMS of all, of orthonormal shapes. */
double playedShare (const WideModel& wide, const FocusDesign& design)
{
    RenderSettings settings;
    settings.playback = playback;
    settings.duration = 0.01;
    settings.probeShapes.resize (0, wide.model.modes());
    const auto velocities = renderOffline (wide.model, design.program, settings).focusVelocities;
    return velocities.tail (wide.model.modes() - wide.known).norm() / velocities.norm();
}
} // namespace

TEST_CASE ("A wide model has the known modes to the bit and the others of the second solution, on the same points",
           "[spillOver]")
{
    const auto beam = wideBeam();
    const auto known = test::sineBeam (12, 8), whole = test::sineBeam (24, 8);
    CHECK (beam.known == 12);
    CHECK (beam.model.shapes.leftCols (12) == known.shapes);
    CHECK (beam.model.participation == whole.participation);
    CHECK (beam.model.shapes.isApprox (whole.shapes, 1e-12));
    CHECK (firstModes (beam.model, 12).participation == known.participation);

    // A plate whose second solution has other points: the shapes are those of the closed form there.
    test::SinePlate plate;
    const auto coarse = plate.model (12), same = plate.model (30);
    plate.segments = 5;
    plate.placesPerSegment = 14;
    const auto wide = withModesBeyond (coarse, plate.model (30));
    CHECK (wide.model.points() == coarse.points());
    CHECK ((wide.model.shapes - same.shapes).cwiseAbs().maxCoeff() < 1e-6 * same.shapes.cwiseAbs().maxCoeff());
    CHECK_THROWS_AS (withModesBeyond (known, known), InputError);
    CHECK_THROWS_AS (withModesBeyond (known, test::sineBeam (30, 7)), InputError);
}

TEST_CASE ("Spill-over is what the plate model plays in modes beyond, and guards bring it below 0.1 %", "[spillOver]")
{
    const auto wide = wideBeam();

    for (const auto method : { AllocationMethod::exact, AllocationMethod::leastVoltage })
    {
        const auto focus = wideFocus (method, 150);
        const auto first = designFocus (firstModes (wide.model, 12), focus, playback, DesignExtent::compared);
        const auto design = designWithin (wide, focus, playback, DesignExtent::compared);
        REQUIRE (design.spillOver);

        // The closed form knows nothing of the converter, which rounds what begins abruptly: some per cent of the
        // share.
        CHECK (design.spillOver->unguardedShare == Approx (playedShare (wide, first)).epsilon (0.05));
        CHECK (design.spillOver->share == Approx (playedShare (wide, design)).epsilon (0.15));
        CHECK (playedShare (wide, design) <= allowedSpillOver);
        CHECK (design.controlledModes == first.controlledModes);
    }
}

TEST_CASE ("A design that leaves little in modes beyond stays as it is, to the bit", "[spillOver]")
{
    const auto wide = withModesBeyond (test::sineBeam (20, 8), test::sineBeam (50, 8));
    auto focus = wideFocus (AllocationMethod::exact, 150);
    focus.modes.count = 6;
    const auto alone = designFocus (firstModes (wide.model, 20), focus, playback, DesignExtent::compared);
    const auto within = designWithin (wide, focus, playback, DesignExtent::compared);
    CHECK (within.program.allocation == alone.program.allocation);
    CHECK (within.spillOver->share < allowedSpillOver);
    CHECK (within.spillOver->guardedBeyond == 0);
    CHECK (within.spillOver->playedFrequency > widePlay * within.spillOver->designedFrequency);
}

TEST_CASE ("Guards beyond are not taken where known modes lose more than they gain", "[spillOver]")
{
    // Four ceramics drive six modes of twelve: what guards take of the drives no longer keeps the other six at rest.
    const auto wide = withModesBeyond (test::sineBeam (12, 4), test::sineBeam (24, 4));
    auto focus = wideFocus (AllocationMethod::exact, 150);
    focus.focusTime = 0.004;
    focus.modes.count = 6;
    const auto first = designFocus (firstModes (wide.model, 12), focus, playback, DesignExtent::compared);
    const auto guarded = designGuarding (firstModes (wide.model, 14), 12, focus, playback);
    REQUIRE (spillOverShare (wide, guarded) < 0.3 * spillOverShare (wide, first));
    REQUIRE (largestFieldError (wide.model, guarded) > 2 * largestFieldError (wide.model, first));

    const auto design = designWithin (wide, focus, playback, DesignExtent::compared);
    CHECK (design.spillOver->guardedBeyond == 0);
    CHECK (largestFieldError (wide.model, design) == largestFieldError (wide.model, first));
    CHECK (std::any_of (design.warnings.begin(), design.warnings.end(),
                        [] (const auto& warning) { return warning.find ("beyond the 12") != std::string::npos; }));

    // Many places of a map choose as one design does.
    REQUIRE (PlacedDesigns::suits (wide, focus));
    const auto placed = PlacedDesigns (wide, focus, playback).design (design.target);
    REQUIRE (placed);
    CHECK (spillOverShare (wide, placed->velocities) == Approx (design.spillOver->share).epsilon (0.05));
}

TEST_CASE ("Samples of less cost take more of the energy: without limits they are rows over costs", "[spillOver]")
{
    BoundedWaveformProblem problem;
    problem.weights = Eigen::RowVectorXd::LinSpaced (50, 0, 9).array().cos().matrix();
    problem.participation = Eigen::MatrixXd::Constant (1, 1, 2.0);
    problem.wanted = Eigen::VectorXd::Constant (1, 3.0);
    problem.compliance = Eigen::VectorXd::Zero (1);
    problem.limits = Eigen::VectorXd::Constant (1, 100.0);
    problem.costs = Eigen::VectorXd::LinSpaced (50, 0.5, 3);
    const Eigen::RowVectorXd weights = problem.weights.row (0);
    const Eigen::RowVectorXd pulls = weights.cwiseQuotient (problem.costs.transpose());
    const Eigen::RowVectorXd wanted = 3 / (2 * pulls.dot (weights)) * pulls;
    const auto found = solveBoundedWaveform (problem);
    CHECK ((found.samples - wanted).cwiseAbs().maxCoeff() < 1e-12 * wanted.cwiseAbs().maxCoeff());
    CHECK (found.objective == Approx (0.5 * wanted.cwiseAbs2().dot (problem.costs.transpose())));

    // At a limit that binds, no sample goes beyond it, whatever it costs.
    problem.limits[0] = 0.9 * wanted.cwiseAbs().maxCoeff();
    const auto limited = solveBoundedWaveform (problem);
    CHECK (limited.isMet);
    CHECK (limited.samples.cwiseAbs().maxCoeff() == Approx (problem.limits[0]).epsilon (1e-12));
    CHECK (limited.objective == Approx (limited.bound).epsilon (1e-9));
}

TEST_CASE ("With least voltage the warning of spill-over advises a larger multiple of the bound", "[spillOver]")
{
    // Guards without weight, so near the bound that no samples can be left out: sharp edges stay.
    const auto wide = withModesBeyond (test::sineBeam (12, 8), test::sineBeam (20, 8));
    auto focus = wideFocus (AllocationMethod::leastVoltage, 150);
    focus.allocation.guardWeight = 0;
    focus.allocation.timesBound = 1.02;
    const auto warnings = designWithin (wide, focus, playback, DesignExtent::playable).warnings;
    const auto advises = [&] (const std::string& words)
    {
        return std::any_of (warnings.begin(), warnings.end(),
                            [&] (const std::string& one) { return one.find (words) != std::string::npos; });
    };
    CHECK (advises ("a larger 'times_bound' or a longer focus time"));
    CHECK_FALSE (advises ("voltage limit"));
}
