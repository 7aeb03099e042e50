#include "Support/ErrorText.h"
#include "Support/SinePlate.h"

#include <antinode_numerics/Statistics.h>
#include <antinode_render/PlayedTracks.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double correctedRate = 9600, heardFor = 0.4; // Hz, s

TrackSettings correctedSettings()
{
    TrackSettings settings;
    settings.sampleRate = correctedRate;
    settings.threshold = { "flat", Eigen::Vector2d (50, 1000), Eigen::Vector2d (1e-7, 1e-7) };
    return settings;
}

WaveformsDescription burstAndSilence()
{
    WaveformsDescription description;
    description.band = { 100, 800 };
    auto& track = description.tracks.emplace_back();
    track.point.x = 0.05;
    track.point.y = 0.06;
    track.events[0].signal = GaborSignal { 350, 0.01 };
    auto& silent = description.silent.emplace_back();
    silent.x = 0.14;
    silent.y = 0.1;
    return description;
}

/** The modes of a surface that differs from its model in turns: by 0.25 % of frequency, 10 % of damping, 5 % of force.
 */
ModalModel otherSurface (ModalModel model)
{
    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const auto sign = k % 2 == 0 ? 1.0 : -1.0;
        model.angularFrequencies[k] *= 1 + 0.0025 * sign;
        model.dampingRatios[k] *= 1 - 0.1 * sign;
        model.participation.row (k) *= 1 + 0.05 * sign;
    }

    return model;
}

/** A pass and the error of the worst finger without the noise of what is recorded, dB. */
struct PlayedPass
{
    RecordedPass recorded;
    double error = 0;
};

PlayedPass playedPass (const ModalModel& real, const TrackDesign& design, double noise)
{
    const auto played = playTracks (real, design.description, design.voltages, heardFor);
    const auto scores = scoreTracks (played, design.wanted, design.description.band);
    RandomNumbers random (5);
    PlayedPass pass { { design.voltages, played.displacements },
                      std::max (scores.suppression (0), scores.suppression (1)) };
    pass.recorded.displacements += noise
                                   * random.normal (played.displacements.size())
                                         .reshaped (played.displacements.rows(), played.displacements.cols());
    return pass;
}
} // namespace

TEST_CASE ("Passes that are recorded on another surface lead to what is wanted there", "[tracks][render]")
{
    const auto known = test::SinePlate().model (12);
    const auto real = otherSurface (known);
    const auto description = burstAndSilence();
    const auto settings = correctedSettings();
    const auto first = playedPass (real, designTracks (known, description, settings), 5e-9);
    CHECK (first.error > -35);
    std::vector<RecordedPass> passes { first.recorded };
    auto error = first.error;

    for (int i = 0; i < 2; ++i)
    {
        const auto correction = correctionFrom (known, description, settings, passes);
        CHECK (correction.errors.size() == passes.size());
        CHECK (correction.best == passes.size() - 1);
        CHECK (correction.gain == 1);
        const auto next = playedPass (real, designTracks (known, description, settings, {}, correction.shift), 5e-9);
        CHECK (next.error < error - 5);
        error = next.error;
        passes.push_back (next.recorded);
    }

    CHECK (error < -45);

    // A pass that was worse than the one before is not built upon, and less of the error is corrected.
    passes.push_back (passes[0]);
    const auto correction = correctionFrom (known, description, settings, passes);
    CHECK (correction.best == 2);
    CHECK (correction.gain == 0.5);
}

TEST_CASE ("A surface that does what its model says is not corrected", "[tracks][render]")
{
    const auto known = test::SinePlate().model (12);
    const auto description = burstAndSilence();
    const auto settings = correctedSettings();
    const auto design = designTracks (known, description, settings);
    const auto pass = playedPass (known, design, 0);
    const auto correction = correctionFrom (known, description, settings, { pass.recorded });
    const auto again = designTracks (known, description, settings, {}, correction.shift);
    REQUIRE (again.voltages.values.cols() == design.voltages.values.cols());
    CHECK ((again.voltages.values - design.voltages.values).norm() < 1e-2 * design.voltages.values.norm());
}

TEST_CASE ("Recorded velocities become displacements", "[tracks][render]")
{
    constexpr Eigen::Index count = 9600;
    Eigen::MatrixXd velocity (1, count), expected (1, count);

    for (Eigen::Index n = 0; n < count; ++n)
    {
        // A burst of 300 Hz, x = sin^2 (pi t / T) sin (w t), and the slow drift of a sensor, which is left out.
        const auto t = static_cast<double> (n) / correctedRate, w = 2 * std::numbers::pi * 300;
        const auto swell = std::numbers::pi * t, rise = std::sin (swell);
        expected (0, n) = rise * rise * std::sin (w * t);
        velocity (0, n) = rise * rise * w * std::cos (w * t)
                          + 2 * std::numbers::pi * rise * std::cos (swell) * std::sin (w * t)
                          + 20 * rise * std::sin (2 * swell);
    }

    const auto found = displacementsOf (velocity, correctedRate, { 100, 800 });
    CHECK ((found - expected).norm() < 0.01 * expected.norm());
}

TEST_CASE ("Recorded passes that do not belong to a design are refused", "[tracks][render]")
{
    const auto known = test::SinePlate().model (12);
    const auto description = burstAndSilence();
    const auto settings = correctedSettings();
    const auto good = playedPass (known, designTracks (known, description, settings), 0).recorded;
    const auto refusal = [&] (const RecordedPass& pass) {
        return errorText ([&] { correctionFrom (known, description, settings, { good, pass }); });
    };
    auto pass = good;
    pass.displacements.conservativeResize (1, Eigen::NoChange);
    CHECK (refusal (pass) == "recorded pass 2: has 1 channels; allowed: 2, one per finger, those with tracks first");
    pass = good;
    pass.voltages.playback.sampleRate = 4800;
    CHECK_THAT (refusal (pass), Catch::Contains ("4800 Hz") && Catch::Contains ("9600 Hz"));
    pass = good;
    pass.displacements (1, 7) = NAN;
    CHECK (refusal (pass) == "recorded pass 2: has samples that are not finite; allowed: numbers");
    pass = good;
    pass.displacements.conservativeResize (Eigen::NoChange, 20);
    CHECK_THAT (refusal (pass),
                Catch::Contains ("recorded pass 2: has 20 samples; allowed: ") && Catch::Contains ("or more"));
}
