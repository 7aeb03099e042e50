#include "antinode_resources.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

#include <cmath>

// The embedded staple with its embedded focuses, through the plate model, which knows only the samples.

using namespace antinode;

namespace
{
nlohmann::json embedded (const std::string& name)
{
    for (const auto& file : resources::files())
        if (file.name == name)
            return parseJson (file.text(), name);

    throw InputError (name, "is not embedded");
}

const ModalModel& staple()
{
    static const auto model = solveStructure (readDevice (embedded ("Devices/staple.json"), "staple"));
    return model;
}

Render rendered (const FocusDesign& design, Playback playback, double duration)
{
    RenderSettings settings;
    settings.playback = playback;
    settings.duration = duration;
    settings.probeShapes.resize (0, staple().modes());
    return renderOffline (staple(), design.program, settings);
}

/** The largest velocity in the 2 ms from 20 ms after the focus on, of the peak at the focus. */
double residual (const Render& render)
{
    const auto first = render.focusSample + std::llround (0.02 * render.sampleRate);
    const Eigen::MatrixXd left =
        staple().shapes * render.modalVelocities.middleCols (first, std::llround (0.002 * render.sampleRate));
    return left.cwiseAbs().maxCoeff() / (staple().shapes * render.focusVelocities).cwiseAbs().maxCoeff();
}
} // namespace

TEST_CASE ("The demonstrator is at rest 20 ms after the focus within 50 V, where free decay leaves 30 %",
           "[focus][brake]")
{
    auto focus = readFocus (embedded ("Focuses/demonstrator.json"), "demonstrator");

    for (const auto reconstruction : { Reconstruction::bandLimited, Reconstruction::zeroOrderHold })
    {
        const Playback playback { reconstruction, 96000 };
        focus.transients.brakeDuration = {};
        CHECK (residual (rendered (designFocus (staple(), focus, playback, DesignExtent::playable), playback, 0.05))
               > 0.25);
        focus.transients.brakeDuration = 0.02;
        const auto render = rendered (designFocus (staple(), focus, playback, DesignExtent::playable), playback, 0.05);
        CHECK (residual (render) < 2e-4);
        CHECK (render.voltages.cwiseAbs().maxCoeff() < 50);
    }
}

TEST_CASE ("The embedded train reaches both foci on the staple and rests after the second", "[focus][train]")
{
    const auto focus = readFocus (embedded ("Focuses/staple-train.json"), "staple-train");

    for (const auto reconstruction : { Reconstruction::bandLimited, Reconstruction::zeroOrderHold })
    {
        const Playback playback { reconstruction, 96000 };
        const auto design = designFocus (staple(), focus, playback, DesignExtent::playable);
        const auto render = rendered (design, playback, 0.06);
        REQUIRE (design.moments.size() == 2);
        CHECK (design.moments[1].time == Approx (0.035));

        for (const auto& moment : design.moments)
        {
            const auto sample = render.focusSample + std::llround ((moment.time - 0.025) * playback.sampleRate);
            const Eigen::VectorXd field = staple().shapes * render.modalVelocities.col (sample);
            const auto score = scoreField (staple().surface, field, moment.truncatedField);
            CHECK (score.vScore >= 0.999);
            CHECK (score.fieldError <= 0.01);
        }

        CHECK (render.modalVelocities.rightCols (100).cwiseAbs().maxCoeff()
               < 1e-3 * render.focusVelocities.cwiseAbs().maxCoeff());
    }
}

TEST_CASE ("Limits out of reach are proven so at every place of the staple, with what can be reached", "[focus]")
{
    auto focus = readFocus (embedded ("Focuses/demonstrator.json"), "demonstrator");
    focus.targets.front().peakVelocity = 10;

    // The middle is the hardest: there the voltages of the two halves may be exchanged.
    for (const auto place : { -0.046, -0.024, 0.0, 0.007, 0.024, 0.046 })
    {
        focus.targets.front().x = place;
        CAPTURE (place);

        try
        {
            designFocus (staple(), focus, { Reconstruction::bandLimited, 192000 }, DesignExtent::playable);
            FAIL ("10 m/s was reached");
        }
        catch (const LimitError& error)
        {
            CHECK (error.minimumPeakVoltage > 500);
            CHECK (error.reachableVelocity == Approx (10 * 50 / error.minimumPeakVoltage).epsilon (1e-6));
        }
    }
}
