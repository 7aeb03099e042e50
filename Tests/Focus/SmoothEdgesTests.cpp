#include "Support/SineBeam.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_focus/FreeSamples.h>
#include <antinode_focus/LimitUse.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
FocusDescription slowFocus (double timesBound = usualTimesBound)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.015;
    focus.modes.count = 6;
    focus.allocation.method = AllocationMethod::leastVoltage;
    focus.allocation.timesBound = timesBound;
    return focus;
}

ModalModel withSlewLimit (ModalModel model, double limit)
{
    for (auto& ceramic : model.ceramics)
        ceramic.slewLimit = limit;

    return model;
}

/** The steepest slope of what is played, V/s: by differences of a kernel that is 4 times as fine as the design's own.
 */
double steepestPlayed (const ModalModel& model, const FocusDesign& design)
{
    RenderSettings settings;
    settings.playback = design.playback;
    settings.duration = 0.025;
    settings.probeShapes.resize (0, model.modes());
    const auto render = renderOffline (model, design.program, settings);
    SampledVoltages played { design.playback, 0, render.voltages };
    const auto slopes = slopesOf (played);
    return slopes.values.cwiseAbs().maxCoeff();
}
} // namespace

TEST_CASE ("A low-pass of samples and its adjoint belong together, and make a jump an edge", "[freeWaveform][slew]")
{
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random (3, 40), b = Eigen::MatrixXd::Random (3, 40);
    CHECK (withSmoothEdges (a, 7).cwiseProduct (b).sum() == Approx (a.cwiseProduct (smoothEdgesAdjoint (b, 7)).sum()));
    CHECK (withSmoothEdges (a, 0) == a);
    const Eigen::MatrixXd edge = withSmoothEdges (Eigen::MatrixXd::Ones (1, 100), 4);
    CHECK (edge (0, 3) == Approx (1 - std::exp (-1.0)));
    CHECK (edge (0, 99) == Approx (1));
}

TEST_CASE ("Slopes of samples are those of what they stand for", "[freeWaveform][slew]")
{
    SampledVoltages voltages { { Reconstruction::bandLimited, 48000 }, 0.001, Eigen::MatrixXd (1, 2000) };

    for (Eigen::Index n = 0; n < 2000; ++n)
        voltages.values (0, n) = 3 * std::sin (2 * 3.14159265358979 * 1000 * static_cast<double> (n) / 48000)
                                 * std::pow (std::sin (3.14159265358979 * static_cast<double> (n) / 2000), 2);

    const auto slopes = slopesOf (voltages);
    CHECK (slopes.values.maxCoeff() == Approx (3 * 2 * 3.14159265358979 * 1000).epsilon (0.003));
    CHECK (slopes.last - slopes.first == Approx (2031.0 / 48000).epsilon (0.01));
}

TEST_CASE ("Free samples keep a slew limit from their first to their last, and every mode its velocity",
           "[freeWaveform][slew]")
{
    const auto model = test::sineBeam (20, 8);

    for (const auto timesBound : { upToLimits, usualTimesBound })
        for (const auto rate : { 48000.0, 96000.0 })
        {
            const Playback playback { Reconstruction::bandLimited, rate };
            const auto free = designFocus (model, slowFocus (timesBound), playback, DesignExtent::playable);
            const auto before = slopesOf (*free.program.samples).values.cwiseAbs().maxCoeff();

            for (const auto share : { 0.7, 0.4 })
            {
                CAPTURE (timesBound, rate, share);
                const auto slow = withSlewLimit (model, share * before);
                const auto design = designFocus (slow, slowFocus (timesBound), playback);
                CHECK (steepestPlayed (slow, design) <= share * before);
                CHECK (steepestPlayed (slow, design) > 0.5 * share * before);

                // The least energy is not the least voltage: slower edges may have less.
                if (timesBound < upToLimits)
                    CHECK (peakVoltage (design) >= design.lowerBoundVoltage);

                RenderSettings settings;
                settings.playback = playback;
                settings.duration = 0.02;
                settings.probeShapes.resize (0, model.modes());
                const auto reached = renderOffline (model, design.program, settings).focusVelocities;
                const auto largest = design.target.modalVelocities.cwiseAbs().maxCoeff();

                for (const auto mode : design.controlledModes)
                    CHECK (reached[mode] == Approx (design.target.modalVelocities[mode]).margin (1e-9 * largest));

                const auto uses = limitUses (slow, design.description.allocation, design.program);
                REQUIRE (uses.slew);
                CHECK (uses.slew->share() <= 1);
            }
        }
}

TEST_CASE ("A slew limit that samples cannot keep is refused with what it allows", "[freeWaveform][slew]")
{
    const auto model = withSlewLimit (test::sineBeam (20, 8), 10);
    const Playback playback { Reconstruction::bandLimited, 48000 };
    CHECK_THROWS_WITH (designFocus (model, slowFocus(), playback),
                       Catch::Contains ("slew") && Catch::Contains ("this limit allows"));
}
