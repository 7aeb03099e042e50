#include "Support/SineBeam.h"

#include <antinode_allocation/BoundedWaveform.h>
#include <antinode_engine/FocusPlayer.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace antinode;

namespace
{
constexpr Playback at96kHz { Reconstruction::bandLimited, 96000 };
constexpr Playback held { Reconstruction::zeroOrderHold, 96000 };

FocusDescription freeFocus (double limit)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.0150037; // between two samples
    focus.modes.count = 6;
    focus.allocation.method = AllocationMethod::leastVoltage;
    focus.allocation.timesBound = upToLimits;
    focus.allocation.voltageLimit = limit;
    return focus;
}

/** What any waveform needs, of the focus above: the design without a limit knows it. */
double lowerBoundVolts (const ModalModel& model)
{
    return designFocus (model, freeFocus (150), at96kHz).lowerBoundVoltage;
}

Render played (const ModalModel& model, const FocusDesign& design, Playback playback)
{
    RenderSettings settings;
    settings.playback = playback;
    settings.duration = 0.02;
    settings.probeShapes.resize (0, model.modes());
    return renderOffline (model, design.program, settings);
}
/** The voltages of a note that ends at a sample, where note-offs begin the brake. */
Eigen::MatrixXd playedWithNoteOff (const std::shared_ptr<const PlayableFocus>& focus, std::int64_t noteOff,
                                   std::int64_t length)
{
    PlayerSettings settings;
    settings.noteOff = NoteOffBehaviour::brake;
    FocusPlayer player (8, at96kHz.sampleRate, settings);
    auto bank = std::make_unique<FocusBank>();
    bank->foci[60] = focus;
    player.handOver().give (std::move (bank));
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> voltages (8, length);
    std::vector<double*> channels;

    for (Eigen::Index i = 0; i < 8; ++i)
        channels.push_back (voltages.row (i).data());

    const FocusEvent events[] { { 0, FocusEventKind::trigger, 60, 1 },
                                { static_cast<int> (noteOff), FocusEventKind::release, 60, 0 } };
    player.process (channels.data(), static_cast<int> (length), events);
    return voltages;
}

/** How large the motion is at a sample, kinetic and elastic: the root of the sum of v_k^2 + (b_k q_k)^2. */
double motionAt (const ModalModel& model, const Eigen::MatrixXd& voltages, std::int64_t sample)
{
    PlateModel plate (model, at96kHz, Eigen::MatrixXd (0, model.modes()));
    Eigen::MatrixXd shown = Eigen::MatrixXd::Zero (voltages.rows(), sample + plate.latencySamples() + 1);
    const auto count = std::min (shown.cols(), voltages.cols());
    shown.leftCols (count) = voltages.leftCols (count);
    Eigen::MatrixXd velocities (model.modes(), shown.cols());
    plate.processModes (shown, velocities);
    return std::hypot (plate.modalVelocities().norm(),
                       dampedFrequencies (model).cwiseProduct (plate.modalDisplacements()).norm());
}
} // namespace

TEST_CASE ("A free waveform at its limit brings every controlled mode to its velocity, played by the plate model",
           "[freeWaveform]")
{
    const auto model = test::sineBeam (20, 8);
    const auto limit = 1.1 * lowerBoundVolts (model);

    for (const auto playback : { at96kHz, held })
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
    CHECK_NOTHROW (designFocus (model, freeFocus (1.02 * bound), at96kHz));

    try
    {
        designFocus (model, freeFocus (0.9 * bound), at96kHz);
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
    SampledVoltages impulse { at96kHz, 0, Eigen::MatrixXd::Zero (2, 40) };
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

TEST_CASE ("A free waveform is refused at another rate", "[freeWaveform]")
{
    const auto model = test::sineBeam (20, 8);
    const auto design = designFocus (model, freeFocus (150), at96kHz);
    CHECK_THROWS_WITH (played (model, design, { Reconstruction::bandLimited, 48000 }),
                       Catch::Contains ("was designed for 96000 Hz, band_limited; design it again for 48000 Hz"));
    CHECK_THROWS_WITH (played (model, design, held), Catch::Contains ("zero_order_hold"));
    CHECK_THROWS_WITH (PlayableFocus (design.program, held), Catch::Contains ("zero_order_hold"));
    CHECK_THROWS_WITH (designFocus (model, freeFocus (150), {}), Catch::Contains ("sample rate"));
}

TEST_CASE ("A design to be played has the samples of the complete one", "[freeWaveform]")
{
    const auto model = test::sineBeam (20, 8);
    const auto complete = designFocus (model, freeFocus (150), at96kHz);
    const auto playable = designFocus (model, freeFocus (150), at96kHz, DesignExtent::playable);
    CHECK (playable.program.samples->values == complete.program.samples->values);
}

TEST_CASE ("A late brake stops the plate after samples as after oscillations", "[freeWaveform][player]")
{
    auto model = test::sineBeam (20, 8);
    model.dampingRatios = 40 * model.angularFrequencies.cwiseInverse();
    auto focus = freeFocus (150);
    focus.transients.brakeDuration = 0.02;
    const auto design = designFocus (model, focus, at96kHz);
    const auto playable = std::make_shared<const PlayableFocus> (design.program, at96kHz);
    REQUIRE (playable->brake);
    const auto start = playable->brake->startSample();
    const auto rest = start + std::llround (0.022 * at96kHz.sampleRate);
    const auto leftAfter = [&] (std::int64_t delay)
    {
        const auto voltages = playedWithNoteOff (playable, start + delay, rest + delay);
        return motionAt (model, voltages, rest + delay) / motionAt (model, voltages, start + delay);
    };
    const auto designed = leftAfter (0);
    CHECK (designed < 1e-3);

    for (const auto delay : { 1, 700, 4000 })
    {
        CAPTURE (delay);
        CHECK (leftAfter (delay) < 0.05); // Free decay leaves 0.4.
    }
}
