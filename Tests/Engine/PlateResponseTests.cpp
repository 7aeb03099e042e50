#include "EngineFixtures.h"

#include <antinode_engine/PlateModel.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Quadrature.h>

#include <Support/AdaptiveOde.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr auto pi = std::numbers::pi;
using Force = std::function<double (double)>;

/** q and q' of a mode at `to`, at rest at `from`, under a force per time, by an adaptive solution that knows no
    samples. */
Eigen::VectorXd adaptiveResponse (double omega, double xi, const Force& force, double from, double to,
                                  const std::vector<double>& breakPoints = {})
{
    const auto derivative = [&] (double time, const Eigen::VectorXd& y)
    { return Eigen::VectorXd (Eigen::Vector2d (y[1], force (time) - 2 * xi * omega * y[1] - omega * omega * y[0])); };
    return integrateOde (derivative, Eigen::Vector2d::Zero(), from, to, 1e-13, breakPoints);
}

/** What a plate model says of one mode of participation 1 at the time of the last sample less its latency. */
Eigen::Vector2d sampledResponse (const ModalModel& model, Playback playback, const Eigen::RowVectorXd& samples)
{
    PlateModel plate (model, playback, Eigen::MatrixXd (0, 1));
    Eigen::MatrixXd none (0, samples.size());
    plate.process (samples, none);
    return { plate.modalDisplacements()[0], plate.modalVelocities()[0] };
}

ModalModel oneMode (double frequency, double qualityFactor)
{
    return modelWithModes ({ frequency }, qualityFactor, Eigen::MatrixXd::Ones (1, 1));
}

/** How far a mode's velocity (or omega times displacement, if more) is off under a tone of force 1 with a smooth
   envelope, and how fast it moves, both in the middle of the envelope. */
std::pair<double, double> smoothToneError (double mode, double qualityFactor, double tone, double rate)
{
    // A Gaussian envelope of 4 ms: its own band is narrow, so that all of the force lies in the pass band.
    const auto width = 4e-3, centre = 6.5 * width, omega = 2 * pi * tone;
    const auto force = [=] (double time)
    {
        const auto u = (time - centre) / width;
        return std::exp (-u * u / 2) * std::cos (omega * time + 0.3);
    };
    const auto model = oneMode (mode, qualityFactor);
    const auto modal = model.angularFrequencies[0];
    const auto shown = static_cast<Eigen::Index> (centre * rate);
    Eigen::RowVectorXd samples (shown + kaiserSincHalfWidth);
    for (Eigen::Index n = 0; n < samples.size(); ++n)
        samples[n] = force (static_cast<double> (n) / rate);

    const auto exact = adaptiveResponse (modal, 0.5 / qualityFactor, force, 0, static_cast<double> (shown) / rate);
    const auto response = sampledResponse (model, { Reconstruction::bandLimited, rate }, samples);
    return { std::max (std::abs (response[1] - exact[1]), modal * std::abs (response[0] - exact[0])),
             std::hypot (exact[1], modal * exact[0]) };
}
} // namespace

TEST_CASE ("the response to held voltages is that of an adaptive solution to 1e-11, beyond the Nyquist frequency too")
{
    const auto rate = 48e3;
    const Eigen::RowVectorXd samples = Draws (11).matrix (1, 240);
    std::vector<double> steps;
    for (int n = 1; n < 240; ++n)
        steps.push_back (n / rate);
    const auto held = [&] (double time)
    { return samples[std::min<Eigen::Index> (239, static_cast<Eigen::Index> (std::floor (time * rate + 1e-6)))]; };

    for (const auto frequency : { 963.0, 5719.0, 30.9e3, 100e3 })
    {
        const auto model = oneMode (frequency, 47);
        // The state of sample n is that before it acts: with 240 samples the last instant is 239 / rate.
        const auto exact = adaptiveResponse (model.angularFrequencies[0], 0.5 / 47, held, 0, 239 / rate, steps);
        const auto response = sampledResponse (model, { Reconstruction::zeroOrderHold, rate }, samples);
        const auto omega = model.angularFrequencies[0];
        const auto amplitude = std::hypot (exact[1], omega * exact[0]);
        INFO (frequency << " Hz: " << std::abs (response[1] - exact[1]) / amplitude);
        CHECK (std::abs (response[1] - exact[1]) < 1e-11 * amplitude);
        CHECK (std::abs (response[0] - exact[0]) * omega < 1e-11 * amplitude);
    }
}

TEST_CASE (
    "the response to interpolated voltages is that of an adaptive solution to 1e-11, beyond the Nyquist frequency too")
{
    const auto rate = 48e3;
    const Eigen::RowVectorXd samples = Draws (12).matrix (1, 60);
    const auto interpolated = [&] (double time)
    {
        double sum = 0;
        const auto nearest = static_cast<int> (std::floor (time * rate));
        for (int n = std::max (0, nearest - kaiserSincHalfWidth); n < std::min (60, nearest + kaiserSincHalfWidth + 2);
             ++n)
            sum += samples[n] * kaiserSinc (time * rate - n);
        return sum;
    };
    std::vector<double> grid; // the windows end at samples, with a corner of 1e-5
    for (int n = -15; n < 45; ++n)
        grid.push_back (n / rate);

    for (const auto frequency : { 963.0, 5719.0, 30.9e3, 100e3, 300e3 })
    {
        const auto model = oneMode (frequency, 47);
        const auto exact =
            adaptiveResponse (model.angularFrequencies[0], 0.5 / 47, interpolated, -16 / rate, 44 / rate, grid);
        const auto response = sampledResponse (model, { Reconstruction::bandLimited, rate }, samples);
        const auto omega = model.angularFrequencies[0];
        const auto amplitude = std::hypot (exact[1], omega * exact[0]);
        INFO (frequency << " Hz: " << std::abs (response[1] - exact[1]) / amplitude);
        CHECK (std::abs (response[1] - exact[1]) < 1e-11 * amplitude);
        CHECK (std::abs (response[0] - exact[0]) * omega < 1e-11 * amplitude);
    }
}

TEST_CASE ("smooth forces up to 0.7 of the Nyquist frequency act as their continuous waveform to 2e-6")
{
    for (const auto rate : { 48e3, 96e3, 192e3, 384e3, 1.3e6 })
    {
        // Mode and tone in Hz; 16.8 kHz is 0.7 of the Nyquist frequency of 48 kHz.
        for (const auto& [mode, tone] : std::vector<std::pair<double, double>> {
                 { 963, 963 }, { 5719, 5600 }, { 16.8e3, 16.8e3 }, { 13e3, 16.8e3 } })
        {
            const auto [error, velocity] = smoothToneError (mode, 30, tone, rate);
            INFO (rate << " Hz, mode " << mode << " Hz, tone " << tone << " Hz: " << error / velocity);
            CHECK (error < kaiserSincPassBandError * velocity);
        }
    }
}

TEST_CASE (
    "an image on the resonance of a mode beyond the Nyquist frequency moves it by less than 2e-6 of that resonance")
{
    // At 48 kHz the first image of 16.8 kHz lies at 31.2 kHz.
    const auto qualityFactor = 30.0;
    const auto [error, velocity] = smoothToneError (31.2e3, qualityFactor, 16.8e3, 48e3);
    const auto resonance = qualityFactor / (2 * pi * 31.2e3); // |H (j omega)| for the velocity
    INFO (error / resonance << " of the resonance, " << error / velocity << " of the response");
    CHECK (error < kaiserSincPassBandError * resonance);
    CHECK (error > 0);
}

TEST_CASE ("a steady tone moves a mode by H (j omega) in gain and phase")
{
    const auto rate = 192e3;
    const std::complex<double> j (0, 1);
    for (const auto part : { 0.01, 0.1, 0.3, 0.5, 0.7, kaiserSincPassBand })
    {
        const auto omega = part * pi * rate;
        const auto model = oneMode (0.9 * omega / (2 * pi), 4);
        const auto modal = model.angularFrequencies[0];
        const auto mobility = j * omega / (modal * modal - omega * omega + j * (omega * modal / 4));

        PlateModel plate (model, { Reconstruction::bandLimited, rate }, Eigen::MatrixXd::Ones (1, 1));
        const Eigen::Index settled = 10000; // 15 e-folds at the lowest tone
        Eigen::MatrixXd voltages (1, settled + 100), velocities (1, settled + 100);
        for (Eigen::Index n = 0; n < voltages.cols(); ++n)
            voltages (0, n) = std::cos (omega * static_cast<double> (n) / rate);
        plate.process (voltages, velocities);

        double worst = 0;
        for (Eigen::Index n = settled; n < voltages.cols(); ++n)
        {
            const auto time = static_cast<double> (n - plate.latencySamples()) / rate;
            const auto wanted = (mobility * std::exp (j * omega * time)).real();
            worst = std::max (worst, std::abs (velocities (0, n) - wanted) / std::abs (mobility));
        }
        INFO ("tone at " << part << " of the Nyquist frequency: " << worst);
        CHECK (worst < kaiserSincPassBandError);
    }
}

TEST_CASE ("the interpolation is 1 at its sample, 0 at the others, and ends after 16")
{
    CHECK (kaiserSinc (0) == 1);
    for (int n = 1; n <= kaiserSincHalfWidth + 3; ++n)
    {
        CHECK (kaiserSinc (n) == 0);
        CHECK (kaiserSinc (-n) == 0);
        CHECK (kaiserSinc (n - 0.4) == kaiserSinc (0.4 - n));
    }
    // Kaiser's formula with the standard library's Bessel function instead of the series
    CHECK (kaiserSinc (0.5)
           == Approx (2 / pi * std::cyl_bessel_i (0.0, 12 * std::sqrt (1 - 1.0 / 1024)) / std::cyl_bessel_i (0.0, 12.0))
                  .epsilon (1e-12));
}

TEST_CASE ("in its pass band the interpolation has a gain of 1 and no images, both to 2e-6, and half the gain at the "
           "Nyquist frequency")
{
    const auto quadrature = gaussLegendre (24, kaiserSincHalfWidth);
    const Eigen::ArrayXd x = kaiserSincHalfWidth * quadrature.nodes.array();
    const Eigen::ArrayXd weighted = 2 * kaiserSincHalfWidth * quadrature.weights.array()
                                    * x.unaryExpr ([] (double place) { return kaiserSinc (place); });
    const auto gain = [&] (double w) { return (weighted * (w * x).cos()).sum(); }; // w in rad per sample

    for (int i = 0; i <= 300; ++i)
    {
        const auto w = pi * kaiserSincPassBand * i / 300;
        INFO (w / pi << " of the Nyquist frequency: gain - 1 = " << gain (w) - 1 << ", image " << gain (2 * pi - w));
        CHECK (std::abs (gain (w) - 1) < kaiserSincPassBandError);
        for (const auto image : { 2 * pi - w, 2 * pi + w, 4 * pi - w, 4 * pi + w })
            CHECK (std::abs (gain (image)) < kaiserSincPassBandError);
    }
    CHECK (gain (pi) == Approx (0.5).margin (1e-3));
}
