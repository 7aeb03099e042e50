#include "Support/HeldPlate.h"

#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_render/Summary.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr Playback held { Reconstruction::zeroOrderHold, 192000 };

RenderedFocus renderedUnder (const std::vector<Finger>& fingers)
{
    const auto device = loadDevice ("staple", {});
    const auto known = solveDevice (device, {}, false);
    auto focus = loadFocus ("demonstrator", {});
    focus.fingers = fingers;
    auto made = designWide ({ known, known.modes(), "No others." }, focus, held, {});
    RenderOptions options;
    options.playback = held;
    options.duration = 0.0255;
    return renderFocus (std::move (made.wide), std::move (made.design), options);
}

/** The field at the focus that the same voltages make of M, C and K with the fingers, m/s. */
Eigen::VectorXd fieldOfMatrices (const RenderedFocus& focus, const std::vector<Finger>& fingers)
{
    const auto bare = solveDevice (loadDevice ("staple", {}), {}, false);
    test::HeldPlate plate (bare, fingers, 1 / focus.render.sampleRate);

    for (Eigen::Index n = 0; n < focus.render.focusSample; ++n)
        plate.after (bare.participation * focus.render.voltages.col (n));

    return bare.shapes * plate.state.tail (bare.modes());
}
} // namespace

TEST_CASE ("A render under fingers plays what M, C and K with the fingers do", "[fingers]")
{
    auto finger = builtInFinger ("medium", 0.024, 0);
    auto other = builtInFinger ("light", -0.03, 0);
    finger.isKnown = other.isKnown = false;
    const auto unknown = renderedUnder ({ finger, other });
    const auto wanted = fieldOfMatrices (unknown, { finger, other });
    CHECK ((unknown.reachedField - wanted).cwiseAbs().maxCoeff() < 1e-9 * wanted.cwiseAbs().maxCoeff());
    CHECK (unknown.truncatedScore.fieldError > 0.02);

    // A design that knows them makes the field that was wanted.
    finger.isKnown = other.isKnown = true;
    const auto known = renderedUnder ({ finger, other });
    CHECK (known.truncatedScore.fieldError < 2e-3);
    CHECK (known.truncatedScore.fieldError < 0.05 * unknown.truncatedScore.fieldError);
    CHECK (known.moments.front().peak.velocity == Approx (0.04).epsilon (0.05));

    const auto motions = fingerMotions (known);
    REQUIRE (motions.size() == 2);
    CHECK (motions[0].velocityAtFocus == Approx (known.moments.front().peak.velocity).epsilon (0.1));
}
