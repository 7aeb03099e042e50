#include "Support/SineBeam.h"

#include <antinode_focus/SpillOver.h>
#include <antinode_learning/PlayedRecording.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

using namespace antinode;

namespace
{
/** One voltage and one signal, both a sine of this frequency that rises and falls once. */
PlayedRecording burst (double frequency, double rate, double delay = 0, Eigen::Index samples = 9600)
{
    PlayedRecording recording { rate, Eigen::MatrixXd (1, samples), {}, Eigen::VectorXd::Constant (1, 0.01), delay };

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        const auto share = static_cast<double> (n) / static_cast<double> (samples);
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
    // Known to 2885 Hz, modelled to 11540 Hz. Every sixth sample of 48 kHz, or second of 16 kHz, holds 3200 Hz.
    const WideModel model { test::sineBeam (10, 5), 5, {} };

    for (const auto& [rate, step] : { std::pair (48000.0, 6), { 16000.0, 2 } })
    {
        CAPTURE (rate);
        constexpr double held = 3200;
        constexpr Eigen::Index samples = 48000;
        const auto before = burst (2885, rate, 0.003, samples);
        const auto after = withinModel (before, model);
        CHECK (after.sampleRate == Approx (rate / step));
        CHECK (after.delay == before.delay);
        CHECK (after.delaySpan == before.delaySpan);
        CHECK (after.bandShare == Approx (2 * (1 + 0.25 * 3 / 8) * held / after.sampleRate));
        const auto silence = static_cast<Eigen::Index> (std::ceil (8 * rate / (0.25 * held)));
        CHECK (after.voltages.cols() == (samples + silence) / step);
        CHECK (after.signals.leftCols (silence / step / 2).cwiseAbs().maxCoeff() < 1e-4);
        CHECK (after.voltages.norm() * std::sqrt (step) == Approx (before.voltages.norm()).epsilon (1e-3));
        CHECK (withinModel (burst (1.26 * held, rate, 0, samples), model).signals.norm()
               < 1e-2 * before.signals.norm());
    }
}

TEST_CASE ("Short recordings, and those of a low rate, keep it", "[learning]")
{
    // 9600 samples are not thinned: the last 128 are lost, whatever the rate.
    const WideModel model { test::sineBeam (10, 5), 5, {} };
    const auto brief = withinModel (burst (2885, 48000), model);
    CHECK (brief.sampleRate == 48000);
    // .8 of 11540 Hz; there is nothing from there on.
    CHECK (brief.bandShare == Approx (2 * (1 + 0.25 * 3 / 8) * 0.8 * 11540 / 48000).epsilon (1e-3));
    CHECK (rms (withinModel (burst (11600, 48000), model).signals) < 0.02);

    const auto slow = burst (2885, 7000);
    CHECK (withinModel (slow, model).signals == slow.signals);
    CHECK (withinModel (slow, model).bandShare == 1);
}

TEST_CASE ("A device without modes beyond the known ones is heard up to the highest, and not where others follow",
           "[learning]")
{
    const WideModel model { test::sineBeam (5, 5), 5, {} }; // to 2885 Hz
    const auto heard = [&] (double share)
    { return rms (withinModel (burst (share * 2885, 48000, 0, 48000), model).voltages); };
    const auto whole = heard (0.5);
    CHECK (heard (0.96) == Approx (whole).epsilon (0.01));
    CHECK (heard (1.025) == Approx (whole / 2).epsilon (0.05));
    CHECK (heard (1.07) < 0.02 * whole);
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
