#pragma once

#include "MeasuredStructure.h"

namespace antinode::test
{
/** What a measurement suffers from besides white noise 40 dB below the responses. */
struct Disturbance
{
    double drift = 0;  ///< Relative, of all resonances from point to point, standard deviation.
    double misfit = 0; ///< Relative to the responses, smooth over frequency, another one in each channel.
};

/** 1 plus waves with random phases, the shortest 150 Hz long. */
inline Eigen::ArrayXcd smoothFactor (const Eigen::VectorXd& frequencies, double size, ComplexNoise& noise)
{
    constexpr int waves = 12;
    constexpr double shortest = 150; // Hz
    Eigen::ArrayXcd result = Eigen::ArrayXcd::Ones (frequencies.size());

    for (int n = -waves / 2; n < waves / 2; ++n)
    {
        const auto amplitude = size / std::sqrt (static_cast<double> (waves)) * noise();
        const auto rate = 2 * std::numbers::pi / shortest * 2 * n / waves;
        result += amplitude * (frequencies.array() * std::complex<double> (0, rate)).exp();
    }

    return result;
}

/** Each point sees resonances of its own, and each channel its own smooth factor. */
inline FrequencyResponses disturbedResponses (const KnownStructure& truth, const Eigen::VectorXd& frequencies,
                                              const Disturbance& disturbance, unsigned seed)
{
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
} // namespace antinode::test
