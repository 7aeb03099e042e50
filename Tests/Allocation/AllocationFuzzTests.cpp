#include "AllocationInstances.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_base/InputError.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Small numbers and choices, the same on every library. */
class Choice
{
public:
    explicit Choice (std::uint32_t seed) : random (seed) {}

    int below (int count) { return static_cast<int> (random() % static_cast<unsigned> (count)); }
    bool oneIn (int count) { return below (count) == 0; }

private:
    std::mt19937_64 random;
};

/** What goes wrong in real descriptions: twins, modes that nothing moves, a window in which drives cannot be told
    apart. */
void spoil (AllocationProblem& problem, Choice& choice)
{
    const auto modes = static_cast<int> (problem.wanted.size());
    const auto ceramics = static_cast<int> (problem.voltageLimits.size());

    if (choice.oneIn (6))
        problem.participation.row (choice.below (modes)).setZero();

    if (choice.oneIn (6))
        problem.participation.col (choice.below (ceramics)).setZero();

    if (choice.oneIn (6))
        problem.waveforms.row (choice.below (modes)) = problem.waveforms.row (choice.below (modes));

    if (choice.oneIn (8))
    {
        const auto copy = choice.below (modes), original = choice.below (modes);
        problem.participation.row (copy) = problem.participation.row (original);
        problem.rows.row (copy) = problem.rows.row (original);
    }

    if (choice.oneIn (8))
        problem.waveforms = problem.waveforms.rightCols (1 + choice.below (2 * modes)).eval();

    if (choice.oneIn (8))
        problem.wanted[choice.below (modes)] = 0;
}

/** Limits about the peak of the least norm, some below what can be reached. What has no least norm keeps its limits. */
void limit (AllocationProblem& problem, Choice& choice)
{
    try
    {
        const auto peak = (minimumNormAllocation (problem) * problem.waveforms).cwiseAbs().maxCoeff();

        if (peak > 0)
            problem.voltageLimits *= 0.1 * (5 + choice.below (6)) * peak / problem.voltageLimits.maxCoeff();
    }
    catch (const InputError&)
    {
    }
}

/** Slew limits about the steepest slope that the voltage limits leave, in any unit of time. */
void limitSlew (AllocationProblem& problem, Choice& choice)
{
    const auto count = problem.waveforms.cols() - 1;

    if (count < 1 || ! choice.oneIn (4))
        return;

    const auto rate = std::pow (10.0, choice.below (13) - 6);
    problem.slopes = rate * (problem.waveforms.rightCols (count) - problem.waveforms.leftCols (count));
    problem.slewLimits = problem.voltageLimits * rate * std::pow (2.0, -choice.below (8));
}

AllocationProblem fuzzed (std::uint32_t seed)
{
    Choice choice (seed);
    const InstanceSize size { 1 + choice.below (6),
                              1 + choice.below (8),
                              60 + choice.below (400),
                              3 * choice.below (2),
                              24000.0 * (1 + choice.below (4)),
                              choice.oneIn (4) ? std::pow (10.0, -choice.below (9)) : 0 };
    auto problem = instance (choice.oneIn (2) ? ModePattern::beam : ModePattern::plate,
                             choice.oneIn (2) ? RowKind::identity : RowKind::terminal,
                             size.modes > 1 ? size : InstanceSize { size.ceramics, 1, size.samples }, seed);
    spoil (problem, choice);
    problem.guardWeight = std::pow (10.0, choice.below (5));
    const auto voltage = std::pow (10.0, choice.below (25) - 12);
    const auto velocity = std::pow (10.0, choice.below (25) - 12);
    problem.participation *= velocity / voltage;
    problem.guardParticipation *= velocity / voltage;
    problem.wanted *= velocity;
    problem.voltageLimits *= voltage;
    limit (problem, choice);
    limitSlew (problem, choice);
    return problem;
}

/** Says which row or ceramic is wrong, or what to change. */
bool isClear (const std::string& refusal)
{
    return refusal.find ("controlled mode row") != std::string::npos
           || refusal.find ("control fewer modes") != std::string::npos;
}

struct Outcomes
{
    int answers = 0, limited = 0, refusals = 0;
};

/** By how much slew limits are exceeded, in parts of them. */
double slewBeyond (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    if (problem.slopes.size() == 0)
        return 0;

    const Eigen::VectorXd steepest = (matrix * problem.slopes).cwiseAbs().rowwise().maxCoeff();
    return steepest.cwiseQuotient (problem.slewLimits).maxCoeff() - 1;
}

/** What rounding the matrix to doubles may change at most: sum |a| |b| |M| of each row, in parts of the wanted. */
double rowResolution (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    const Eigen::VectorXd sums = problem.participation.cwiseAbs()
                                     .cwiseProduct (problem.rows.cwiseAbs() * matrix.transpose().cwiseAbs())
                                     .rowwise()
                                     .sum();
    return sums.maxCoeff() / problem.wanted.cwiseAbs().maxCoeff() * std::numeric_limits<double>::epsilon();
}

/** The same for the voltages, in parts of the limits. */
double limitResolution (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    const Eigen::VectorXd sums = (matrix.cwiseAbs() * problem.waveforms.cwiseAbs()).rowwise().maxCoeff();
    return sums.cwiseQuotient (problem.voltageLimits).maxCoeff() * std::numeric_limits<double>::epsilon();
}

void solveOne (const AllocationProblem& problem, AllocationGoal goal, Outcomes& outcomes)
{
    try
    {
        const auto allocation = solveAllocation (problem, goal);
        const auto& certificate = allocation.certificate;
        const Eigen::VectorXd peaks = (allocation.matrix * problem.waveforms).cwiseAbs().rowwise().maxCoeff();
        const auto beyond = peaks.cwiseQuotient (problem.voltageLimits).maxCoeff() - 1;
        ++outcomes.answers;
        outcomes.limited += certificate.status == AllocationStatus::optimal;
        REQUIRE (allocation.matrix.allFinite());
        REQUIRE (std::abs (certificate.gap) <= 1e-6);
        REQUIRE (certificate.rowResidual <= std::max (1e-9, rowResolution (problem, allocation.matrix)));

        if (goal == AllocationGoal::norm && certificate.status != AllocationStatus::infeasible)
        {
            REQUIRE (beyond <= std::max (1.1e-9, limitResolution (problem, allocation.matrix)));
            REQUIRE (slewBeyond (problem, allocation.matrix) <= 1e-8);
        }
    }
    catch (const InputError& error)
    {
        ++outcomes.refusals;
        CAPTURE (std::string (error.what()));
        REQUIRE (isClear (error.what()));
    }
}

Outcomes solveAll (std::uint32_t first, std::uint32_t count)
{
    Outcomes outcomes;

    for (auto seed = first; seed < first + count; ++seed)
    {
        CAPTURE (seed);
        solveOne (fuzzed (seed), seed % 8 == 0 ? AllocationGoal::peak : AllocationGoal::norm, outcomes);
    }

    return outcomes;
}
} // namespace

TEST_CASE ("10 000 spoilt small problems end in a certified answer or a refusal that names the row", "[allocation]")
{
    const auto outcomes = solveAll (1, 10000);
    CHECK (outcomes.answers >= 5000);
    CHECK (outcomes.limited >= 2000);
    CHECK (outcomes.refusals >= 1000);
}
