#include "EngineFixtures.h"

#include <antinode_engine/PlateModel.h>
#include <antinode_engine/VoltageSynthesiser.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Quadrature.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr auto piNumber = std::numbers::pi;
/** kappa: what a band-limited interpolation loses of a step. No unit.

    A force psi that is cut on a sample, which then gets half of its value, is smeared by the interpolation K over the
   cut. Until the cut the integral of the force is smaller by kappa T psi (T the sample interval), and as the velocity
   answers at once to an impulse, so is the modal velocity there. With the step s (t) = K (t)/2 + sum_{n < 0} K (t - n),
   T = 1,

        kappa = integral_{-inf}^0 (1 - s (t)) dt = (1/piNumber) integral_0^inf [1/w - Khat (w) cot (w/2) / 2] / w dw

    as 1 - s is odd: the sine transforms of the step and of its samples are 1/w and cot (w/2) / 2. The ideal sinc
    (Khat = 1 below piNumber, 0 above) would have (1/piNumber) [integral_0^piNumber (1/w - cot (w/2) / 2) / w dw +
   1/piNumber] = 0.190009... This is the value of the windowed sinc that the plate model plays with; a test compares
   them. Docs/Theory.md, section 6.3. */
constexpr double bandLimitedStepConstant = 0.190583570590934662;

/** The second term of the same loss, in which the interpolation does not matter: for a mode of decay rate a,

        v_bandLimited (t_f) = v (t_f) - kappa T psi (t_f-) + (T^2 / 24) (psi' (t_f-) + 2 a psi (t_f-)) + O (T^3)

    It is half of the limits for w -> 0 of 1 / (4 sin^2 (w/2)) - 1/w^2 (a corner) and of (1/w - cot (w/2) / 2) / w (the
    first moment of a step), both 1/12. Docs/Theory.md, section 6.3. */
constexpr double bandLimitedSlopeConstant = 1.0 / 24.0;

const std::vector<double> playedRates { 48e3, 96e3, 192e3, 384e3, 1.3e6 };

/** A mode under a force that has grown by e^34 when it is cut at the focus: all of its past, so that the closed form is
    short. */
struct CutForce
{
    double modal = 0, decay = 0;       // omega_k, rad/s, and a_k, 1/s
    std::complex<double> phasor, rate; // psi (t) = Re[phasor e^{rate (t - t_f)}]

    double force() const { return phasor.real(); }
    double slope() const { return (phasor * rate).real(); }
    double velocity() const { return (phasor * rate / (rate * rate + 2 * decay * rate + modal * modal)).real(); }
};

/** What the plate model says of the mode's velocity at the focus when synthesiser and plate run at this rate. */
double playedVelocity (const CutForce& cut, double sampleRate)
{
    const auto duration = 34 / cut.rate.real();
    const auto atStart = cut.phasor * std::exp (-cut.rate * duration);
    VoltageProgram program;
    program.focusTime = duration + 1e-3;
    program.oscillations = { { 0, 1e-3, program.focusTime, cut.rate.real(), cut.rate.imag(), -atStart.imag(),
                               atStart.real() } };
    program.allocation = Eigen::MatrixXd::Ones (1, 1);

    auto model =
        modelWithModes ({ cut.modal / (2 * piNumber) }, cut.modal / (2 * cut.decay), Eigen::MatrixXd::Ones (1, 1));
    const Playback playback { Reconstruction::bandLimited, sampleRate };
    const VoltageSynthesiser synthesiser (program, playback);
    PlateModel plate (model, playback, Eigen::MatrixXd (0, 1));
    Eigen::MatrixXd voltages (1, synthesiser.focusSample() + 1 + plate.latencySamples());
    synthesiser.process (0, voltages);
    Eigen::MatrixXd none (0, voltages.cols());
    plate.process (voltages, none);
    return plate.modalVelocities()[0];
}

/** Drives in three phases, on the mode's frequency and beside it. Q 60, growth 4 a. */
std::vector<CutForce> cutForces (double frequency)
{
    std::vector<CutForce> cuts;
    const auto omega = 2 * piNumber * frequency;
    for (const auto detuning : { 1.0, 1.6 })
        for (const auto phase : { 0.0, 1.0, piNumber / 2 })
            cuts.push_back ({ omega, omega / 120, std::polar (1.0, phase), { 4 * omega / 120, detuning * omega } });
    return cuts;
}
} // namespace

TEST_CASE ("the step constant is the integral of what the interpolation misses of a step")
{
    const auto quadrature = gaussLegendre (24, 1);
    double constant = 0;
    for (int p = 0; p < kaiserSincHalfWidth; ++p)
    {
        for (Eigen::Index i = 0; i < quadrature.nodes.size(); ++i)
        {
            // 1 - s (-t) = s (t): the samples before the cut, and half of the one on it, seen after it
            const auto t = p + quadrature.nodes[i];
            auto step = kaiserSinc (t) / 2;
            for (int n = 1; n < kaiserSincHalfWidth; ++n)
                step += kaiserSinc (t + n);
            constant += quadrature.weights[i] * step;
        }
    }
    CHECK (bandLimitedStepConstant == Approx (constant).epsilon (1e-13));
}

TEST_CASE ("the ideal sinc's step constant is 0.190009 and that of the windowed sinc lies within 0.4 % of it")
{
    const auto quadrature = gaussLegendre (24, 8);
    double integral = 0;
    for (Eigen::Index i = 0; i < quadrature.nodes.size(); ++i)
    {
        const auto w = piNumber * quadrature.nodes[i];
        integral += piNumber * quadrature.weights[i] * (1 / w - 0.5 / std::tan (w / 2)) / w;
    }
    const auto ideal = (integral + 1 / piNumber) / piNumber;
    CHECK (ideal == Approx (0.190009285925941769).epsilon (1e-12)); // by the same integral in 64-bit precision
    CHECK (std::abs (bandLimitedStepConstant / ideal - 1) < 0.004);
}

TEST_CASE ("a force cut at the focus loses kappa T psi of its velocity, and the rest is of second order")
{
    for (const auto& cut : cutForces (3907))
    {
        for (const auto rate : playedRates)
        {
            const auto interval = 1 / rate;
            const auto turn = std::abs (cut.rate) * interval; // the small number of the expansion
            const auto error = playedVelocity (cut, rate) - cut.velocity();
            const auto afterFirst = error + bandLimitedStepConstant * interval * cut.force();
            INFO (rate << " Hz: " << error << ", after the first order " << afterFirst);
            CHECK (std::abs (afterFirst) < 0.05 * turn * interval);
        }
    }
}

TEST_CASE ("the second order of a cut force is (psi' + 2 a psi) T^2 / 24, and the rest is of third order")
{
    for (const auto& cut : cutForces (3907))
    {
        for (const auto rate : playedRates)
        {
            const auto interval = 1 / rate;
            const auto turn = std::abs (cut.rate) * interval;
            const auto error = playedVelocity (cut, rate) - cut.velocity();
            const auto afterSecond =
                error + bandLimitedStepConstant * interval * cut.force()
                - bandLimitedSlopeConstant * interval * interval * (cut.slope() + 2 * cut.decay * cut.force());
            INFO (rate << " Hz: " << error << ", after the second order " << afterSecond / (turn * turn * interval));
            // 1e-7: the gain of the windowed sinc below a tenth of the Nyquist frequency differs from 1 by 0.9e-7 at
            // most
            CHECK (std::abs (afterSecond) < 0.01 * turn * turn * interval + 1e-7 * std::abs (cut.velocity()));
        }
    }
}

TEST_CASE (
    "a force cut at the focus and held at zero order is exact at any rate: nothing after the focus acts before it")
{
    const auto cut = cutForces (3907).front();
    const auto model = modelWithModes ({ 3907 }, 60, Eigen::MatrixXd::Ones (1, 1));
    for (const auto rate : playedRates)
    {
        PlateModel plate (model, { Reconstruction::zeroOrderHold, rate }, Eigen::MatrixXd (0, 1));
        const auto sampled = std::exp (cut.rate / rate); // z of the geometric series
        const std::complex<double> s (-cut.decay, std::sqrt (cut.modal * cut.modal - cut.decay * cut.decay));
        const auto samples = static_cast<Eigen::Index> (34 / cut.rate.real() * rate);
        Eigen::MatrixXd voltages (1, samples + 1), none (0, samples + 1);
        for (Eigen::Index n = 0; n <= samples; ++n)
            voltages (0, n) = (cut.phasor * std::exp (cut.rate * (static_cast<double> (n - samples) / rate))).real();
        plate.process (voltages, none);

        // y (t_f) = (e^{sT} - 1) / s sum_{m >= 1} e^{s (m - 1) T} psi_{-m}
        const auto transition = std::exp (s / rate);
        const auto series = [&] (std::complex<double> phasor, std::complex<double> z)
        { return phasor / (z - transition); };
        const auto state = (transition - 1.0) / s * 0.5
                           * (series (cut.phasor, sampled) + series (std::conj (cut.phasor), std::conj (sampled)));
        const auto velocity = state.real() - cut.decay / s.imag() * state.imag();
        CHECK (plate.modalVelocities()[0] == Approx (velocity).epsilon (1e-10));
    }
}
