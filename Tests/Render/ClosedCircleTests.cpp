#include <antinode_documents/Inputs.h>

#include <Support/ClosedCircle.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("A focus designed on the beam as it was measured at 40 dB is the same on the beam itself", "[render]")
{
    const auto beam = solveStructure (loadDevice ("beam", {}));
    constexpr Eigen::Index points = 32;
    Eigen::MatrixX2d places = Eigen::MatrixX2d::Zero (points, 2);
    places.col (0) = Eigen::VectorXd::LinSpaced (points, beam.surface.xMinimum + 0.002, beam.surface.xMaximum - 0.002);
    ExcitationSettings settings;
    settings.sampleRate = 48000;
    settings.lowestFrequency = 120;
    settings.highestFrequency = 19000;
    settings.resolution = 2;
    settings.periods = 2;
    settings.settlingPeriods = 2;

    FocusDescription focus;
    focus.targets = { Target {} };
    focus.targets[0].shape = TargetShape::bump;
    focus.targets[0].width = 0.025;
    focus.targets[0].peakVelocity = 0.02;
    focus.focusTime = 0.025;
    const auto identified = identify (measuredOnBench (beam, places, settings, {}).responses, {});
    REQUIRE (identified.modes() == 12); // All in the band; the next is at 20.2 kHz.

    for (const auto x : { -0.05, 0.0, 0.024 })
    {
        CAPTURE (x);
        focus.targets[0].x = x;
        const auto score = closedCircle (beam, identified, focus);
        CHECK (score.vScore >= 0.9999);
        CHECK (score.peakRatio == Approx (1).epsilon (0.005));
    }
}
