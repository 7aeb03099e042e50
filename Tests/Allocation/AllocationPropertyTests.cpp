#include "AllocationInstances.h"

#include <antinode_allocation/Allocation.h>

#include <catch2/catch.hpp>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <random>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Matrices that leave all hard rows at 0, as columns over M (i, l) stacked by ceramics. */
Eigen::MatrixXd rowKernel (const AllocationProblem& problem)
{
    const auto drives = problem.waveforms.rows();
    Eigen::MatrixXd rows (problem.wanted.size(), drives * problem.participation.cols());

    for (Eigen::Index i = 0; i < problem.participation.cols(); ++i)
        rows.middleCols (i * drives, drives) = problem.participation.col (i).asDiagonal() * problem.rows;

    return rows.fullPivLu().kernel();
}

Eigen::MatrixXd unstacked (const Eigen::VectorXd& stacked, const AllocationProblem& problem)
{
    const auto drives = problem.waveforms.rows();
    return Eigen::Map<const Eigen::MatrixXd> (stacked.data(), drives, problem.participation.cols()).transpose();
}

double energy (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    return 0.5 * (matrix * problem.waveforms).squaredNorm();
}

double peakRatio (const AllocationProblem& problem, const Eigen::MatrixXd& voltages)
{
    return voltages.cwiseAbs().rowwise().maxCoeff().cwiseQuotient (problem.voltageLimits).maxCoeff();
}

/** The longest step from voltages within the limits along a direction that stays within them. */
double longestStep (const AllocationProblem& problem, const Eigen::MatrixXd& voltages, const Eigen::MatrixXd& direction)
{
    const Eigen::ArrayXXd limits = problem.voltageLimits.replicate (1, voltages.cols()).array();
    const Eigen::ArrayXXd room = (direction.array() > 0).select (limits - voltages.array(), limits + voltages.array());
    return (room / direction.array().abs().max (1e-300)).minCoeff();
}

Eigen::VectorXd randomVector (Eigen::Index size, std::mt19937_64& random)
{
    Eigen::VectorXd vector (size);

    for (auto& value : vector)
        value = 2 * static_cast<double> (random() >> 11) * 0x1p-53 - 1;

    return vector;
}

/** The least energy within the limits by the dual proximal gradient method: slow, and shares nothing with the solver.
   The energy's dual has the voltages as its gradient, with Lipschitz constant 1, and the limits as a weight of the
   1-norm. */
double slowMinimumEnergy (const AllocationProblem& problem, int iterations)
{
    const auto drives = problem.waveforms.rows();
    const auto samples = problem.waveforms.cols();
    const auto ceramics = problem.participation.cols();
    Eigen::MatrixXd toVoltages = Eigen::MatrixXd::Zero (ceramics * samples, ceramics * drives);
    Eigen::VectorXd limits (ceramics * samples);

    for (Eigen::Index i = 0; i < ceramics; ++i)
    {
        toVoltages.block (i * samples, i * drives, samples, drives) = problem.waveforms.transpose();
        limits.segment (i * samples, samples).setConstant (problem.voltageLimits[i]);
    }

    const Eigen::MatrixXd freedom = toVoltages * rowKernel (problem);
    const Eigen::MatrixXd basis = Eigen::HouseholderQR<Eigen::MatrixXd> (freedom).householderQ()
                                  * Eigen::MatrixXd::Identity (freedom.rows(), freedom.cols());
    const Eigen::MatrixXd start = minimumNormAllocation (problem).transpose();
    const Eigen::VectorXd minimum = toVoltages * Eigen::Map<const Eigen::VectorXd> (start.data(), start.size());
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero (limits.size());
    Eigen::VectorXd ahead = multipliers;
    double momentum = 1;

    for (int n = 0; n < iterations; ++n)
    {
        const Eigen::VectorXd moved = ahead + minimum - basis * (basis.transpose() * ahead);
        const Eigen::VectorXd next = moved - moved.cwiseMin (limits).cwiseMax (-limits);
        const auto nextMomentum = 0.5 * (1 + std::sqrt (1 + 4 * momentum * momentum));
        ahead = next + (momentum - 1) / nextMomentum * (next - multipliers);
        multipliers = next;
        momentum = nextMomentum;
    }

    return 0.5 * (minimum - basis * (basis.transpose() * multipliers)).squaredNorm();
}
} // namespace

TEST_CASE ("No feasible matrix of 2000 random ones goes below the certified bounds", "[allocation]")
{
    for (const auto kind : { RowKind::identity, RowKind::terminal })
    {
        const auto problem = instance (ModePattern::plate, kind, { 4, 5, 600, 0, 96000 }, 21);
        const auto minimum = solveAllocation (problem, AllocationGoal::peak);
        const auto limited = withLimits (problem, 1.1, minimum.certificate.minimumPeakRatio);
        const auto best = solveAllocation (limited, AllocationGoal::norm);
        REQUIRE (best.certificate.status == AllocationStatus::optimal);
        const auto kernel = rowKernel (limited);
        const Eigen::MatrixXd inside = minimum.matrix * limited.waveforms;
        std::mt19937_64 random (5);
        double lowestEnergy = best.certificate.objective * 1e9;
        double lowestPeak = minimum.certificate.peakRatio;

        for (int n = 0; n < 2000; ++n)
        {
            // From the least peak towards the least norm (or anywhere), as far as the limits allow.
            const auto towardsBest = n % 2 == 0 ? 1.0 : 0.0;
            const Eigen::VectorXd any = kernel * randomVector (kernel.cols(), random);
            Eigen::MatrixXd direction = unstacked (any, limited) * limited.waveforms;
            direction *= 0.1 * inside.norm() / direction.norm();
            direction += towardsBest * (best.matrix - minimum.matrix) * limited.waveforms;
            const auto step = std::min (1.0, longestStep (limited, inside, direction));
            const Eigen::MatrixXd voltages = inside + step * direction;
            REQUIRE (peakRatio (limited, voltages) <= 1 + 1e-12);
            lowestEnergy = std::min (lowestEnergy, 0.5 * voltages.squaredNorm());
            lowestPeak = std::min (lowestPeak, peakRatio (problem, voltages));
        }

        CHECK (lowestEnergy >= best.certificate.bound);
        CHECK (lowestEnergy <= 1.5 * best.certificate.bound); // The random ones came near: the check could fail.
        CHECK (lowestPeak >= minimum.certificate.minimumPeakRatio);
    }
}

TEST_CASE ("A slow dual gradient method ends at the same least energy", "[allocation]")
{
    for (const std::uint32_t seed : { 1U, 2U, 3U })
    {
        const auto problem = instance (ModePattern::beam, RowKind::terminal, { 3, 3, 60, 0, 24000 }, seed);
        const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
        const auto limited = withLimits (problem, 1.05, minimum);
        const auto allocation = solveAllocation (limited, AllocationGoal::norm);
        REQUIRE (allocation.certificate.status == AllocationStatus::optimal);
        CHECK (allocation.certificate.objective == Approx (slowMinimumEnergy (limited, 20000)).epsilon (1e-6));
        CHECK (allocation.certificate.objective > 1.0001 * energy (limited, minimumNormAllocation (limited)));
    }
}

TEST_CASE ("Any size, guards, unequal limits: the contract holds", "[allocation]")
{
    std::mt19937_64 random (77);
    const auto below = [&] (int count) { return static_cast<int> (random() % static_cast<unsigned> (count)); };

    for (std::uint32_t seed = 1; seed <= 40; ++seed)
    {
        const InstanceSize size { 1 + below (10), 1 + below (16), 200 + below (2000), below (2) * below (25), 96000 };
        auto problem = instance (seed % 2 == 0 ? ModePattern::beam : ModePattern::plate,
                                 seed % 4 < 2 ? RowKind::identity : RowKind::terminal, size, seed);
        problem.guardWeight = std::pow (10.0, below (5));
        problem.voltageLimits += 2 * randomVector (size.ceramics, random).cwiseAbs();
        const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;

        for (const auto slack : { 2.0, 1.2, 1.01, 0.9 })
        {
            const auto limited = withLimits (problem, slack, minimum);
            const auto allocation = solveAllocation (limited, AllocationGoal::norm);
            const auto& certificate = allocation.certificate;
            const auto peak = peakRatio (limited, allocation.matrix * limited.waveforms);
            CAPTURE (seed, slack, size.ceramics, size.modes, size.samples, size.guards);
            CHECK ((certificate.status == AllocationStatus::infeasible) == (slack < 1));
            CHECK (std::abs (certificate.gap) <= 1e-6);
            CHECK (certificate.rowResidual <= 1e-11);
            CHECK (peak <= std::max (1.0, 1.001 / slack) * (1 + 1e-6 * (slack < 1) + 1e-9));
        }
    }
}

TEST_CASE ("The allocation is linear in what is wanted, and the least peak too", "[allocation]")
{
    auto problem = instance (ModePattern::plate, RowKind::terminal, { 4, 6, 1000, 4, 96000 }, 31);
    problem.guardWeight = 100;
    const auto matrix = minimumNormAllocation (problem);
    const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
    problem.wanted *= -2.5;
    CHECK ((minimumNormAllocation (problem) + 2.5 * matrix).norm() <= 1e-12 * matrix.norm());
    CHECK (solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio
           == Approx (2.5 * minimum).epsilon (1e-6));
}

TEST_CASE ("Units do not matter: of voltage, velocity, participation, nor the number of samples", "[allocation]")
{
    auto problem = instance (ModePattern::plate, RowKind::terminal, { 4, 6, 1000, 4, 96000 }, 32);
    problem.guardWeight = 100;
    const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
    const auto limited = withLimits (problem, 1.1, minimum);
    const auto allocation = solveAllocation (limited, AllocationGoal::norm);
    const auto expect = [&] (const AllocationProblem& same, double factor)
    {
        const auto other = solveAllocation (same, AllocationGoal::norm);
        CHECK (other.certificate.status == allocation.certificate.status);
        CHECK ((other.matrix * factor - allocation.matrix).norm() <= 1e-4 * allocation.matrix.norm());
    };
    auto participationInOtherUnit = limited;
    participationInOtherUnit.participation *= 1e6;
    participationInOtherUnit.guardParticipation *= 1e6;
    participationInOtherUnit.voltageLimits *= 1e-6;
    expect (participationInOtherUnit, 1e6);
    auto velocityInOtherUnit = limited;
    velocityInOtherUnit.rows *= 1e3;
    velocityInOtherUnit.guardRows *= 1e3;
    velocityInOtherUnit.wanted *= 1e3;
    expect (velocityInOtherUnit, 1);
    auto everySampleTwice = limited;
    everySampleTwice.waveforms.resize (limited.waveforms.rows(), 2 * limited.waveforms.cols());
    everySampleTwice.waveforms << limited.waveforms, limited.waveforms;
    expect (everySampleTwice, 1);
}
