#include "AllocationInstances.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_allocation/WaveformBound.h>
#include <antinode_base/InputError.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace antinode;
using namespace antinode::test;

namespace
{
WaveformBoundProblem oneMode (std::complex<double> pole, double duration)
{
    WaveformBoundProblem problem;
    problem.poles = Eigen::VectorXcd::Constant (1, pole);
    problem.participation = Eigen::MatrixXd::Constant (1, 1, 2.0);
    problem.wanted = Eigen::VectorXd::Constant (1, 3.0);
    problem.voltageLimits = Eigen::VectorXd::Constant (1, 5.0);
    problem.duration = duration;
    return problem;
}

/** The integral of |h|, h the velocity after a unit impulse, by the midpoint rule with a million points. */
double impulseArea (std::complex<double> pole, double duration)
{
    constexpr int points = 1000000;
    const auto step = duration / points;
    double sum = 0;

    for (int n = 0; n < points; ++n)
    {
        const auto tau = (n + 0.5) * step;
        sum += std::exp (pole.real() * tau)
               * std::abs (std::cos (pole.imag() * tau) + pole.real() / pole.imag() * std::sin (pole.imag() * tau));
    }

    return sum * step;
}
} // namespace

TEST_CASE ("One undamped mode needs wanted b / (4 N alpha U): a square wave over N cycles", "[lowerBound]")
{
    const auto b = 2 * std::numbers::pi * 1000;
    const auto bound = anyWaveformPeakBound (oneMode ({ 0, b }, 0.025)).lower;
    const auto exact = 3.0 * b / (4 * 25 * 2.0 * 5.0);
    CHECK (bound <= exact);
    CHECK (bound >= 0.999 * exact);
}

TEST_CASE ("One damped mode needs what a switched voltage needs, and the bound stays below it", "[lowerBound]")
{
    for (const auto duration : { 0.0003, 0.004, 0.025 })
    {
        const std::complex<double> pole (-200, 2 * std::numbers::pi * 1700);
        const auto exact = 3.0 / (2.0 * 5.0 * impulseArea (pole, duration));
        const auto bound = anyWaveformPeakBound (oneMode (pole, duration)).lower;
        CHECK (bound <= exact * (1 + 1e-6));
        CHECK (bound >= 0.999 * exact);
    }
}

TEST_CASE ("Modes with a ceramic each need the most of what each needs", "[lowerBound][processors]")
{
    auto problem = oneMode ({ -100, 9000 }, 0.02);
    const auto first = anyWaveformPeakBound (problem).lower;
    problem.poles = Eigen::Vector2cd (std::complex<double> (-100, 9000), std::complex<double> (-300, 25000));
    problem.participation = Eigen::Vector2d (2.0, 1.0).asDiagonal();
    problem.wanted = Eigen::Vector2d (3.0, 1.0);
    problem.voltageLimits = Eigen::Vector2d (5.0, 4.0);
    const auto second = 1.0 / (1.0 * 4.0 * impulseArea ({ -300, 25000 }, 0.02));
    const auto both = anyWaveformPeakBound (problem).lower;
    CHECK (both <= std::max (first, second) * (1 + 1e-3));
    CHECK (both >= std::max (first, second) * (1 - 1e-2));
}

TEST_CASE ("No allocation of drives beats the bound of all waveforms", "[lowerBound]")
{
    for (const auto pattern : { ModePattern::beam, ModePattern::plate })
    {
        const InstanceSize size { 6, 8, 2400, 0, 96000 };
        const auto problem = instance (pattern, RowKind::terminal, size, 41);
        WaveformBoundProblem any;
        any.poles = instancePoles (pattern, size, 41);
        any.participation = problem.participation;
        any.wanted = problem.wanted;
        any.voltageLimits = problem.voltageLimits;
        any.duration = size.samples / size.sampleRate;
        const auto bound = anyWaveformPeakBound (any).lower;
        const auto peak = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
        CHECK (bound > 0.02 * peak);
        CHECK (bound < peak);
    }
}

TEST_CASE ("The bound scales with what is wanted and against limits and participation", "[lowerBound]")
{
    auto problem = oneMode ({ -100, 9000 }, 0.02);
    const auto bound = anyWaveformPeakBound (problem).lower;
    problem.wanted *= -7;
    CHECK (anyWaveformPeakBound (problem).lower == Approx (7 * bound).epsilon (1e-9));
    problem.voltageLimits *= 2;
    CHECK (anyWaveformPeakBound (problem).lower == Approx (3.5 * bound).epsilon (1e-9));
    problem.participation *= 1e-5;
    CHECK (anyWaveformPeakBound (problem).lower == Approx (3.5e5 * bound).epsilon (1e-9));
    problem.wanted.setZero();
    CHECK (anyWaveformPeakBound (problem).lower == 0);
}

TEST_CASE ("A bound that cannot be had is refused", "[lowerBound]")
{
    const auto refused = [] (auto spoil)
    {
        auto problem = oneMode ({ -100, 9000 }, 0.02);
        spoil (problem);
        CHECK_THROWS_AS (anyWaveformPeakBound (problem), InputError);
    };
    refused ([] (auto& p) { p.participation.setZero(); });
    refused ([] (auto& p) { p.poles[0] = { 1, 9000 }; });
    refused ([] (auto& p) { p.poles[0] = { -1, 0 }; });
    refused ([] (auto& p) { p.duration = 0; });
    refused ([] (auto& p) { p.duration = std::numeric_limits<double>::infinity(); });
    refused ([] (auto& p) { p.voltageLimits[0] = 0; });
    refused ([] (auto& p) { p.wanted[0] = std::numeric_limits<double>::quiet_NaN(); });
    refused ([] (auto& p) { p.wanted.resize (0); });
}

TEST_CASE ("Velocities that no waveform brings have a bound and no waveform, and the bound says so",
           "[lowerBound][processors]")
{
    // Two modes with the same pole and the same ceramic always move in the ratio of their participations, 1 to 1.
    auto problem = oneMode ({ -100, 9000 }, 0.02);
    problem.poles = Eigen::VectorXcd::Constant (2, problem.poles[0]);
    problem.participation = Eigen::MatrixXd::Constant (2, 1, 2.0);
    problem.wanted = Eigen::Vector2d (3.0, 2.9);
    const auto bound = anyWaveformPeakBound (problem);
    CHECK (std::isfinite (bound.lower));
    CHECK (bound.lower > 1e6 * anyWaveformPeakBound (oneMode ({ -100, 9000 }, 0.02)).lower);
    CHECK (std::isinf (bound.upper));
    CHECK (bound.gap == 1);
    CHECK (bound.waveforms.empty());
}
