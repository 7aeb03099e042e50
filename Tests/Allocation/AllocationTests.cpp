#include "AllocationInstances.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_base/InputError.h>

#include <catch2/catch.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Rows as vectors over M (i, l) stacked by ceramics: row k is participation (k, i) rows (k, l). */
Eigen::MatrixXd stackedRows (const Eigen::MatrixXd& participation, const Eigen::MatrixXd& rows)
{
    Eigen::MatrixXd stacked (rows.rows(), rows.cols() * participation.cols());

    for (Eigen::Index i = 0; i < participation.cols(); ++i)
        stacked.middleCols (i * rows.cols(), rows.cols()) = participation.col (i).asDiagonal() * rows;

    return stacked;
}

/** The minimum norm from the whole Karush-Kuhn-Tucker system of all N_b N_d unknowns, by LU. */
Eigen::MatrixXd bruteForceMinimumNorm (const AllocationProblem& problem, double guardStiffness)
{
    const auto drives = problem.waveforms.rows();
    const auto ceramics = problem.participation.cols();
    const auto unknowns = drives * ceramics;
    const auto hard = stackedRows (problem.participation, problem.rows);
    const auto guards = stackedRows (problem.guardParticipation, problem.guardRows);
    Eigen::MatrixXd curvature = guardStiffness * guards.transpose() * guards;

    for (Eigen::Index i = 0; i < ceramics; ++i)
        curvature.block (i * drives, i * drives, drives, drives) += problem.waveforms * problem.waveforms.transpose();

    // Both parts in units in which their entries are about 1.
    const auto rowUnit = hard.norm();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero (unknowns + hard.rows(), unknowns + hard.rows());
    system.topLeftCorner (unknowns, unknowns) = curvature / curvature.norm();
    system.topRightCorner (unknowns, hard.rows()) = hard.transpose() / rowUnit;
    system.bottomLeftCorner (hard.rows(), unknowns) = hard / rowUnit;
    Eigen::VectorXd right = Eigen::VectorXd::Zero (system.rows());
    right.tail (hard.rows()) = problem.wanted / rowUnit;
    const Eigen::VectorXd solution = system.partialPivLu().solve (right);
    return Eigen::Map<const Eigen::MatrixXd> (solution.data(), drives, ceramics).transpose();
}

double playedPeakRatio (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    const Eigen::VectorXd peaks = (matrix * problem.waveforms).cwiseAbs().rowwise().maxCoeff();
    return peaks.cwiseQuotient (problem.voltageLimits).maxCoeff();
}

/** What holds for every allocation, recomputed from the matrix. */
void checkAllocation (const AllocationProblem& problem, const Allocation& allocation)
{
    const auto& certificate = allocation.certificate;
    const Eigen::VectorXd values = rowValues (problem.participation, problem.rows, allocation.matrix);
    const Eigen::VectorXd guards = rowValues (problem.guardParticipation, problem.guardRows, allocation.matrix);
    CHECK ((values - problem.wanted).cwiseAbs().maxCoeff() <= 1e-11 * problem.wanted.cwiseAbs().maxCoeff());
    CHECK (certificate.peakRatio == Approx (playedPeakRatio (problem, allocation.matrix)).epsilon (1e-9));
    CHECK (certificate.gap <= 1e-6);
    CHECK (certificate.gap >= -1e-9);
    CHECK (certificate.bound <= certificate.objective * (1 + 1e-9));

    if (problem.guardWeight == 0)
        CHECK (certificate.objective
               == Approx (0.5 * (allocation.matrix * problem.waveforms).squaredNorm()).epsilon (1e-9));
}

void checkLimitedInstance (ModePattern pattern, RowKind kind, const InstanceSize& size)
{
    const auto problem = instance (pattern, kind, size, 7);
    const auto peak = solveAllocation (problem, AllocationGoal::peak);
    const auto minimum = peak.certificate.minimumPeakRatio;
    checkAllocation (problem, peak);
    CHECK (peak.certificate.status == AllocationStatus::optimal);
    CHECK (peak.certificate.peakRatio <= minimum * (1.001 + 1e-6));
    CHECK (peak.certificate.peakRatio >= minimum);

    for (const auto slack : { 1.3, 1.05 })
    {
        const auto limited = withLimits (problem, slack, minimum);
        const auto allocation = solveAllocation (limited, AllocationGoal::norm);
        checkAllocation (limited, allocation);
        CHECK (allocation.certificate.status != AllocationStatus::infeasible);
        CHECK (playedPeakRatio (limited, allocation.matrix) <= 1 + 1e-9);
    }

    const auto tooTight = withLimits (problem, 0.8, minimum);
    const auto allocation = solveAllocation (tooTight, AllocationGoal::norm);
    checkAllocation (tooTight, allocation);
    CHECK (allocation.certificate.status == AllocationStatus::infeasible);
    CHECK (allocation.certificate.minimumPeakRatio == Approx (1 / 0.8).epsilon (1e-6));
    CHECK (allocation.certificate.peakRatio <= 1.001 / 0.8 * (1 + 2e-6));
}
} // namespace

TEST_CASE ("The minimum norm solves the Karush-Kuhn-Tucker system of all unknowns", "[allocation]")
{
    for (const auto kind : { RowKind::identity, RowKind::terminal })
    {
        auto problem = instance (ModePattern::beam, kind, { 3, 4, 600, 5, 96000 }, 3);
        const auto withoutGuards = bruteForceMinimumNorm (problem, 0);
        CHECK ((minimumNormAllocation (problem) - withoutGuards).norm() <= 1e-9 * withoutGuards.norm());

        // The guards' scale as Allocation.h defines it: least energy over the square of what is wanted.
        problem.guardWeight = 30;
        const auto scale = (withoutGuards * problem.waveforms).squaredNorm() / problem.wanted.squaredNorm();
        const auto withGuards = bruteForceMinimumNorm (problem, problem.guardWeight * scale);
        CHECK ((minimumNormAllocation (problem) - withGuards).norm() <= 1e-9 * withGuards.norm());
        CHECK ((withGuards - withoutGuards).norm() > 1e-3 * withoutGuards.norm());
    }
}

TEST_CASE ("Limits that the minimum norm keeps leave it as it is, with a gap of rounding", "[allocation]")
{
    auto problem = instance (ModePattern::plate, RowKind::terminal, standardSizes[1], 2);
    const auto matrix = minimumNormAllocation (problem);
    problem.voltageLimits *= 1.001 * playedPeakRatio (problem, matrix);
    const auto allocation = solveAllocation (problem, AllocationGoal::norm);
    CHECK (allocation.certificate.status == AllocationStatus::unconstrained);
    CHECK (allocation.certificate.gap <= 1e-10);
    CHECK (allocation.certificate.iterations == 0);
    CHECK ((allocation.matrix - matrix).norm() <= 1e-12 * matrix.norm());
    checkAllocation (problem, allocation);
}

TEST_CASE ("Limits of 1.3, 1.05 and 0.8 of the least peak are kept, kept tightly, and proven too small", "[allocation]")
{
    for (const auto pattern : { ModePattern::beam, ModePattern::plate })
        for (const auto kind : { RowKind::identity, RowKind::terminal })
            for (int size = 0; size < 3; ++size)
            {
                CAPTURE (size, static_cast<int> (pattern), static_cast<int> (kind));
                checkLimitedInstance (pattern, kind, standardSizes[size]);
            }
}

TEST_CASE ("16 ceramics, 40 modes and 4800 samples at 1.05 of the least peak are solved to 1e-6", "[allocation]")
{
    const auto problem = instance (ModePattern::plate, RowKind::terminal, standardSizes[3], 1);
    const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
    const auto limited = withLimits (problem, 1.05, minimum);
    const auto allocation = solveAllocation (limited, AllocationGoal::norm);
    checkAllocation (limited, allocation);
    CHECK (allocation.certificate.status == AllocationStatus::optimal);
    CHECK (playedPeakRatio (limited, allocation.matrix) <= 1 + 1e-9);
}

TEST_CASE ("Every ceramic keeps its own limit", "[allocation]")
{
    auto problem = instance (ModePattern::beam, RowKind::terminal, standardSizes[1], 4);
    problem.voltageLimits << 1, 0.1, 3, 0.5;
    const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
    const auto limited = withLimits (problem, 1.1, minimum);
    const auto allocation = solveAllocation (limited, AllocationGoal::norm);
    checkAllocation (limited, allocation);
    CHECK (allocation.certificate.status == AllocationStatus::optimal);
    CHECK (playedPeakRatio (limited, allocation.matrix) <= 1 + 1e-9);
}

TEST_CASE ("The same problem gives the same bits", "[allocation]")
{
    const auto problem = instance (ModePattern::plate, RowKind::terminal, standardSizes[2], 5);

    for (const auto goal : { AllocationGoal::norm, AllocationGoal::peak })
    {
        const auto first = solveAllocation (problem, goal);
        const auto second = solveAllocation (problem, goal);
        CHECK (first.matrix == second.matrix);
        CHECK (first.certificate.bound == second.certificate.bound);
        CHECK (first.certificate.iterations == second.certificate.iterations);
    }
}

TEST_CASE ("Threads that solve at once get the same bits as one alone", "[allocation]")
{
    const auto problem = instance (ModePattern::plate, RowKind::terminal, standardSizes[2], 1);
    const auto alone = solveAllocation (problem, AllocationGoal::peak).matrix;
    std::vector<int> same (3);
    std::vector<std::thread> threads;

    for (auto& count : same)
        threads.emplace_back (
            [&]
            {
                for (int n = 0; n < 5; ++n)
                    count += solveAllocation (problem, AllocationGoal::peak).matrix == alone;
            });

    for (auto& thread : threads)
        thread.join();

    CHECK (same == std::vector<int> (3, 5));
}

TEST_CASE ("Limits that cannot be kept say what can be reached: wanted over the least peak ratio", "[allocation]")
{
    auto problem = instance (ModePattern::plate, RowKind::terminal, standardSizes[1], 6);
    const auto tooMuch = solveAllocation (problem, AllocationGoal::norm);
    REQUIRE (tooMuch.certificate.status == AllocationStatus::infeasible);
    problem.wanted /= tooMuch.certificate.minimumPeakRatio * (1 + 1e-5);
    CHECK (solveAllocation (problem, AllocationGoal::norm).certificate.status == AllocationStatus::optimal);
    problem.wanted *= 1 + 2e-5;
    CHECK (solveAllocation (problem, AllocationGoal::norm).certificate.status == AllocationStatus::infeasible);
}

TEST_CASE ("Soft guards take uncontrolled modes down by orders of magnitude at little energy", "[allocation]")
{
    auto problem = instance (ModePattern::beam, RowKind::terminal, { 8, 6, 2400, 10, 96000 }, 11);
    const auto guardNorm = [&] (const Eigen::MatrixXd& matrix)
    { return rowValues (problem.guardParticipation, problem.guardRows, matrix).norm() / problem.wanted.norm(); };
    const auto energy = [&] (const Eigen::MatrixXd& matrix) { return (matrix * problem.waveforms).squaredNorm(); };
    const auto without = minimumNormAllocation (problem);

    // Measured: 0.092 of the guards at 1.004 of the energy, and 0.0041 at 1.10.
    problem.guardWeight = 100;
    const auto usual = minimumNormAllocation (problem);
    CHECK (guardNorm (usual) <= 0.1 * guardNorm (without));
    CHECK (energy (usual) <= 1.01 * energy (without));
    problem.guardWeight = 1e6;
    const auto strict = minimumNormAllocation (problem);
    CHECK (guardNorm (strict) <= 0.005 * guardNorm (without));
    CHECK (energy (strict) <= 1.15 * energy (without));

    // No weight is the same as no guards.
    problem.guardWeight = 0;
    auto noGuards = problem;
    noGuards.guardRows.resize (0, 0);
    noGuards.guardParticipation.resize (0, 0);
    CHECK (minimumNormAllocation (problem) == minimumNormAllocation (noGuards));
}

TEST_CASE ("Guards within limits: the gap is certified too, and the hard rows stay exact", "[allocation]")
{
    auto problem = instance (ModePattern::plate, RowKind::terminal, { 8, 10, 2400, 12, 96000 }, 12);
    problem.guardWeight = 100;
    const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;

    for (const auto slack : { 1.5, 1.05 })
    {
        const auto limited = withLimits (problem, slack, minimum);
        const auto allocation = solveAllocation (limited, AllocationGoal::norm);
        checkAllocation (limited, allocation);
        CHECK (playedPeakRatio (limited, allocation.matrix) <= 1 + 1e-9);
    }
}

TEST_CASE ("Modes 0.1 % apart in frequency are steered apart", "[allocation]")
{
    const auto problem = instance (ModePattern::plate, RowKind::terminal, { 6, 8, 4800, 0, 192000, 1e-3 }, 15);
    const auto minimum = solveAllocation (problem, AllocationGoal::peak);
    checkAllocation (problem, minimum);
    const auto limited = withLimits (problem, 1.05, minimum.certificate.minimumPeakRatio);
    checkAllocation (limited, solveAllocation (limited, AllocationGoal::norm));
}

TEST_CASE ("Drives that are copies of each other, or nothing at all, are allowed", "[allocation]")
{
    auto problem = instance (ModePattern::beam, RowKind::identity, { 4, 5, 1000, 0, 96000 }, 9);
    problem.waveforms.row (3) = problem.waveforms.row (2);
    problem.waveforms.row (4).setZero();
    const auto allocation = solveAllocation (problem, AllocationGoal::peak);
    CHECK (allocation.certificate.rowResidual <= 1e-9);
    CHECK (allocation.certificate.gap <= 1e-6);
    CHECK (allocation.matrix.allFinite());
}

TEST_CASE ("The gap falls while it is shown, and a watch cancels when it wants to", "[allocation]")
{
    const auto problem = instance (ModePattern::plate, RowKind::terminal, standardSizes[1], 5);
    double last = 1;
    auto steps = 0, looks = 0;
    const WatchScope counting ([&] { return ++looks > 0; });
    const auto allocation = solveAllocation (problem, AllocationGoal::peak,
                                             [&] (const AllocationProgress& progress)
                                             {
                                                 ++steps;
                                                 last = progress.gap;
                                             });
    CHECK (steps > 3);
    CHECK (looks >= steps);
    CHECK (last < 1e-3);
    CHECK (allocation.matrix == solveAllocation (problem, AllocationGoal::peak).matrix);

    for (const auto stopAt : { 1, 2, looks / 2 })
    {
        auto count = 0;
        const WatchScope scope ([&] { return ++count < stopAt; });
        CHECK_THROWS_AS (solveAllocation (problem, AllocationGoal::peak), Cancelled);
        CHECK (count == stopAt);
    }

    const auto minimum = allocation.certificate.minimumPeakRatio;
    const WatchScope never ([] { return false; });
    CHECK_THROWS_AS (solveAllocation (withLimits (problem, 1.1, minimum), AllocationGoal::norm), Cancelled);
}
