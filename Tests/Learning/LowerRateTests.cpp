#include "Support/SineBeam.h"

#include <antinode_focus/SpillOver.h>
#include <antinode_learning/LowerRate.h>
#include <antinode_numerics/RandomNumbers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

using namespace antinode;

namespace
{
/** One voltage and one signal, both a sine of this frequency that rises and falls once. */
PlayedRecording burst (double frequency, double rate, double delay = 0)
{
    constexpr Eigen::Index samples = 9600;
    PlayedRecording recording { rate, Eigen::MatrixXd (1, samples), {}, Eigen::VectorXd::Constant (1, 0.01), delay };

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        const auto share = static_cast<double> (n) / samples;
        recording.voltages (0, n) = std::pow (std::sin (std::numbers::pi * share), 2)
                                    * std::sin (2 * std::numbers::pi * frequency * static_cast<double> (n) / rate);
    }

    recording.signals = -3 * recording.voltages;
    return recording;
}

double rms (const Eigen::MatrixXd& values)
{
    return values.norm() / std::sqrt (static_cast<double> (values.size()));
}
} // namespace

TEST_CASE ("What lies below the highest frequency stays, at the lowest rate that holds it", "[learning]")
{
    const auto before = burst (900, 48000);
    const auto after = atLowerRate (before, 1000);
    CHECK (after.sampleRate == Approx (48000.0 / 19)); // 2.5 samples for a period of 1 kHz
    CHECK (after.voltages.cols() == before.voltages.cols() / 19);
    CHECK (rms (after.voltages) == Approx (rms (before.voltages)).epsilon (1e-3));
    CHECK ((after.signals + 3 * after.voltages).cwiseAbs().maxCoeff() < 1e-12);
    CHECK (after.noise[0] == Approx (0.01 / std::sqrt (19.0)));

    // The burst itself has some 2e-5 of its amplitude above 1 kHz.
    for (Eigen::Index n = 0; n < after.voltages.cols(); ++n)
        CHECK (std::abs (after.voltages (0, n) - before.voltages (0, 19 * n)) < 5e-5);
}

TEST_CASE ("What lies above is left out, also where the rate cannot be lowered", "[learning]")
{
    for (const auto highest : { 1000.0, 8000.0, 18000.0, 20000.0 })
    {
        CAPTURE (highest);
        const auto end = std::min (1.25 * highest, 24000.0);
        CHECK (rms (atLowerRate (burst (end - 20, 48000), highest).voltages) < 0.02);
        CHECK (rms (atLowerRate (burst ((highest + end) / 2, 48000), highest).signals)
               == Approx (1.5 * 0.433).epsilon (0.02));
        CHECK (rms (atLowerRate (burst (0.97 * highest, 48000), highest).voltages) == Approx (0.433).epsilon (0.02));
    }

    CHECK (atLowerRate (burst (20000, 48000), 20000).sampleRate == 48000);
}

TEST_CASE ("A rate that does not hold the highest frequency stays as it is", "[learning]")
{
    const auto before = burst (900, 2000);
    const auto after = atLowerRate (before, 1000);
    CHECK (after.sampleRate == 2000);
    CHECK (after.voltages == before.voltages);
}

TEST_CASE ("Of a recording that is heard where a model has modes, nothing beyond them is left", "[learning]")
{
    // Known to 2885 Hz, modelled to 11540 Hz: at 48 kHz every fifth sample holds 3840 Hz, at 16 kHz every second 3200.
    const WideModel model { test::sineBeam (10, 5), 5, {} };

    for (const auto& [rate, step, held] : { std::tuple (48000.0, 6, 3200.0), { 16000.0, 2, 3200.0 } })
    {
        CAPTURE (rate);
        const auto before = burst (2885, rate, 0.003);
        const auto after = withinModel (before, model);
        CHECK (after.sampleRate == Approx (rate / step));
        CHECK (after.delay == before.delay);
        CHECK (after.delaySpan == before.delaySpan);
        CHECK (after.bandShare == Approx (2 * (1 + 0.25 * 3 / 8) * held / after.sampleRate));
        const auto silence = static_cast<Eigen::Index> (std::ceil (8 * rate / (0.25 * held)));
        CHECK (after.voltages.cols() == (before.voltages.cols() + silence) / step);
        CHECK (after.signals.leftCols (silence / step / 2).cwiseAbs().maxCoeff() < 1e-4);
        CHECK (after.voltages.norm() * std::sqrt (step) == Approx (before.voltages.norm()).epsilon (1e-3));
        CHECK (withinModel (burst (1.26 * held, rate), model).signals.norm() < 1e-2 * before.signals.norm());
    }

    const auto slow = burst (2885, 7000);
    CHECK (withinModel (slow, model).signals == slow.signals);
    CHECK (withinModel (slow, model).bandShare == 1);
}

TEST_CASE ("White noise keeps its size where a band is cut out of it", "[learning]")
{
    auto recording = burst (900, 48000);
    recording.signals = 0.01 * RandomNumbers (7).normal (recording.signals.cols()).transpose();

    for (const auto highest : { 1000.0, 8000.0, 18000.0 })
    {
        CAPTURE (highest);
        const auto after = atLowerRate (recording, highest);
        // As many independent samples as the share says, each of the noise that is said.
        CHECK (rms (after.signals) == Approx (after.noise[0] * std::sqrt (after.bandShare)).epsilon (0.1));
    }
}
