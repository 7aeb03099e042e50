#include "AllocationInstances.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace antinode::test
{
namespace
{
using Complex = std::complex<double>;

struct Mode
{
    double decay = 0, frequency = 0; ///< a, 1/s; b, rad/s.
};

struct Drive
{
    double start = 0; ///< s
    Complex exponent, phasor;
};

/** 53 random bits: the same on every library, which std::uniform_real_distribution is not. */
double uniform (std::mt19937_64& random, double low, double high)
{
    return low + (high - low) * static_cast<double> (random() >> 11) * 0x1p-53;
}

/** Modes between about 1 and 100 % of a highest frequency. Where a beam's first ones would not swing once within the
   duration they lie on a soft foundation, which lifts them. */
std::vector<Mode> randomModes (ModePattern pattern, int count, const InstanceSize& size, std::mt19937_64& random)
{
    const auto highest = size.sampleRate / 6;
    const auto oneCycle = 1.25 * size.sampleRate / size.samples / highest;
    const auto foundation = std::pow (1.5 / (count + 0.5), 2) < oneCycle ? oneCycle : 0.0;
    std::vector<Mode> all;

    for (int k = 0; k < count; ++k)
    {
        const auto place = pattern == ModePattern::beam
                               ? std::hypot (std::pow ((k + 1.5) / (count + 0.5), 2), foundation)
                               : uniform (random, 0.03, 1.0);
        const auto omega = 2 * std::numbers::pi * highest * place;
        const auto damping = 0.5 / uniform (random, 40, 150);
        all.push_back ({ damping * omega, omega * std::sqrt (1 - damping * damping) });
    }

    std::sort (all.begin(), all.end(), [] (const auto& a, const auto& b) { return a.frequency < b.frequency; });
    return all;
}

std::vector<Mode> controlledModes (ModePattern pattern, const InstanceSize& size, std::mt19937_64& random)
{
    auto all = randomModes (pattern, size.modes, size, random);

    if (size.closePair > 0)
    {
        all.back() = all[all.size() - 2];
        all.back().frequency *= 1 + size.closePair;
    }

    return all;
}

/** The offset-free drive that grows by four e-folds within the duration. */
Drive drive (const Mode& mode, double duration)
{
    const auto quarters = std::floor ((mode.frequency * duration - std::numbers::pi / 2) / (2 * std::numbers::pi));
    const auto length = (std::numbers::pi / 2 + 2 * std::numbers::pi * quarters) / mode.frequency;
    const Complex exponent (4 / duration, mode.frequency);
    const auto stiffness = mode.decay * mode.decay + mode.frequency * mode.frequency;
    const auto transfer = (exponent * exponent + 2 * mode.decay * exponent + stiffness) / exponent;
    return { duration - length, exponent, -Complex (0, 1) * transfer * std::exp (-exponent.real() * length) };
}

/** Integral over [0, T] of Re[X e^{pt}] Re[c e^{s (T - t)}]: the velocity at T, with c = 1 + j a/b. */
double terminalVelocity (const Mode& mode, const Drive& drive, double duration)
{
    const auto length = duration - drive.start;
    const Complex pole (-mode.decay, mode.frequency);
    const Complex weight (1, mode.decay / mode.frequency);
    const auto overlap = [&] (Complex s)
    { return (std::exp (drive.exponent * length) - std::exp (s * length)) / (drive.exponent - s); };
    return 0.5 * (drive.phasor * (weight * overlap (pole) + std::conj (weight) * overlap (std::conj (pole)))).real();
}

Eigen::MatrixXd terminalVelocities (const std::vector<Mode>& modes, const std::vector<Drive>& drives, double duration)
{
    Eigen::MatrixXd velocities (modes.size(), drives.size());

    for (std::size_t k = 0; k < modes.size(); ++k)
        for (std::size_t l = 0; l < drives.size(); ++l)
            velocities (k, l) = terminalVelocity (modes[k], drives[l], duration);

    return velocities;
}

Eigen::MatrixXd sampled (const std::vector<Drive>& drives, const InstanceSize& size)
{
    Eigen::MatrixXd samples = Eigen::MatrixXd::Zero (drives.size(), size.samples);

    for (std::size_t l = 0; l < drives.size(); ++l)
        for (int n = 0; n < size.samples; ++n)
        {
            const auto time = (n + 1) / size.sampleRate - drives[l].start;

            if (time >= 0)
                samples (l, n) = (drives[l].phasor * std::exp (drives[l].exponent * time)).real();
        }

    return samples;
}

Eigen::MatrixXd randomMatrix (Eigen::Index rows, Eigen::Index columns, std::mt19937_64& random)
{
    Eigen::MatrixXd matrix (rows, columns);

    for (Eigen::Index k = 0; k < matrix.size(); ++k)
        matrix.data()[k] = uniform (random, -1, 1);

    return matrix;
}
} // namespace

AllocationProblem instance (ModePattern pattern, RowKind kind, const InstanceSize& size, std::uint32_t seed)
{
    std::mt19937_64 random (seed);
    const auto duration = size.samples / size.sampleRate;
    const auto controlled = controlledModes (pattern, size, random);
    const auto guards = randomModes (ModePattern::plate, size.guards, size, random);
    std::vector<Drive> drives;
    drives.reserve (controlled.size());

    for (const auto& mode : controlled)
        drives.push_back (drive (mode, duration));

    AllocationProblem problem;
    problem.waveforms = sampled (drives, size);
    problem.participation = randomMatrix (size.modes, size.ceramics, random);
    problem.wanted =
        kind == RowKind::identity ? Eigen::MatrixXd::Ones (size.modes, 1) : randomMatrix (size.modes, 1, random);
    problem.rows = kind == RowKind::identity ? Eigen::MatrixXd::Identity (size.modes, size.modes)
                                             : terminalVelocities (controlled, drives, duration);
    problem.guardParticipation = randomMatrix (size.guards, size.ceramics, random);
    problem.guardRows = terminalVelocities (guards, drives, duration);
    problem.voltageLimits = Eigen::VectorXd::Ones (size.ceramics);
    return problem;
}

Eigen::VectorXcd instancePoles (ModePattern pattern, const InstanceSize& size, std::uint32_t seed)
{
    std::mt19937_64 random (seed);
    Eigen::VectorXcd poles (size.modes);
    Eigen::Index k = 0;

    for (const auto& mode : controlledModes (pattern, size, random))
        poles[k++] = { -mode.decay, mode.frequency };

    return poles;
}

AllocationProblem withLimits (AllocationProblem problem, double slack, double minimumPeakRatio)
{
    problem.voltageLimits *= slack * minimumPeakRatio;
    return problem;
}

Eigen::VectorXd rowValues (const Eigen::MatrixXd& participation, const Eigen::MatrixXd& rows,
                           const Eigen::MatrixXd& matrix)
{
    return participation.cwiseProduct (rows * matrix.transpose()).rowwise().sum();
}
} // namespace antinode::test
