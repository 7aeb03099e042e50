#include "Support/AllocationCount.h"

#include <Standalone/AudioPanel.h>
#include <Standalone/StandaloneHost.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <thread>

using namespace antinode;

namespace
{
constexpr double rate = 96000;

std::vector<float> sine (double frequency, double amplitude, Eigen::Index samples)
{
    std::vector<float> values (static_cast<std::size_t> (samples));

    for (std::size_t n = 0; n < values.size(); ++n)
        values[n] = static_cast<float> (amplitude
                                        * std::sin (2 * std::numbers::pi * frequency * static_cast<double> (n) / rate));

    return values;
}

Eigen::VectorXd spectrumOf (const std::vector<float>& samples)
{
    InputSpectrum spectrum;
    spectrum.prepare (rate);
    spectrum.add (samples);
    return spectrum.levels();
}
} // namespace

TEST_CASE ("a sine's line in the input's spectrum is its amplitude, between lines at most 1.43 dB less")
{
    InputSpectrum spectrum;
    spectrum.prepare (rate);
    CHECK (spectrum.levels().size() == 0);
    const auto onLine = spectrum.lineFrequency (300);
    CHECK (spectrumOf (sine (onLine, 0.1, 60000))[300] == Approx (-20).margin (1e-3));
    // Harris, Proc. IEEE 66, 1978: the scalloping loss of a Hann window is 1.42 dB.
    const auto between = spectrumOf (sine (spectrum.lineFrequency (300) + spectrum.lineFrequency (1) / 2, 0.1, 60000));
    CHECK (between[300] == Approx (-21.42).margin (0.02));
    CHECK (between[301] == Approx (-21.42).margin (0.02));
    CHECK (between[2000] < -120);
}

TEST_CASE ("white noise of a known power has its level in the input's spectrum")
{
    std::mt19937 generator (7);
    std::normal_distribution<float> normal (0, 0.01F);
    std::vector<float> samples (400000);

    for (auto& sample : samples)
        sample = normal (generator);

    const auto levels = spectrumOf (samples);
    const double mean =
        levels.segment (100, 8000).array().unaryExpr ([] (double level) { return std::pow (10, level / 10); }).mean();
    // Variance times the sum of the squared window: 6 / N.
    CHECK (mean == Approx (1e-4 * 6 / static_cast<double> (InputSpectrum::block)).epsilon (0.05));
}

TEST_CASE (
    "the tap of an input gives its samples in order, counts what clips, and asks for nothing on the audio thread")
{
    auto tap = std::make_unique<InputTap>();
    auto samples = sine (997, 0.5, 5000);
    samples[100] = 1.0F;
    samples[101] = -1.0F;
    samples[200] = std::numeric_limits<float>::quiet_NaN();
    const auto allocations = test::mallocCalls(), locks = test::lockCalls();

    for (int first = 0; first < 5000; first += 250)
        tap->write (samples.data() + first, 250);

    CHECK (test::mallocCalls() == allocations);
    CHECK (test::lockCalls() == locks);
    samples[200] = 0;
    CHECK (tap->take() == samples);
    CHECK (tap->take().empty());
    CHECK (tap->takePeak() == 1);
    CHECK (tap->takePeak() == 0);
    CHECK (tap->clippedSamples() == 2);

    // Without a reader the newest are left out, but none of those that clip is lost.
    const std::vector<float> full (1000, 1);

    for (int i = 0; i < 100; ++i)
        tap->write (full.data(), 1000);

    CHECK (tap->take().size() == 1 << 16);
    CHECK (tap->clippedSamples() == 100002);
}

TEST_CASE ("what the tap writes on one thread another one reads without a gap")
{
    auto tap = std::make_unique<InputTap>();
    constexpr int blocks = 400, length = 128;
    std::thread audio (
        [&tap]
        {
            for (int block = 0; block < blocks; ++block)
            {
                std::array<float, length> samples {};

                for (int n = 0; n < length; ++n)
                    samples[static_cast<std::size_t> (n)] = static_cast<float> (block * length + n) / (blocks * length);

                tap->write (samples.data(), length);
            }
        });
    std::vector<float> read;

    while (read.size() < blocks * length)
        for (const auto sample : tap->take())
            read.push_back (sample);

    audio.join();

    for (std::size_t n = 0; n < read.size(); ++n)
        REQUIRE (read[n] == static_cast<float> (n) / (blocks * length));
}

TEST_CASE ("without an input the view says what to choose")
{
    StandaloneHost host (SettingsFile ({}), false);
    InputView view (host);
    CHECK (view.words().contains ("choose the input of the sensor"));
}

TEST_CASE ("the view names the open input, its peak, the strongest line and what clipped since it was opened")
{
    StandaloneHost host (SettingsFile ({}), false);
    InputView view (host);
    juce::BigInteger inputs;
    inputs.setBit (2);
    host.callback().prepare (rate, 256, {}, inputs);
    view.refresh();
    const auto heard = sine (300 * rate / static_cast<double> (InputSpectrum::block), 0.1, 40000);
    host.callback().input().write (heard.data(), static_cast<int> (heard.size()));
    view.refresh();
    CHECK (view.words() == "Input 3: peak -20.0 dB of full scale; strongest at 1758 Hz, -20.0 dB");
    const std::vector<float> clipped (3, 1);
    host.callback().input().write (clipped.data(), 3);
    view.refresh();
    CHECK (view.words().contains ("CLIPPED, 3 samples"));
    host.callback().audioDeviceStopped();
    view.refresh();
    CHECK (view.words().contains ("No input is open"));
}
