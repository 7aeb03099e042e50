#include <antinode_base/InputError.h>
#include <antinode_reports/FocusCharts.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double rate = 48000;

Eigen::VectorXd tone (Eigen::Index samples, double frequency, double amplitude)
{
    return Eigen::VectorXd::NullaryExpr (
        samples, [=] (Eigen::Index k)
        { return amplitude * std::sin (2 * std::numbers::pi * frequency * static_cast<double> (k) / rate); });
}
} // namespace

TEST_CASE ("The spectrogram of a tone peaks at its frequency with its amplitude")
{
    for (const auto frequency : { 963.0, 3907.0, 5719.0, 12011.0 })
    {
        SpectrogramSettings settings;
        settings.reference = 1;
        const auto result = spectrogram (tone (9600, frequency, 0.1), rate, settings);
        const auto middle = result.decibels.cols() / 2;
        Eigen::Index row = 0;
        const auto level = result.decibels.col (middle).maxCoeff (&row);
        const auto spacing = result.frequencies[1] - result.frequencies[0];
        CHECK (std::abs (result.frequencies[row] - frequency) <= spacing / 2);
        CHECK (level <= -20 + 0.01);
        CHECK (level >= -20 - 0.4);
    }
}

TEST_CASE ("A burst is found in time to within half a window, and silence lies on the floor")
{
    Eigen::VectorXd signal = Eigen::VectorXd::Zero (9600);
    signal.segment (4800, 48) = tone (48, 5000, 1);
    SpectrogramSettings settings;
    settings.windowDuration = 4e-3;
    settings.columns = 201;
    const auto result = spectrogram (signal, rate, settings);
    const auto centre = (4800 + 24) / rate;
    for (Eigen::Index column = 0; column < result.times.size(); ++column)
    {
        const auto loudest = result.decibels.col (column).maxCoeff();
        if (std::abs (result.times[column] - centre) > settings.windowDuration / 2 + 25 / rate)
            CHECK (loudest == settings.floorDecibels);
    }
    Eigen::Index row = 0, column = 0;
    CHECK (result.decibels.maxCoeff (&row, &column) == Approx (0).margin (1e-12));
    CHECK (std::abs (result.times[column] - centre) < 6e-4);
}

TEST_CASE ("Two tones 2 / window apart are told apart")
{
    SpectrogramSettings settings;
    const auto apart = 2 / settings.windowDuration;
    const auto result = spectrogram (tone (9600, 4000, 1) + tone (9600, 4000 + apart, 1), rate, settings);
    const auto spacing = result.frequencies[1];
    const auto at = [&] (double frequency)
    { return result.decibels.row (std::lround (frequency / spacing)).segment (100, 200).mean(); };
    CHECK (at (4000) > at (4000 + apart / 2) + 3);
    CHECK (at (4000 + apart) > at (4000 + apart / 2) + 3);
}

TEST_CASE ("A constant reads its value at frequency 0")
{
    SpectrogramSettings settings;
    settings.reference = 1;
    const auto result = spectrogram (Eigen::VectorXd::Constant (9600, 0.5), rate, settings);
    CHECK (result.decibels (0, 200) == Approx (20 * std::log10 (0.5)).margin (1e-9));
}

TEST_CASE ("Times span the signal, frequencies end where asked")
{
    SpectrogramSettings settings;
    settings.columns = 11;
    settings.maximumFrequency = 6000;
    const auto result = spectrogram (tone (4801, 1000, 1), rate, settings);
    CHECK (result.times.size() == 11);
    CHECK (result.times[0] == 0);
    CHECK (result.times[10] == Approx (0.1));
    CHECK (result.frequencies[result.frequencies.size() - 1] <= 6000);
    CHECK (result.frequencies[result.frequencies.size() - 1] > 5900);
    CHECK (result.decibels.rows() == result.frequencies.size());
    CHECK (result.decibels.cols() == 11);
}

TEST_CASE ("Silence, no samples and samples that are not finite give finite levels")
{
    auto broken = tone (2000, 1000, 1);
    broken[500] = std::nan ("");
    broken[700] = INFINITY;
    for (const Eigen::VectorXd& signal : { Eigen::VectorXd (Eigen::VectorXd::Zero (100)), Eigen::VectorXd(), broken })
    {
        const auto result = spectrogram (signal, rate);
        CHECK (result.decibels.allFinite());
        CHECK (result.decibels.minCoeff() >= -80);
        CHECK (result.decibels.maxCoeff() <= 0);
    }
}

TEST_CASE ("Settings that are not usable are bad input")
{
    const auto refuses = [] (auto alter, double sampleRate)
    {
        SpectrogramSettings settings;
        alter (settings);
        CHECK_THROWS_AS (spectrogram (Eigen::VectorXd::Zero (100), sampleRate, settings), InputError);
    };
    refuses ([] (auto&) {}, 0);
    refuses ([] (auto&) {}, std::nan (""));
    refuses ([] (auto& s) { s.windowDuration = 0; }, rate);
    refuses ([] (auto& s) { s.windowDuration = INFINITY; }, rate);
    refuses ([] (auto& s) { s.columns = 0; }, rate);
    refuses ([] (auto& s) { s.floorDecibels = 0; }, rate);
    refuses ([] (auto& s) { s.reference = -1; }, rate);
    refuses ([] (auto& s) { s.maximumFrequency = std::nan (""); }, rate);
}
