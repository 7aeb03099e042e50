#include "AllocationInstances.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_base/InputError.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("Nothing wanted needs no voltage", "[allocation]")
{
    auto problem = instance (ModePattern::beam, RowKind::terminal, standardSizes[0], 1);
    problem.wanted.setZero();
    const auto allocation = solveAllocation (problem, AllocationGoal::norm);
    CHECK (allocation.matrix == Eigen::MatrixXd::Zero (2, 2));
    CHECK (allocation.certificate.status == AllocationStatus::unconstrained);
    CHECK (minimumNormAllocation (problem) == Eigen::MatrixXd::Zero (2, 2));
}

TEST_CASE ("A mode that no ceramic moves is named, unless nothing is wanted of it", "[allocation]")
{
    auto problem = instance (ModePattern::beam, RowKind::terminal, standardSizes[1], 1);
    problem.participation.row (2).setConstant (1e-18);
    CHECK_THROWS_WITH (solveAllocation (problem, AllocationGoal::norm),
                       Catch::Contains ("no ceramic excites controlled mode row 3"));
    CHECK_THROWS_AS (minimumNormAllocation (problem), InputError);
    problem.wanted[2] = 0;
    CHECK (solveAllocation (problem, AllocationGoal::norm).matrix.allFinite());
}

TEST_CASE ("Rows that cannot be told apart are named", "[allocation]")
{
    auto problem = instance (ModePattern::beam, RowKind::terminal, standardSizes[1], 1);
    problem.participation.row (4) = 2 * problem.participation.row (1);
    problem.rows.row (4) = problem.rows.row (1);
    CHECK_THROWS_WITH (solveAllocation (problem, AllocationGoal::norm), Catch::Contains ("controlled mode row 5"));
}

TEST_CASE ("A problem that is not well-formed is refused", "[allocation]")
{
    const auto good = instance (ModePattern::beam, RowKind::terminal, { 3, 4, 300, 2, 96000 }, 1);
    const auto refused = [&] (auto spoil)
    {
        auto problem = good;
        spoil (problem);
        CHECK_THROWS_AS (solveAllocation (problem, AllocationGoal::norm), InputError);
        CHECK_THROWS_AS (minimumNormAllocation (problem), InputError);
    };
    refused ([] (auto& p) { p.waveforms.resize (0, 0); });
    refused ([] (auto& p) { p.waveforms (1, 2) = std::numeric_limits<double>::quiet_NaN(); });
    refused ([] (auto& p) { p.participation (0, 0) = std::numeric_limits<double>::infinity(); });
    refused ([] (auto& p) { p.participation.resize (4, 2); });
    refused ([] (auto& p) { p.rows.resize (4, 3); });
    refused ([] (auto& p) { p.wanted.resize (3); });
    refused ([] (auto& p) { p.guardRows.resize (2, 1); });
    refused ([] (auto& p) { p.guardWeight = -1; });
    refused ([] (auto& p) { p.guardWeight = std::numeric_limits<double>::quiet_NaN(); });
    refused ([] (auto& p) { p.voltageLimits[1] = 0; });
    refused ([] (auto& p) { p.voltageLimits.resize (0); });
}
