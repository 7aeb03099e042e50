#include "Support/ErrorText.h"

#include <antinode_fingers/Sensation.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_tracks/TrackWork.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double pi = std::numbers::pi;

SkinThreshold flatThreshold()
{
    return { "flat", Eigen::Vector2d (50, 1000), Eigen::Vector2d (1e-7, 1e-7) };
}

/** The share of a signal's energy outside a band. */
double energyOutside (const Eigen::VectorXd& signal, double rate, TrackBand band)
{
    const auto length = quickLength (2 * static_cast<double> (signal.size()));
    const Eigen::VectorXd energies = forwardFourier (signal, length).cwiseAbs2();
    double outside = 0;

    for (Eigen::Index k = 0; k < energies.size(); ++k)
        if (const auto f = static_cast<double> (k) * rate / static_cast<double> (length);
            f < band.lower || f > band.upper)
            outside += energies[k];

    return outside / energies.sum();
}

WaveformsDescription oneTrack (const TrackSignal& signal, const TrackLevel& level)
{
    WaveformsDescription description;
    auto& track = description.tracks.emplace_back();
    track.events[0].signal = signal;
    track.events[0].level = level;
    track.events[0].start = 0.01;
    return description;
}
} // namespace

TEST_CASE ("Built-in signals begin and end at rest and lie in the band", "[tracks]")
{
    constexpr double rate = 6000;
    const TrackBand band;
    const auto check = [&] (const TrackSignal& signal)
    {
        const auto samples = signalSamples (signal, band, rate);
        const auto peak = samples.cwiseAbs().maxCoeff();
        CHECK (static_cast<double> (samples.size() - 1) / rate >= signalDuration (signal) - 1e-9);
        CHECK (std::abs (samples[0]) < 1e-5 * peak);
        CHECK (std::abs (samples[samples.size() - 1]) < 1e-5 * peak);
        CHECK (energyOutside (samples, rate, band) < 1e-2);
    };
    check (ClickSignal {});
    check (GaborSignal {});
    check (ToneSignal { 250, 0.3, 0.02, 25, 1 });
    check (NoiseSignal {});
    CHECK (signalSamples (NoiseSignal {}, band, rate) == signalSamples (NoiseSignal {}, band, rate));
    CHECK (signalSamples (NoiseSignal { 0.3, 0.02, 2 }, band, rate) != signalSamples (NoiseSignal {}, band, rate));
}

TEST_CASE ("A recording keeps what is in the band, at any rate, and loses what is not", "[tracks]")
{
    for (const double recorded : { 4800.0, 44100.0 })
    {
        SampledSignal signal { "tone.wav", recorded, Eigen::VectorXd (static_cast<Eigen::Index> (recorded * 0.2)) };

        for (Eigen::Index n = 0; n < signal.samples.size(); ++n)
        {
            const auto time = static_cast<double> (n) / recorded;
            signal.samples[n] = std::sin (2 * pi * 300 * time) + 0.5 + std::sin (2 * pi * 1600 * time);
        }

        const auto samples = signalSamples (signal, {}, 6000);

        // Away from both ends only the tone is left.
        for (const Eigen::Index n : { 400, 437, 600, 711, 800 })
            CHECK (samples[n] == Approx (std::sin (2 * pi * 300 * static_cast<double> (n) / 6000)).margin (0.02));

        CHECK (std::abs (samples[0]) < 1e-12);
    }
}

TEST_CASE ("Levels are those of displacement, velocity and sensation", "[tracks]")
{
    constexpr double rate = 12000;
    const ToneSignal tone { 250, 0.4, 0.02, 0, 1 };
    const auto peakOf = [&] (LevelKind kind, double value) {
        return wantedMotion (oneTrack (tone, { kind, value }), flatThreshold(), rate).cwiseAbs().maxCoeff();
    };
    CHECK (peakOf (LevelKind::displacement, 5e-6) == Approx (5e-6).epsilon (2e-3));
    CHECK (peakOf (LevelKind::velocity, 0.01) == Approx (0.01 / (2 * pi * 250)).epsilon (2e-3));

    // A tone of ten thresholds is felt at 20 dB.
    CHECK (peakOf (LevelKind::sensation, 20) == Approx (1e-6).epsilon (5e-3));
    const auto motion = wantedMotion (oneTrack (tone, {}), flatThreshold(), rate);
    CHECK (motion.topRows (120).isZero());
    CHECK (motion (150, 0) != 0);
}

TEST_CASE ("A track is the sum of its events, each with its share of its level", "[tracks]")
{
    constexpr double rate = 12000;
    const ToneSignal tone { 250, 0.1, 0.02, 0, 1 };
    const auto single = wantedMotion (oneTrack (tone, {}), flatThreshold(), rate);
    auto description = oneTrack (tone, {});
    auto& events = description.tracks[0].events;
    events.push_back (events[0]);
    events[1].amplitude = 0.5;
    events[1].start = 0.06;
    const auto both = wantedMotion (description, flatThreshold(), rate);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero (both.rows());
    sum.head (single.rows()) = single.col (0);
    sum.tail (single.rows()) += 0.5 * single.col (0); // The second one begins 50 ms after the first: 600 samples.
    REQUIRE (both.rows() == single.rows() + 600);
    CHECK ((both.col (0) - sum).cwiseAbs().maxCoeff() < 1e-15);

    // What is wrong is told with the number of the event.
    events[1].signal = ToneSignal { 2000, 0.1, 0.02, 0, 1 };
    CHECK (errorText ([&] { wantedMotion (description, flatThreshold(), rate); })
           == "waveforms: track 1 event 2 frequency: is 2000 Hz; allowed: the band, 40 to 1000 Hz");
}

TEST_CASE ("Interpolated voltages are the tone that their samples stand for", "[tracks]")
{
    Eigen::MatrixXd tone (200, 1);

    for (Eigen::Index n = 0; n < tone.rows(); ++n)
        tone (n, 0) = std::sin (0.9 * static_cast<double> (n));

    const auto finer = interpolated (tone, 8);
    REQUIRE (finer.rows() == (199 + 32) * 8 + 1);

    for (Eigen::Index n = 48 * 8; n < 150 * 8; ++n)
        CHECK (std::abs (finer (n, 0) - std::sin (0.9 * (static_cast<double> (n) / 8 - 16))) < 5e-6);
}
