#include "Support/SineBeam.h"

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/Brake.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/ModeDrives.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace antinode;

namespace
{
FocusDescription brakedFocus (std::optional<double> brake, std::optional<double> duration, double limit = 150)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.025;
    focus.modes.count = 8;
    focus.allocation.voltageLimit = limit;
    focus.transients.brake = brake;
    focus.transients.brakeDuration = duration;
    return focus;
}

/** The size of the motion of the controlled modes, kinetic and elastic. */
double motion (const ModalModel& model, const FocusDesign& design, double time)
{
    return predictStates (model, design.program, time) (design.controlledModes).norm();
}

/** The largest velocity anywhere that the plate model shows in the 2 ms after the brake, of that at the focus. */
double renderedResidual (const ModalModel& model, const FocusDesign& design, Playback playback)
{
    RenderSettings settings;
    settings.playback = playback;
    settings.duration = design.program.focusTime + *design.restTime + 0.003;
    settings.probeShapes.resize (0, model.modes());
    const auto render = renderOffline (model, design.program, settings);
    const auto rest = render.focusSample + static_cast<Eigen::Index> (*design.restTime * playback.sampleRate) + 1;
    const auto count = static_cast<Eigen::Index> (0.002 * playback.sampleRate);
    const Eigen::MatrixXd left = model.shapes * render.modalVelocities.middleCols (rest, count);
    return left.cwiseAbs().maxCoeff() / (model.shapes * render.focusVelocities).cwiseAbs().maxCoeff();
}

bool isSaid (const std::vector<std::string>& sentences, const std::string& part)
{
    return std::any_of (sentences.begin(), sentences.end(),
                        [&] (const std::string& sentence) { return sentence.find (part) != std::string::npos; });
}
} // namespace

TEST_CASE ("A brake brings velocity and displacement of all controlled modes to rest, to 1e-9", "[focus][brake]")
{
    const auto model = test::sineBeam (20, 8);

    for (const auto& [brake, duration] : std::vector<std::pair<std::optional<double>, std::optional<double>>> {
             { {}, 0.02 }, { 8.0, 0.02 }, { {}, 0.008 }, { 30.0, {} } })
    {
        const auto design = designFocus (model, brakedFocus (brake, duration), {});
        const auto before = motion (model, design, 0.025 + releaseDuration());
        REQUIRE (design.restTime.has_value());
        CHECK (*design.restTime == Approx (duration.value_or (*design.restTime)));

        // Modes that would come to less than 2e-5 of the peak by themselves are left to do so.
        const auto isFree = [&] (int k)
        {
            return std::none_of (design.program.oscillations.begin(), design.program.oscillations.end(),
                                 [&] (const Oscillation& o) { return o.isBrake() && o.mode == k; });
        };
        const auto states = predictStates (model, design.program, 0.025 + *design.restTime);

        for (const auto k : design.controlledModes)
            CHECK (std::abs (states[k]) < (isFree (k) ? 1e-3 : 1e-9) * before);
    }
}

TEST_CASE ("The plate model is at rest after the brake, band-limited and held, at 48 and 192 kHz", "[focus][brake]")
{
    const auto model = test::sineBeam (20, 8, 200);

    for (const auto reconstruction : { Reconstruction::bandLimited, Reconstruction::zeroOrderHold })
        for (const auto rate : { 48000.0, 192000.0 })
        {
            const Playback playback { reconstruction, rate };
            const auto free = designFocus (model, brakedFocus ({}, {}), playback);
            auto unbraked = free;
            unbraked.restTime = 0.02;
            const auto braked = designFocus (model, brakedFocus ({}, 0.02), playback);
            CHECK (renderedResidual (model, unbraked, playback) > 0.05);
            CHECK (renderedResidual (model, braked, playback) < 1e-3);
        }
}

TEST_CASE ("A brake's drives begin and end without a step of value or slope", "[focus][brake]")
{
    const BrakeWindow window { 0.001, 0.011, 300 };

    for (const auto& drive : brakeDrives (0, 20, 6000, window))
    {
        const auto value = [&] (double time)
        {
            double sum = 0;

            for (const auto& oscillation : drive)
                sum += oscillationValue (oscillation, time);

            return sum;
        };
        double largest = 0;

        for (auto t = window.start; t < window.end; t += 1e-6)
            largest = std::max (largest, std::abs (value (t)));

        CHECK (largest > 0.5);

        // The curvature is at most 2 (r + b)^2, so second differences over h = 1e-7 s are below 2e-5, and 5e-6 more
        // where parts end at 1e-6 of their size. A step of the slope, b h at least, would show as 6e-4, one of the
        // value as 1.
        double bend = 0;

        for (auto t = window.start - 1e-6; t < window.end + 2e-6; t += 1e-7)
            bend = std::max (bend, std::abs (value (t + 2e-7) - 2 * value (t + 1e-7) + value (t)));

        CHECK (bend < 3e-5);

        CHECK (std::abs (value (window.start + 1e-6)) < 2 * std::pow (releaseRate() * 1e-6, 2));
        CHECK (value (window.end + 1e-9) == 0);
    }
}

TEST_CASE ("The counter-rotating share of a brake tells how it must turn to meet a later state", "[focus][brake]")
{
    // A slow, strongly damped mode and a brake of few cycles: the share is large.
    const std::complex<double> pole (-40, 900), force (0.7, -1.3);
    const auto drives = brakeDrives (0, 40, 900, { 0, 0.012, 250 });
    const auto stateUnder = [&] (std::complex<double> z)
    {
        std::complex<double> state = 0;

        for (std::size_t d = 0; d < 2; ++d)
            for (const auto& oscillation : drives[d])
                state += (d == 0 ? z.real() : -z.imag()) * modalResponse (pole, oscillation, 0.012);

        return state;
    };
    const auto rho = counterShare (pole, drives, force);
    CHECK (std::abs (rho) > 0.02);
    CHECK (std::abs (rho) < 0.9);

    for (const auto delay : { 0.0, 0.0013, 0.01 })
    {
        const auto turn = std::exp (pole * delay);
        const auto factor =
            ((1.0 + rho) * turn - rho * (1.0 + std::conj (rho)) * std::conj (turn)) / (1 - std::norm (rho));
        const auto wanted = turn * stateUnder (force);
        CHECK (std::abs (stateUnder (factor * force) - wanted) < 1e-12 * std::abs (stateUnder (force)));
    }

    CHECK (counterShare (pole, drives, 0) == 0.0);
}

TEST_CASE ("Where the limit does not allow rest in time, the brake takes longer, keeps the limit and says so",
           "[focus][brake]")
{
    const auto model = test::sineBeam (20, 8, 300);
    const auto peak = peakVoltage (designFocus (model, brakedFocus ({}, {}), {}));
    const auto design = designFocus (model, brakedFocus ({}, 0.004, 1.1 * peak), {});
    REQUIRE (*design.restTime > 0.004);
    CHECK (*design.restTime < 0.04);
    CHECK (isSaid (design.warnings,
                   "Within the limits the surface cannot be at rest 4 ms after the focus; it is at rest after "));
    CHECK (motion (model, design, 0.025 + *design.restTime) < 2e-3 * motion (model, design, 0.0257));

    RenderSettings settings;
    settings.playback = { Reconstruction::bandLimited, 192000 };
    settings.duration = 0.07;
    settings.probeShapes.resize (0, model.modes());
    const auto render = renderOffline (model, design.program, settings);
    CHECK (render.voltages.cwiseAbs().maxCoeff() <= 1.1 * peak);
    CHECK (std::all_of (render.limitedSamples.begin(), render.limitedSamples.end(),
                        [] (std::int64_t samples) { return samples == 0; }));
}

TEST_CASE ("A brake that is too steep for the limit becomes flat before it becomes longer", "[focus][brake]")
{
    const auto model = test::sineBeam (20, 8, 300);
    const auto peak = peakVoltage (designFocus (model, brakedFocus ({}, {}), {}));
    const auto design = designFocus (model, brakedFocus (3000.0, 0.02, 1.1 * peak), {});
    CHECK (*design.restTime == 0.02);
    CHECK (isSaid (design.warnings, "do not allow so fast a brake"));
    CHECK (isSaid (design.choices, "the voltages do not decay before that"));
}

TEST_CASE ("A brake in less time than its onset and release take is refused", "[focus][brake]")
{
    const auto model = test::sineBeam (20, 8);
    CHECK_THROWS_WITH (designFocus (model, brakedFocus ({}, 0.0015), {}),
                       Catch::Contains ("focus: brake duration: is ")
                           && Catch::Contains ("allowed: at least 2.072 ms"));
}
