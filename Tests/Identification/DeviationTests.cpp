#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** What a measurement suffers from besides white noise 40 dB below the responses. */
struct Disturbance
{
    double drift = 0;  ///< Relative, of all resonances from point to point, standard deviation.
    double misfit = 0; ///< Relative to the responses, smooth over frequency, another one in each channel.
};

/** 1 plus waves of some hundred Hz with random phases. */
Eigen::ArrayXcd smoothFactor (const Eigen::VectorXd& frequencies, double size, ComplexNoise& noise)
{
    constexpr int waves = 12;
    constexpr double shortest = 150; // Hz
    Eigen::ArrayXcd result = Eigen::ArrayXcd::Ones (frequencies.size());

    for (int n = 0; n < waves; ++n)
    {
        const auto amplitude = size / std::sqrt (waves) * noise();
        const auto rate = 2 * std::numbers::pi / shortest * (n - waves / 2) / (waves / 2);
        result += amplitude * (frequencies.array() * std::complex<double> (0, rate)).exp();
    }

    return result;
}

FrequencyResponses disturbedResponses (const KnownStructure& truth, const Disturbance& disturbance, unsigned seed)
{
    const auto frequencies = lines (200, 3000, 4);
    auto responses = idealResponses (truth, frequencies);
    ComplexNoise noise (seed + 1000);

    for (Eigen::Index p = 0; p < truth.points.rows(); ++p)
    {
        auto there = truth;
        there.points = truth.points.row (p);
        there.shapes = truth.shapes.row (p);
        there.frequencies *= 1 + disturbance.drift * std::sqrt (2.0) * noise().real();
        const auto atPoint = idealResponses (there, frequencies);

        for (std::size_t i = 0; i < responses.values.size(); ++i)
            responses.values[i].col (p) =
                atPoint.values[i].col (0).array() * smoothFactor (frequencies, disturbance.misfit, noise);
    }

    addNoise (responses, 40, seed);
    return responses;
}

/** RMS over modes and measurements of errors over stated deviations: of frequency, damping, participation, shape and
    delay. */
std::vector<double> normalisedErrors (const Disturbance& disturbance, unsigned measurements, bool ofNoise = false)
{
    const auto truth = lowestModes (knownBeam (5, 16, 3), 5);
    Eigen::ArrayXd squares = Eigen::ArrayXd::Zero (5);

    for (unsigned seed = 1; seed <= measurements; ++seed)
    {
        IdentificationOptions options;
        options.complexModes = false;
        options.pointMasses = truth.masses;
        options.selected.assign (truth.frequencies.begin(), truth.frequencies.end());
        auto modes = identify (disturbedResponses (truth, disturbance, seed), options);

        if (ofNoise)
            modes.deviations = modes.noiseDeviations;

        const auto result = score (modes, truth);
        REQUIRE (result.found == 5);
        const auto delay = (modes.delay - truth.delay) / modes.deviations.delay;
        squares +=
            Eigen::Array<double, 5, 1> (result.zFrequency, result.zDamping, result.zParticipation, result.zShape, delay)
                .square();
    }

    const Eigen::ArrayXd result = (squares / measurements).sqrt();
    return { result.begin(), result.end() };
}
} // namespace

TEST_CASE ("Stated deviations hold under white noise, under drift between points and under misfit", "[identification]")
{
    const auto disturbance =
        GENERATE (Disturbance {}, Disturbance { 50e-6, 0 }, Disturbance { 200e-6, 0 }, Disturbance { 0, 0.03 });
    CAPTURE (disturbance.drift, disturbance.misfit);

    const auto z = normalisedErrors (disturbance, 3);
    CAPTURE (z[0], z[1], z[2], z[3], z[4]);

    // Frequency and damping, then participation, shape and delay.
    for (const auto n : { 0, 1 })
        CHECK (z[std::size_t (n)] > 0.5);

    CHECK (*std::max_element (z.begin(), z.end()) < 1.8);
}

TEST_CASE ("Deviations of noise alone are too small under misfit", "[identification]")
{
    CHECK (normalisedErrors ({ 0, 0.03 }, 1, true)[0] > 4);
}
