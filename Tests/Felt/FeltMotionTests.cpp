#include <antinode_fingers/Sensation.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double pi = std::numbers::pi;

SkinThreshold octaves()
{
    SkinThreshold threshold { "octaves", Eigen::VectorXd (3), Eigen::VectorXd (3) };
    threshold.frequencies << 125, 250, 500;
    threshold.displacements << 0.4e-6, 0.1e-6, 0.4e-6;
    return threshold;
}

ModalModel oneMode (double frequency, double damping)
{
    ModalModel model;
    model.angularFrequencies = Eigen::VectorXd::Constant (1, 2 * pi * frequency);
    model.dampingRatios = Eigen::VectorXd::Constant (1, damping);
    return model;
}

/** Of a velocity e^(p t) sin from 0 to infinity, whose spectrum is known: the weighted displacement at one time, by the
    integral over frequency in small steps. */
double weightedDecay (const ModalModel& model, double time)
{
    const std::complex<double> pole (-decayRates (model)[0], dampedFrequencies (model)[0]);
    const auto threshold = octaves();
    constexpr double step = 0.25; // Hz
    std::complex<double> sum = 0;

    for (double f = step; f < 6000; f += step)
    {
        const std::complex<double> jw (0, 2 * pi * f);
        const auto spectrum = (1.0 / (jw - pole) - 1.0 / (jw - std::conj (pole))) / std::complex (0.0, 2.0);
        sum += spectrum / jw / thresholdAt (threshold, f) * std::exp (jw * time);
    }

    return 2 * step * sum.real();
}
} // namespace

TEST_CASE ("A threshold is straight between its numbers in logarithms, and rises by 24 dB an octave beyond", "[felt]")
{
    const auto threshold = octaves();
    CHECK (thresholdAt (threshold, 250) == Approx (0.1e-6));
    CHECK (thresholdAt (threshold, 125 * std::sqrt (2.0)) == Approx (0.2e-6));
    CHECK (thresholdAt (threshold, 62.5) == Approx (6.4e-6));
    CHECK (thresholdAt (threshold, 1000) == Approx (6.4e-6));
}

TEST_CASE ("A threshold that descends or is not positive is refused", "[felt]")
{
    auto threshold = octaves();
    threshold.frequencies[2] = 250;
    CHECK_THROWS_WITH (validate (threshold), Catch::Contains ("row 3") && Catch::Contains ("ascending"));
    threshold = octaves();
    threshold.displacements[1] = 0;
    CHECK_THROWS_WITH (validate (threshold), Catch::Contains ("250 Hz") && Catch::Contains ("above 0"));
}

TEST_CASE ("A tone of ten thresholds is felt at 20 dB, at any rate", "[felt]")
{
    for (const auto rate : { 44100.0, 192000.0 })
    {
        const auto samples = static_cast<Eigen::Index> (0.6 * rate);
        Eigen::MatrixXd velocities (1, samples);

        for (Eigen::Index n = 0; n < samples; ++n)
        {
            const auto t = static_cast<double> (n) / rate;
            velocities (0, n) = 1e-6 * 2 * pi * 250 * std::sin (2 * pi * 250 * t) * std::min (1.0, t / 0.1);
        }

        const auto felt = feltMotion (oneMode (250, 0.01), velocities, rate, octaves());
        CHECK (felt.sampleRate >= 8000);
        CHECK (felt.sampleRate < 16000);
        CHECK (sensationLevel (feltAmount (felt.modal.row (0), felt.sampleRate)) == Approx (20).margin (0.1));
    }
}

TEST_CASE ("Of a decay that is recorded for 20 ms, all is weighed", "[felt]")
{
    constexpr double rate = 96000;
    const auto model = oneMode (300, 0.02);
    const auto decay = decayRates (model)[0], frequency = dampedFrequencies (model)[0];
    Eigen::MatrixXd velocities (1, static_cast<Eigen::Index> (0.02 * rate));

    for (Eigen::Index n = 0; n < velocities.cols(); ++n)
    {
        const auto t = static_cast<double> (n) / rate;
        velocities (0, n) = std::exp (-decay * t) * std::sin (frequency * t);
    }

    const auto felt = feltMotion (model, velocities, rate, octaves());
    const auto peak = felt.modal.cwiseAbs().maxCoeff();

    for (const auto time : { 0.001, 0.004, 0.0125, 0.05, 0.1 })
    {
        const auto n = static_cast<Eigen::Index> (std::lround (time * felt.sampleRate));
        CHECK (std::abs (felt.modal (0, n) - weightedDecay (model, static_cast<double> (n) / felt.sampleRate))
               < 2e-3 * peak);
    }
}

TEST_CASE ("A click is felt by its peak, a long tone by its RMS within 100 ms", "[felt]")
{
    Eigen::RowVectorXd click = Eigen::RowVectorXd::Zero (4000);
    click[100] = -3;
    CHECK (feltAmount (click, 8000) == Approx (3));

    Eigen::RowVectorXd tone (4000);

    for (Eigen::Index n = 0; n < tone.size(); ++n)
        tone[n] = 3 * std::sin (2 * pi * 240 * static_cast<double> (n) / 8000 + 0.3);

    CHECK (feltAmount (tone, 8000) == Approx (3).epsilon (1e-3));
    CHECK (sensationLevel (0) == -120);
}
