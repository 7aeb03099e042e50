#include "AllocationInstances.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_base/InputError.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 192000;

/** Slopes between samples, 1/s. */
Eigen::MatrixXd differences (const Eigen::MatrixXd& waveforms)
{
    const auto count = waveforms.cols() - 1;
    return rate * (waveforms.rightCols (count) - waveforms.leftCols (count));
}

double slewRatio (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    const Eigen::VectorXd steepest = (matrix * problem.slopes).cwiseAbs().rowwise().maxCoeff();
    return steepest.cwiseQuotient (problem.slewLimits).maxCoeff();
}

double voltageRatio (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    const Eigen::VectorXd peaks = (matrix * problem.waveforms).cwiseAbs().rowwise().maxCoeff();
    return peaks.cwiseQuotient (problem.voltageLimits).maxCoeff();
}

AllocationProblem plateInstance (ModePattern pattern = ModePattern::plate)
{
    return instance (pattern, RowKind::terminal, { 6, 10, 2000, 4, rate }, 11);
}

/** The problem with slew limits in parts of the steepest slope of the answer that its voltage limits alone allow. */
AllocationProblem withSlewLimits (AllocationProblem problem, double share)
{
    const auto steep = solveAllocation (problem, AllocationGoal::norm).matrix;
    problem.slopes = differences (problem.waveforms);
    problem.slewLimits = Eigen::VectorXd::Constant (6, share * (steep * problem.slopes).cwiseAbs().maxCoeff());
    return problem;
}
} // namespace

TEST_CASE ("Slopes that are multiples of the drives limit as lower voltage limits do", "[allocation]")
{
    auto problem = plateInstance();
    const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
    problem.guardWeight = 10;
    const auto tight = solveAllocation (withLimits (problem, 1.1, minimum), AllocationGoal::norm);
    auto slewed = withLimits (problem, 2.2, minimum);
    slewed.slopes = 7e4 * problem.waveforms;
    slewed.slewLimits = 3.5e4 * slewed.voltageLimits;
    const auto allocation = solveAllocation (slewed, AllocationGoal::norm);
    CHECK (allocation.certificate.status == AllocationStatus::optimal);
    CHECK (allocation.certificate.gap <= 1e-6);
    CHECK (allocation.certificate.objective == Approx (tight.certificate.objective).epsilon (1e-6));
    CHECK ((allocation.matrix - tight.matrix).norm() <= 1e-3 * tight.matrix.norm());

    const auto peak = solveAllocation (slewed, AllocationGoal::peak);
    CHECK (peak.certificate.minimumPeakRatio == Approx (2.0 / 2.2).epsilon (2e-6));
}

TEST_CASE ("Voltage and slew limits are kept together, at a certified least energy", "[allocation]")
{
    for (const auto pattern : { ModePattern::beam, ModePattern::plate })
    {
        auto problem = plateInstance (pattern);
        const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
        problem = withLimits (problem, 1.2, minimum);
        const auto free = solveAllocation (problem, AllocationGoal::norm);

        for (const auto share : { 0.95, 0.8 })
        {
            const auto slewed = withSlewLimits (problem, share);
            const auto allocation = solveAllocation (slewed, AllocationGoal::norm);
            CAPTURE (share, slewRatio (slewed, free.matrix));
            CHECK (allocation.certificate.status == AllocationStatus::optimal);
            CHECK (slewRatio (slewed, allocation.matrix) <= 1 + 1e-9);
            CHECK (slewRatio (slewed, allocation.matrix) >= 1 - 1e-6);
            CHECK (voltageRatio (slewed, allocation.matrix) <= 1 + 1e-9);
            CHECK (allocation.certificate.gap <= 1e-6);
            CHECK (allocation.certificate.objective > free.certificate.objective);
            CHECK (allocation.certificate.bound > free.certificate.objective);
        }
    }
}

TEST_CASE ("Slew limits out of reach are proven so, with what can be reached", "[allocation]")
{
    auto problem = withSlewLimits (plateInstance(), 0.8);
    problem.voltageLimits *= 1e6; // Far beyond what is needed.
    const auto minimum = solveAllocation (problem, AllocationGoal::peak).certificate.minimumPeakRatio;
    problem.slewLimits *= 0.5 * minimum;
    const auto allocation = solveAllocation (problem, AllocationGoal::norm);
    CHECK (allocation.certificate.status == AllocationStatus::infeasible);
    CHECK (allocation.certificate.minimumPeakRatio == Approx (2).epsilon (1e-5));

    problem.wanted /= allocation.certificate.minimumPeakRatio * (1 + 1e-5);
    CHECK (solveAllocation (problem, AllocationGoal::norm).certificate.status == AllocationStatus::optimal);
}

TEST_CASE ("Slopes without slew limits, and limits without slopes, are refused", "[allocation]")
{
    auto problem = withSlewLimits (plateInstance(), 0.8);
    problem.slewLimits[2] = 0;
    CHECK_THROWS_WITH (solveAllocation (problem, AllocationGoal::norm),
                       Catch::Contains ("slew limit of 0 V/s; allowed: above 0 V/s"));
    problem.slewLimits.resize (0);
    CHECK_THROWS_AS (solveAllocation (problem, AllocationGoal::norm), InputError);
    problem = withSlewLimits (plateInstance(), 0.8);
    problem.slopes.resize (0, 0);
    CHECK_THROWS_AS (solveAllocation (problem, AllocationGoal::norm), InputError);
}
