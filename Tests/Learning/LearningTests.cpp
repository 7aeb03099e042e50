#include "Support/ErrorText.h"
#include "Support/SineBeam.h"

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_learning/LearnModes.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_learning/PlayedVoltages.h>
#include <antinode_numerics/RandomNumbers.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace antinode;
using test::sineBeam;

namespace
{
constexpr double rate = 24000;
constexpr int knownModes = 7, allModes = 9;

/** What the plate model, which steps from sample to sample, gives for voltages: rows of shapes x N_s. */
Eigen::MatrixXd played (const ModalModel& model, const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& voltages)
{
    PlateModel plate (model, { Reconstruction::bandLimited, rate }, shapes);
    Eigen::MatrixXd fed = Eigen::MatrixXd::Zero (voltages.rows(), voltages.cols() + plate.latencySamples());
    fed.leftCols (voltages.cols()) = voltages;
    Eigen::MatrixXd velocities (shapes.rows(), fed.cols());
    plate.process (fed, velocities);
    return velocities.rightCols (voltages.cols());
}

FocusDescription sincFocus()
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.05, 0.02, 1 } };
    focus.focusTime = 0.02;
    focus.modes.count = 5;
    focus.allocation.voltageLimit = 150;
    return focus;
}

LearningSettings threePasses()
{
    return { rate, 0.12, 3 };
}

/** A beam whose modes are not those of the model, with sensors that are some samples late. */
struct Bench
{
    WideModel nominal { sineBeam (allModes, 5), knownModes, {} };
    ModalModel truth;
    std::vector<double> places { -0.07, -0.033, 0.012, 0.055 };
    double noise = 0.01, delay = 37 / rate, delayError = 4e-6;
    double delaySpan = 0; // above 0: nobody says the delay, which is another one in each pass

    explicit Bench (double scatter, std::uint64_t seed)
        : truth (detuned (sineBeam (allModes, 5), { scatter, 0.1, 0.05, 0 }, seed))
    {
    }

    std::vector<Sensor> sensors() const
    {
        std::vector<Sensor> result;

        for (const auto place : places)
            result.push_back ({ shapesAt (nominal.model, place, 0), 0 });

        return result;
    }

    PlayedRecording operator() (const Eigen::MatrixXd& voltages, int pass) const
    {
        Eigen::MatrixXd shapes (static_cast<Eigen::Index> (places.size()), truth.modes());

        for (Eigen::Index m = 0; m < shapes.rows(); ++m)
            shapes.row (m) = shapesAt (truth, places[static_cast<std::size_t> (m)], 0);

        const auto isKnown = delaySpan == 0;
        const auto late = static_cast<Eigen::Index> (delay * rate) + (isKnown ? 0 : 61 * pass);
        Eigen::MatrixXd signals = Eigen::MatrixXd::Zero (shapes.rows(), voltages.cols());
        signals.rightCols (signals.cols() - late) = played (truth, shapes, voltages).leftCols (signals.cols() - late);
        RandomNumbers random (static_cast<std::uint64_t> (100 + pass));
        const Eigen::VectorXd deviations =
            noise * signals.rowwise().norm() / std::sqrt (static_cast<double> (signals.cols()));

        for (Eigen::Index m = 0; m < signals.rows(); ++m)
            signals.row (m) += deviations[m] * random.normal (signals.cols()).transpose();

        return { rate, voltages, signals, deviations, isKnown ? delay + delayError : 0, delaySpan };
    }

    /** The field at the focus that voltages make. */
    Eigen::VectorXd field (const Eigen::MatrixXd& voltages) const
    {
        return played (truth, truth.shapes, voltages).col (static_cast<Eigen::Index> (sincFocus().focusTime * rate));
    }

    /** The voltages of one who knows the beam. */
    Eigen::MatrixXd exactVoltages() const
    {
        const Playback playback { Reconstruction::bandLimited, rate };
        const auto design = designWithin ({ truth, knownModes, {} }, sincFocus(), playback, DesignExtent::compared);
        return renderOffline (truth, design.program,
                              { playback, threePasses().duration, 512, Eigen::MatrixXd (0, truth.modes()) })
            .voltages;
    }

    double fieldError (const Eigen::MatrixXd& voltages) const
    {
        return scoreField (truth.surface, field (voltages), field (exactVoltages())).fieldError;
    }
};

LearntFocus learn (const Bench& bench, const PassPlayer& play)
{
    return learnFocus (bench.nominal, sincFocus(), bench.sensors(),
                       sameSpread (bench.nominal.model.modes(), 0.005, 0.1, 0.05), play, threePasses());
}
} // namespace

TEST_CASE ("A mode that the voltages keep at rest by what is known of it is learnt where it moves", "[learning]")
{
    const auto nominal = sineBeam (allModes, 5);
    auto truth = nominal;
    constexpr Eigen::Index mode = 2, first = 0, other = 3;
    truth.participation (mode, first) *= 1.05;
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (5, 2400);
    const auto balance = nominal.participation (mode, first) / nominal.participation (mode, other);

    for (Eigen::Index n = 0; n < 1200; ++n)
    {
        voltages (first, n) = 50 * std::sin (nominal.angularFrequencies[mode] * static_cast<double> (n) / rate);
        voltages (other, n) = -balance * voltages (first, n);
    }

    const auto shapes = shapesAt (nominal, 0.012, 0);
    const auto signals = played (truth, shapes, voltages);
    const Eigen::VectorXd noise = 0.01 * signals.rowwise().norm() / std::sqrt (2400.0);
    const auto learnt = learnModes (nominal, { { shapes, 0 } }, sameSpread (allModes, 0.005, 0.1, 0.05),
                                    { { rate, voltages, signals, noise, 0, 0 } });
    const auto moved = [&] (const ModalModel& model)
    { return model.participation (mode, first) - balance * model.participation (mode, other); };
    REQUIRE (std::abs (moved (nominal)) < 1e-12 * std::abs (nominal.participation (mode, first)));
    CHECK (moved (learnt.model) == Approx (moved (truth)).epsilon (0.02));
}

TEST_CASE ("A mode under band-limited voltages moves as the plate model says, which steps through time", "[learning]")
{
    const auto model = sineBeam (knownModes, 4);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (4, 2000);

    // Bursts well below the frequencies at which the plate model's interpolation falls.
    for (Eigen::Index n = 200; n < 1200; ++n)
        for (Eigen::Index i = 0; i < 4; ++i)
            voltages (i, n) = std::pow (std::sin (3.14159265 * static_cast<double> (n - 200) / 1000), 4)
                              * std::sin (0.05 * static_cast<double> ((i + 1) * n));

    const auto own = modeVelocities (model, { voltages, rate }, voltages.cols());
    const auto stepped = played (model, Eigen::MatrixXd::Identity (knownModes, knownModes), voltages);
    CHECK ((own.transpose() - stepped).norm() < 1e-6 * stepped.norm());
}

TEST_CASE ("The changes of a mode's motion are its differences", "[learning]")
{
    RandomNumbers random (3);
    const Eigen::VectorXd force = random.normal (500 * PlayedVoltages::places);
    constexpr double omega = 3000, damping = 0.02, step = 1e-6;
    const auto motion = [&] (double frequencyChange, double dampingChange)
    { return modeMotion (omega * (1 + frequencyChange), damping * (1 + dampingChange), force, rate, 500, true); };
    const auto middle = motion (0, 0);
    const Eigen::VectorXd byFrequency = (motion (step, 0).velocity - motion (-step, 0).velocity) / (2 * step);
    const Eigen::VectorXd byDamping = (motion (0, step).velocity - motion (0, -step).velocity) / (2 * step);
    CHECK ((middle.byFrequency - byFrequency).norm() < 1e-6 * byFrequency.norm());
    CHECK ((middle.byDamping - byDamping).norm() < 1e-6 * byDamping.norm());
}

TEST_CASE ("Three plays bring a focus on a plate half a percent off from percents to tenths", "[learning]")
{
    for (const std::uint64_t seed : { 1, 2, 3 })
    {
        const Bench bench (0.005, seed);
        std::vector<Eigen::MatrixXd> voltages;
        const auto play = [&] (const Eigen::MatrixXd& volts, int pass)
        {
            voltages.push_back (volts);
            return bench (volts, pass);
        };
        const auto learnt = learn (bench, play);
        REQUIRE (learnt.refusal.empty());
        const auto first = bench.fieldError (voltages.front());
        const auto last = bench.fieldError (voltages.back());
        CAPTURE (seed, first, last);
        CHECK (first > 0.03);
        CHECK (last < 0.01);
        CHECK (last < first / 10);
        // All that is left is noise, of which there is as much as was said.
        CHECK (learnt.learnt.residual == Approx (1).margin (0.02));
    }
}

TEST_CASE ("Delays that nobody says, of each play another one, are found to a microsecond", "[learning]")
{
    for (const std::uint64_t seed : { 1, 2, 3 })
    {
        Bench bench (0.005, seed);
        bench.delaySpan = 0.02;
        std::vector<Eigen::MatrixXd> voltages;
        const auto learnt = learn (bench,
                                   [&] (const Eigen::MatrixXd& volts, int pass)
                                   {
                                       voltages.push_back (volts);
                                       return bench (volts, pass);
                                   });
        CAPTURE (seed, learnt.refusal);
        REQUIRE (learnt.refusal.empty());
        CHECK (bench.fieldError (voltages.back()) < 0.01);

        for (int pass = 0; pass < 3; ++pass)
            CHECK (learnt.learnt.delays[pass] == Approx (bench.delay + 61 * pass / rate).margin (1e-6));
    }
}

TEST_CASE ("A device that is known nearly to the noise, as after retune, is made better still", "[learning]")
{
    for (const std::uint64_t seed : { 1, 2, 3 })
    {
        Bench bench (0, seed);
        bench.delaySpan = 0.02;
        bench.truth = detuned (sineBeam (allModes, 5), { 1e-4, 0.003, 0.005, 0 }, seed);
        std::vector<Eigen::MatrixXd> voltages;
        const auto play = [&] (const Eigen::MatrixXd& volts, int pass)
        {
            voltages.push_back (volts);
            return bench (volts, pass);
        };
        const auto learnt = learnFocus (bench.nominal, sincFocus(), bench.sensors(),
                                        sameSpread (allModes, 1e-4, 0.003, 0.005), play, threePasses());
        const auto& last = learnt.passes.back();
        CAPTURE (seed, last.surprise, learnt.refusal);
        // Half of what the nominal device leaves is noise, which nothing predicts.
        CHECK (last.nominalSurprise > 1.1);
        CHECK (last.nominalSurprise < 2);
        CHECK (learnt.refusal.empty());
        CHECK (bench.fieldError (voltages.back()) < 0.8 * bench.fieldError (voltages.front()));
    }
}

TEST_CASE ("No more is played once the field error is small enough", "[learning]")
{
    const Bench bench (0.005, 1);
    auto settings = threePasses();
    settings.passes = 9;
    settings.enough = 0.01;
    const auto learnt = learnFocus (bench.nominal, sincFocus(), bench.sensors(),
                                    sameSpread (bench.nominal.model.modes(), 0.005, 0.1, 0.05), bench, settings);
    REQUIRE (learnt.passes.size() > 1);
    CHECK (learnt.passes.size() < 6);
    CHECK (learnt.passes.front().estimatedError > 0.03);
    CHECK (learnt.passes.back().estimatedError < 0.01);
}

TEST_CASE ("What a mode does after the last voltage is what it does under voltages of zero", "[learning]")
{
    RandomNumbers random (5);
    const Eigen::VectorXd force = random.normal (300 * PlayedVoltages::places);
    Eigen::VectorXd padded = Eigen::VectorXd::Zero (4000 * PlayedVoltages::places);
    padded.head (force.size()) = force;

    // One that goes on to the end, and one that is at rest before.
    for (const auto damping : { 0.001, 0.05 })
    {
        const auto brief = modeMotion (6000, damping, force, rate, 4000, true);
        const auto whole = modeMotion (6000, damping, padded, rate, 4000, true);
        CHECK ((brief.velocity - whole.velocity).norm() < 1e-9 * whole.velocity.norm());
        CHECK ((brief.byFrequency - whole.byFrequency).norm() < 1e-7 * whole.byFrequency.norm());
        CHECK ((brief.byDamping - whole.byDamping).norm() < 1e-7 * whole.byDamping.norm());
    }

    CHECK (modeMotionUntilRest (6000, 0.05, force, rate, 4000, false).velocity.size() < 4000);
}

TEST_CASE ("What is said of learnt frequencies is what they are off by", "[learning]")
{
    double squares = 0;
    int count = 0;

    for (std::uint64_t seed = 1; seed <= 4; ++seed)
    {
        const Bench bench (0.005, seed);
        const auto learnt = learn (bench, bench).learnt;

        for (Eigen::Index k = 0; k < knownModes; ++k)
            if (learnt.frequencyDeviations[k] < 0.0025)
            {
                const auto off = learnt.model.angularFrequencies[k] / bench.truth.angularFrequencies[k] - 1;
                squares += std::pow (off / learnt.frequencyDeviations[k], 2);
                ++count;
            }
    }

    REQUIRE (count > 15);
    // Of 15 or more normal numbers the RMS lies between .6 and 1.5 but once in 10 000.
    CHECK (std::sqrt (squares / count) > 0.6);
    CHECK (std::sqrt (squares / count) < 1.5);
}

TEST_CASE ("Sensors that are swapped, silent or clipped are refused, and the first design stays", "[learning]")
{
    const Bench bench (0.005, 1);
    const auto isRefused = [&] (const std::function<void (PlayedRecording&)>& spoil)
    {
        const auto learnt = learn (bench,
                                   [&] (const Eigen::MatrixXd& volts, int pass)
                                   {
                                       auto recording = bench (volts, pass);
                                       spoil (recording);
                                       return recording;
                                   });
        return ! learnt.refusal.empty()
               && learnt.wide.model.angularFrequencies == bench.nominal.model.angularFrequencies
               && peakVoltage (learnt.design) == peakVoltage (learnt.passes.front().design);
    };
    CHECK (isRefused ([] (PlayedRecording& r) { r.signals.row (0).swap (r.signals.row (2)); }));
    CHECK (isRefused ([] (PlayedRecording& r) { r.signals.setZero(); }));
    CHECK (isRefused ([] (PlayedRecording& r) { r.signals *= 1e-6, r.noise *= 1e-6; }));
    CHECK (isRefused (
        [] (PlayedRecording& r)
        {
            const auto most = r.signals.cwiseAbs().maxCoeff() / 50;
            r.signals = r.signals.cwiseMin (most).cwiseMax (-most);
        }));
}

TEST_CASE ("Recordings that are not usable are refused in a sentence", "[learning]")
{
    const Bench bench (0.005, 1);
    const auto message = [&] (const std::function<void (PlayedRecording&)>& spoil)
    {
        return errorText (
            [&]
            {
                learn (bench,
                       [&] (const Eigen::MatrixXd& volts, int pass)
                       {
                           auto recording = bench (volts, pass);
                           spoil (recording);
                           return recording;
                       });
            });
    };
    CHECK (message ([] (PlayedRecording& r) { r.signals (0, 5) = std::numeric_limits<double>::quiet_NaN(); })
           == "recordings: need a finite signal of every sensor, as long as the voltages");
    CHECK (message ([] (PlayedRecording& r) { r.signals.conservativeResize (2, Eigen::NoChange); })
           == "recordings: need a finite signal of every sensor, as long as the voltages");
    CHECK (message ([] (PlayedRecording& r) { r.noise.setZero(); })
           == "recordings: need noise above 0, a sample rate above 0 and a delay of 0 or more");
}
