#include <antinode_documents/Inputs.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/EventPeak.h>
#include <antinode_render/Summary.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace antinode;

namespace
{
RenderedFocus render (const ModalModel& model, const FocusDescription& focus,
                      std::vector<std::pair<double, double>> probes = {})
{
    RenderOptions options;
    options.probes = std::move (probes);
    return renderFocus (model, designFocus (model, focus, options.playback, DesignExtent::playable), options);
}

FocusDescription sincAt (double x, double y, double width)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, x, y, width, 0.03, 1 } };
    focus.focusTime = 0.025;
    focus.allocation.method = AllocationMethod::paper;
    focus.allocation.voltageLimit = 1e4;
    return focus;
}

/** Probes at the maximum and around it, played by the plate model itself, contradict no number that is reported. */
void checkAgainstProbes (const ModalModel& model, const FocusDescription& focus)
{
    const auto first = render (model, focus);
    const auto& peak = first.moments.front().peak;
    std::vector<std::pair<double, double>> places { { peak.x, peak.y } };

    for (int i = 0; i < 24; ++i)
        for (const auto radius : { 0.0003, 0.001, 0.003 })
        {
            const auto& surface = model.surface;
            const auto isLine = surface.kind == SurfaceKind::line;
            const auto x = peak.x + radius * std::cos (0.26 * i);
            const auto y = isLine ? 0 : peak.y + radius * std::sin (0.26 * i);

            if (x > surface.xMinimum && x < surface.xMaximum
                && (isLine || (y > surface.yMinimum && y < surface.yMaximum)))
                places.emplace_back (x, y);
        }

    const auto probed = render (model, focus, places);
    const Eigen::VectorXd atFocus = probed.render.probeVelocities.col (probed.render.focusSample);
    CHECK (atFocus[0] == Approx (peak.velocity).epsilon (1e-9));
    CHECK (atFocus.cwiseAbs().maxCoeff() <= std::abs (peak.velocity) * (1 + 1e-3));
    CHECK (first.reachedField.cwiseAbs().maxCoeff() <= std::abs (peak.velocity) * (1 + 1e-9));

    // The ratio is that of the probe at the wanted place: a single sinc is largest at its centre.
    const auto& target = focus.targets.front();
    const auto atCentre = shapesAt (model, target.x, target.y).dot (first.render.focusVelocities);
    CHECK (first.score.peakRatio == Approx (atCentre / target.peakVelocity).epsilon (1e-6));

    const auto outcome = evaluateOutcome (first);
    CHECK (outcome.targets.front().peak.velocity == Approx (peak.velocity).epsilon (1e-3));
    CHECK (outcome.targets.front().velocityAtCentre == Approx (atCentre));
    CHECK (std::abs (outcome.elsewhere.velocity) >= std::abs (outcome.sideLobe.velocity) * (1 - 1e-3));
    CHECK (outcome.eventContrast == Approx (std::abs (peak.velocity / outcome.elsewhere.velocity)));

    // A probe where the event is largest elsewhere has that velocity at that time, and none larger.
    const auto elsewhere = render (model, focus, { { outcome.elsewhere.x, outcome.elsewhere.y } });
    const auto position = outcome.elsewhere.time * elsewhere.render.sampleRate;
    CHECK (betweenSamples (elsewhere.render.probeVelocities, position)[0]
           == Approx (outcome.elsewhere.velocity).epsilon (1e-3));
    CHECK (elsewhere.render.probeVelocities.cwiseAbs().maxCoeff()
           <= std::abs (outcome.elsewhere.velocity) * (1 + 1e-3));
}
} // namespace

TEST_CASE ("Peaks of beam, staple and plate are what probes there read", "[render][peak]")
{
    checkAgainstProbes (solveStructure (loadDevice ("beam", {})), sincAt (0.0231, 0, 0.02));
    checkAgainstProbes (solveStructure (loadDevice ("staple", {})), sincAt (-0.0173, 0, 0.018));

    // At a free edge, where a plate has no points.
    const auto plate = solveStructure (loadDevice ("aluminium-200x120", {}), 60);
    checkAgainstProbes (plate, sincAt (0.1031, 0.0517, 0.035));
    checkAgainstProbes (plate, sincAt (0.2, 0.0713, 0.04));
}

TEST_CASE ("The largest velocity elsewhere is found by all samples on 2000 places", "[render][peak]")
{
    const auto model = solveStructure (loadDevice ("staple", {}));
    const auto focus = render (model, loadFocus ("demonstrator", {}));
    const auto outcome = evaluateOutcome (focus);
    double brute = 0;

    for (int i = 0; i <= 2000; ++i)
    {
        const auto x = std::lerp (model.surface.xMinimum, model.surface.xMaximum, i / 2000.0);

        if (std::abs (x - 0.024) >= 0.025)
            brute = std::max (brute, (shapesAt (model, x, 0) * focus.render.modalVelocities).cwiseAbs().maxCoeff());
    }

    CHECK (std::abs (outcome.elsewhere.velocity) == Approx (brute).epsilon (1e-3));
    CHECK (std::abs (outcome.elsewhere.velocity) >= brute * (1 - 1e-4));

    // A sinc's first side lobe is 0.2172 of its peak; within 25 mm of 24 mm lies the end of the staple.
    CHECK (outcome.wantedSideLobe == Approx (0.2172).epsilon (1e-3));
    const auto json = summaryToJson (focus, outcome);
    CHECK (json["event_contrast"] == outcome.eventContrast);
    CHECK (json["targets"][0]["velocity_mm_s"] == Approx (1000 * outcome.targets[0].peak.velocity));
    CHECK (json["targets"][0]["width_mm"][1].is_null());
    CHECK (json["field_limit"] == outcome.limit);
}

TEST_CASE ("Of several targets each has its own peak, sign and width", "[render][peak]")
{
    const auto model = solveStructure (loadDevice ("aluminium-200x120", {}), 60);
    auto focus = sincAt (0.07, 0.06, 0.04);
    focus.targets.push_back (focus.targets[0]);
    focus.targets[1].x = 0.15;
    focus.targets[1].phase = -1;
    const auto outcome = evaluateOutcome (render (model, focus));
    REQUIRE (outcome.targets.size() == 2);
    CHECK (outcome.targets[0].peak.velocity > 0);
    CHECK (outcome.targets[1].peak.velocity < 0);

    for (const auto& target : outcome.targets)
    {
        CHECK (std::hypot (target.peak.x - target.wanted.x, target.peak.y - target.wanted.y) < 0.02);
        CHECK (target.width.value_or (1) == Approx (0.04).epsilon (0.5));
    }
}

TEST_CASE ("A target that covers the whole surface has nothing beside it", "[render][peak]")
{
    const auto staple = solveStructure (loadDevice ("staple", {}));
    const auto focus = render (staple, sincAt (0.024, 0, 0.19));
    const auto outcome = evaluateOutcome (focus);
    CHECK (outcome.sideLobe.velocity == 0);
    CHECK (outcome.elsewhere.velocity == 0);
    CHECK (outcome.eventContrast == 0);
    CHECK (summaryToJson (focus, outcome).at ("side_lobe") == 0);
}
