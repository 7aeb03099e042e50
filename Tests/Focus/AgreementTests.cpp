#include "Support/SineBeam.h"

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

// The closed forms of focus and the sampled plate model of engine know nothing of each other. Drives that are released
// after the focus have no step and no corner there, only their curvature jumps: played band-limited they agree with the
// continuous closed form to third order in the sample period T, down to the accuracy of the interpolation (2e-6 up to
// 0.75 of the Nyquist frequency). A drive that were cut would lose kappa T psi, first order. Held samples have an exact
// sum of their own. Docs/Theory.md, section 6.3.

using namespace antinode;

namespace
{
const std::vector<double> rates { 48000, 96000, 192000, 384000, 1300000 };

FocusDescription focusFor (std::optional<double> brake)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::bump, -0.01, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.02;
    focus.modes.maximumFrequency = 8000;
    focus.transients.brake = brake;
    return focus;
}

/** The largest error of the controlled modes' rendered velocities, relative to the largest of them. */
double renderedError (const ModalModel& model, const FocusDesign& design, Playback playback)
{
    RenderSettings settings;
    settings.playback = playback;
    settings.duration = design.program.focusTime + 0.002;
    settings.probeShapes.resize (0, model.modes());
    const auto render = renderOffline (model, design.program, settings);
    double worst = 0, largest = 0;

    for (const auto mode : design.controlledModes)
    {
        worst = std::max (worst, std::abs (render.focusVelocities[mode] - design.target.modalVelocities[mode]));
        largest = std::max (largest, std::abs (design.target.modalVelocities[mode]));
    }

    return worst / largest;
}
} // namespace

TEST_CASE ("Band-limited: the plate model agrees with the closed form at 48 kHz to 1.3 MHz to third order", "[focus]")
{
    const auto model = test::sineBeam (20, 8);

    for (const auto brake : { std::optional<double>(), std::optional<double> (5.0) })
        for (const auto rate : rates)
        {
            const Playback playback { Reconstruction::bandLimited, rate };
            const auto error = renderedError (model, designFocus (model, focusFor (brake), playback), playback);
            INFO ("rate " << rate << " error " << error);
            CHECK (error < 2e-4 * std::pow (48000 / rate, 3) + 3e-6);
        }
}

TEST_CASE ("Without the release the agreement is of first order in the sample period, and high modes are shaken",
           "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    const auto released = designFocus (model, focusFor ({}), {});
    auto cut = released;

    for (auto& oscillation : cut.program.oscillations)
        if (oscillation.start >= cut.program.focusTime)
            oscillation.inPhase = oscillation.quadrature = 0;

    const auto coarse = renderedError (model, cut, { Reconstruction::bandLimited, 96000 });
    const auto fine = renderedError (model, cut, { Reconstruction::bandLimited, 384000 });
    CHECK (coarse > 1e-4);
    CHECK (coarse / fine == Approx (4).epsilon (0.1));
    CHECK (renderedError (model, released, { Reconstruction::bandLimited, 96000 }) < coarse / 20);
}

TEST_CASE ("Held samples: rows for the rate are exact at every rate", "[focus]")
{
    const auto model = test::sineBeam (20, 8);

    for (const auto rate : rates)
    {
        const Playback playback { Reconstruction::zeroOrderHold, rate };
        CHECK (renderedError (model, designFocus (model, focusFor ({}), playback), playback) < 1e-9);
    }
}

TEST_CASE ("At any time before and after the focus the plate model follows the closed form", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    const auto design = designFocus (model, focusFor (5.0), {});
    RenderSettings settings;
    settings.playback = { Reconstruction::bandLimited, 384000 };
    settings.duration = 0.04;
    settings.probeShapes.resize (0, model.modes());
    const auto render = renderOffline (model, design.program, settings);
    const auto largest = render.focusVelocities.cwiseAbs().maxCoeff();

    // Drives begin with a corner and brakes with a step, each between two samples: these limit the agreement here.
    for (const auto sample : { 3840, 6000, 7000, 7679, 7681, 9000, 12000, 15000 })
    {
        const auto time = 0.02 + (sample - static_cast<double> (render.focusSample)) / 384000;
        const auto closed = modalVelocities (model, predictStates (model, design.program, time));
        CHECK ((render.modalVelocities.col (sample) - closed).cwiseAbs().maxCoeff() < 5e-4 * largest);
    }
}
