#include "Support/SineBeam.h"

#include <antinode_allocation/BoundedWaveform.h>
#include <antinode_engine/FocusBank.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/SampledPrediction.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr Playback bandLimited { Reconstruction::bandLimited, 96000 };
constexpr Playback held { Reconstruction::zeroOrderHold, 96000 };

FocusDescription freeFocus (double limit)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.0150037; // between two samples
    focus.modes.count = 6;
    focus.allocation.method = AllocationMethod::freeWaveform;
    focus.allocation.voltageLimit = limit;
    return focus;
}

/** What any waveform needs, of the focus above: the design without a limit knows it. */
double lowerBoundVolts (const ModalModel& model)
{
    return designFocus (model, freeFocus (150), bandLimited).lowerBoundVoltage;
}

Render played (const ModalModel& model, const FocusDesign& design, Playback playback)
{
    RenderSettings settings;
    settings.playback = playback;
    settings.duration = 0.02;
    settings.probeShapes.resize (0, model.modes());
    return renderOffline (model, design.program, settings);
}
} // namespace

TEST_CASE ("A free waveform at its limit brings every controlled mode to its velocity, played by the plate model",
           "[freeWaveform]")
{
    const auto model = test::sineBeam (20, 8);
    const auto limit = 1.1 * lowerBoundVolts (model);

    for (const auto playback : { bandLimited, held })
    {
        const auto design = designFocus (model, freeFocus (limit), playback);
        const auto render = played (model, design, playback);
        const auto largest = design.target.modalVelocities.cwiseAbs().maxCoeff();
        const auto closed = modalVelocities (model, predictStates (model, design.program, design.program.focusTime));
        CHECK (design.certificate.status == AllocationStatus::optimal);
        CHECK (design.certificate.gap < 1e-9);
        CHECK (render.voltages.cwiseAbs().maxCoeff() == Approx (limit).epsilon (1e-12));
        CHECK (render.limitedSamples == std::vector<std::int64_t> (8, 0));

        for (const auto mode : design.controlledModes)
        {
            CHECK (closed[mode] == Approx (design.target.modalVelocities[mode]).margin (1e-9 * largest));
            CHECK (render.focusVelocities[mode]
                   == Approx (design.target.modalVelocities[mode]).margin (1e-9 * largest));
        }
    }
}

TEST_CASE ("No free waveform goes below the bound of all waveforms, and one comes within 2 % of it", "[freeWaveform]")
{
    const auto model = test::sineBeam (20, 8);
    const auto bound = lowerBoundVolts (model);
    CHECK_NOTHROW (designFocus (model, freeFocus (1.02 * bound), bandLimited));

    try
    {
        designFocus (model, freeFocus (0.9 * bound), bandLimited);
        FAIL ("was not refused");
    }
    catch (const LimitError& error)
    {
        CHECK (error.minimumPeakVoltage == Approx (bound).epsilon (0.02));
        CHECK (error.reachableVelocity == Approx (0.9 * 0.04).epsilon (0.02));
    }
}

TEST_CASE ("Bounded samples of one mode: a bang-bang voltage at the least peak, the bracket holds it", "[freeWaveform]")
{
    // One row with weights w wants 1: the least peak is 1 / sum |w|, by Hoelder's inequality.
    BoundedWaveformProblem problem;
    problem.weights = Eigen::RowVectorXd::LinSpaced (1000, 0, 60).array().sin().matrix();
    problem.participation = Eigen::MatrixXd::Constant (1, 1, 2.0);
    problem.wanted = Eigen::VectorXd::Ones (1);
    problem.compliance = Eigen::VectorXd::Zero (1);
    problem.limits = Eigen::VectorXd::Constant (1, 0.5);
    const auto minimum = 1 / (2.0 * 0.5 * problem.weights.cwiseAbs().sum());
    const auto bracket = minimumWaveformPeak (problem, 1e-3);
    CHECK (bracket.lower <= minimum * (1 + 1e-9));
    CHECK (bracket.upper >= minimum * (1 - 1e-9));
    CHECK (bracket.upper < bracket.lower * 1.001);
    problem.limits *= 1.2 * minimum;
    const auto inside = solveBoundedWaveform (problem);
    CHECK (inside.isMet);
    CHECK (inside.objective == Approx (inside.bound).epsilon (1e-9));
    problem.limits *= 0.9 / 1.2;
    const auto outside = solveBoundedWaveform (problem);
    CHECK_FALSE (outside.isMet);
    CHECK (outside.peakBound > 1);
}

TEST_CASE ("A free waveform between its samples: voltages and states are those of the playback", "[freeWaveform]")
{
    const auto model = test::sineBeam (6, 2);
    SampledVoltages impulse { bandLimited, 0, Eigen::MatrixXd::Zero (2, 40) };
    impulse.values (0, 20) = 3;
    CHECK (voltagesAt (impulse, 20 / 96000.0)[0] == Approx (3));
    CHECK (std::abs (voltagesAt (impulse, 21 / 96000.0)[0]) < 1e-12);
    CHECK (intersamplePeak (impulse) == Approx (3));

    // Free decay from a sample to a place between two, long after the impulse.
    const auto before = sampledStates (model, impulse, 80 / 96000.0);
    const auto after = sampledStates (model, impulse, 80.3 / 96000.0);
    const Eigen::ArrayXcd decay = (modalPoles (model).array() * (0.3 / 96000)).exp();
    CHECK ((after.array() - decay * before.array()).abs().maxCoeff() < 1e-12 * before.cwiseAbs().maxCoeff());

    // Within the kernel: two halves of an interval are the whole.
    const auto halfway = sampledStates (model, impulse, 19.999999 / 96000.0);
    const auto whole = sampledStates (model, impulse, 20 / 96000.0);
    CHECK ((halfway - whole).cwiseAbs().maxCoeff() < 1e-4 * whole.cwiseAbs().maxCoeff());
}

TEST_CASE ("A free waveform is refused at another rate and in real time", "[freeWaveform]")
{
    const auto model = test::sineBeam (20, 8);
    const auto design = designFocus (model, freeFocus (150), bandLimited);
    CHECK_THROWS_WITH (played (model, design, { Reconstruction::bandLimited, 48000 }),
                       Catch::Contains ("was designed for 96000 Hz, band_limited; design it again for 48000 Hz"));
    CHECK_THROWS_WITH (played (model, design, held), Catch::Contains ("zero_order_hold"));
    CHECK_THROWS_WITH (PlayableFocus (design.program, bandLimited), Catch::Contains ("'dictionary'"));
    CHECK_THROWS_WITH (designFocus (model, freeFocus (150), bandLimited, DesignExtent::playable),
                       Catch::Contains ("use 'dictionary'"));
    CHECK_THROWS_WITH (designFocus (model, freeFocus (150), {}), Catch::Contains ("sample rate"));
}
