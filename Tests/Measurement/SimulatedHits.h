#pragma once

#include <antinode_measurement/HammerHits.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace antinode::test
{
inline constexpr double hammerRate = 8192;
inline constexpr double hammerNoise = 1e-3; // of a channel's largest value: 60 dB below it

/** Three modes at two sensors, of a hammer at one place: Hz, damping ratio, residues in (m/s)/N kg. */
struct HammeredMode
{
    double frequency, damping;
    std::array<double, 2> residues;
};

inline constexpr std::array<HammeredMode, 3> hammeredModes { HammeredMode { 151.3, 0.004, { 1.0, -0.6 } },
                                                             HammeredMode { 387.9, 0.003, { -0.7, 0.9 } },
                                                             HammeredMode { 702.2, 0.005, { 0.8, 0.5 } } };

/** Velocity per newton at s. */
inline std::complex<double> exactResponse (std::complex<double> s, std::size_t sensor)
{
    std::complex<double> sum = 0;

    for (const auto& mode : hammeredModes)
    {
        const auto omega = 2 * std::numbers::pi * mode.frequency;
        sum += mode.residues[sensor] * s / (s * s + 2 * mode.damping * omega * s + omega * omega);
    }

    return sum;
}

/** Half sines, N: at s, with a peak and a duration. */
struct Pulse
{
    double time, peak, duration;
};

inline double forceAt (const std::vector<Pulse>& pulses, double time)
{
    double force = 0;

    for (const auto& pulse : pulses)
        if (const auto within = time - pulse.time; within > 0 && within < pulse.duration)
            force += pulse.peak * std::pow (std::sin (std::numbers::pi * within / pulse.duration), 2);

    return force;
}

/** Each mode's motion by Runge and Kutta's steps, 8 of them a sample: nothing of the code that is tested. */
inline HammerRecording simulateHits (const std::vector<Pulse>& pulses, double seconds, unsigned seed)
{
    constexpr int steps = 8;
    constexpr double h = 1 / hammerRate / steps;
    const auto samples = static_cast<Eigen::Index> (seconds * hammerRate);
    HammerRecording recording { "hits.wav", hammerRate, Eigen::VectorXd (samples), Eigen::MatrixXd::Zero (2, samples),
                                Eigen::VectorXd::Zero (3) };
    std::array<std::array<double, 2>, hammeredModes.size()> states {}; // displacement, velocity

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        const auto time = static_cast<double> (n) / hammerRate;
        recording.force[n] = forceAt (pulses, time);

        for (std::size_t k = 0; k < hammeredModes.size(); ++k)
        {
            auto& [q, v] = states[k];
            const auto omega = 2 * std::numbers::pi * hammeredModes[k].frequency;
            const auto acceleration = [&] (double t, double x, double dx)
            { return forceAt (pulses, t) - 2 * hammeredModes[k].damping * omega * dx - omega * omega * x; };

            for (Eigen::Index sensor = 0; sensor < 2; ++sensor)
                recording.responses (sensor, n) += hammeredModes[k].residues[static_cast<std::size_t> (sensor)] * v;

            for (int step = 0; step < steps; ++step)
            {
                const auto t = time + step * h;
                const auto a1 = acceleration (t, q, v), v2 = v + h / 2 * a1;
                const auto a2 = acceleration (t + h / 2, q + h / 2 * v, v2), v3 = v + h / 2 * a2;
                const auto a3 = acceleration (t + h / 2, q + h / 2 * v2, v3), v4 = v + h * a3;
                const auto a4 = acceleration (t + h, q + h * v3, v4);
                q += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
                v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
            }
        }
    }

    std::mt19937 generator (seed);
    std::normal_distribution<double> normal;
    const auto addNoise = [&] (auto&& channel)
    {
        const auto level = hammerNoise * channel.cwiseAbs().maxCoeff();

        for (Eigen::Index n = 0; n < samples; ++n)
            channel[n] += level * normal (generator);
    };
    addNoise (recording.force);
    addNoise (recording.responses.row (0));
    addNoise (recording.responses.row (1));
    return recording;
}
} // namespace antinode::test
