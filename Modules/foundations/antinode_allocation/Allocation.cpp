#include "Allocation.h"

#include "AllocationActiveSet.h"
#include "LimitedAllocation.h"
#include "WhitenedAllocation.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

namespace antinode
{
namespace
{
/** A peak ratio below which the limits leave so much room that the exact least one need not be known. */
constexpr auto easyRatio = 0.97;

/** Gaps beyond this are no solution; where the active set leaves one, the interior point tries again. */
constexpr auto largestGap = 1e-6;

/** What the limits must have to spare for the least norm within them to be looked for. */
constexpr auto minimumMargin = 1e-6;

double secondsSince (std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double> (std::chrono::steady_clock::now() - begin).count();
}

Allocation nothing (const AllocationProblem& problem)
{
    Allocation allocation;
    allocation.matrix = Eigen::MatrixXd::Zero (problem.voltageLimits.size(), problem.waveforms.rows());
    return allocation;
}

void addEffort (AllocationCertificate& certificate, const AllocationEffort& effort)
{
    certificate.iterations += effort.iterations;
    certificate.rounds += effort.rounds;
}

/** What the hard rows miss, from the matrix itself. */
Eigen::VectorXd missingValues (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    Eigen::VectorXd missing =
        problem.wanted - problem.participation.cwiseProduct (problem.rows * matrix.transpose()).rowwise().sum();

    if (problem.secondRows.rows() > 0)
        missing -= problem.secondParticipation.cwiseProduct (problem.secondRows * matrix.transpose()).rowwise().sum();

    return missing;
}

/** The largest error of a hard row. */
double rowResidual (const AllocationProblem& problem, const Eigen::MatrixXd& matrix)
{
    return missingValues (problem, matrix).cwiseAbs().maxCoeff() / problem.wanted.cwiseAbs().maxCoeff();
}

/** The matrix of shares. Where drives are nearly dependent the product rounds away what the rows ask for; it is put
   back. */
Eigen::MatrixXd refinedMatrix (const AllocationProblem& problem, const WhitenedAllocation& whitened,
                               const Eigen::MatrixXd& shares)
{
    constexpr auto accurate = 1e-10;
    auto matrix = whitened.matrix (shares);

    if (rowResidual (problem, matrix) > accurate)
        matrix += whitened.matrix (whitened.completing (missingValues (problem, matrix)));

    return matrix;
}

/** Of a gap, or of what the rows miss. */
void checkSolved (double error)
{
    if (! (std::abs (error) <= largestGap))
        throw InputError ("allocation",
                          "cannot be solved accurately because drives or rows are nearly linearly dependent; "
                          "control fewer modes, or choose growths that differ more");
}

/** The shares by the active set, with status, bound and effort of the certificate. */
std::optional<Eigen::MatrixXd> activeShares (const WhitenedAllocation& whitened, const RowSystem& rows,
                                             const Eigen::MatrixXd& unlimited, AllocationCertificate& certificate,
                                             const ShowAllocationProgress& show)
{
    const auto result = activeSetShares (whitened, rows, 1, unlimited, show);

    if (! result || ! (result->gap() <= largestGap))
        return {};

    certificate.status = AllocationStatus::optimal;
    certificate.bound = result->bound;
    addEffort (certificate, result->effort);
    return result->shares;
}

/** The shares by interior points, with status, bound and effort of the certificate. */
Eigen::MatrixXd limitedShares (const WhitenedAllocation& whitened, const RowSystem& rows, AllocationGoal goal,
                               double peakRoom, AllocationCertificate& certificate, const ShowAllocationProgress& show)
{
    const auto hardOnly = whitened.withoutGuards();
    const auto isPeak = goal == AllocationGoal::peak;
    const auto minimum = minimumPeakShares (hardOnly, RowSystem (hardOnly), isPeak ? 0.0 : easyRatio, show);

    if (isPeak || minimum.value > easyRatio)
        checkSolved (minimum.gap());

    const auto isInfeasible = ! isPeak && minimum.value > 1 - minimumMargin;
    const auto ratio = isPeak || isInfeasible ? peakRoom * minimum.bound : 1.0;
    const auto result = leastNormShares (whitened, rows, ratio, minimum.shares, show);
    certificate.status = isInfeasible ? AllocationStatus::infeasible : AllocationStatus::optimal;
    certificate.minimumPeakRatio = minimum.bound;
    certificate.bound = result.bound;
    addEffort (certificate, minimum.effort);
    addEffort (certificate, result.effort);
    return result.shares;
}
} // namespace

Allocation solveAllocation (const AllocationProblem& problem, AllocationGoal goal, const ShowAllocationProgress& show)
{
    const auto begin = std::chrono::steady_clock::now();
    validate (problem);

    if (problem.wanted.isZero (0))
        return nothing (problem);

    const auto whitened = whiten (problem);
    const RowSystem rows (whitened);
    auto shares = rows.leastNormShares();
    Allocation allocation;
    auto& certificate = allocation.certificate;

    certificate.peakRatio = whitened.peakRatio (shares);

    if (goal == AllocationGoal::peak || certificate.peakRatio > 1)
    {
        const auto active = goal == AllocationGoal::norm ? activeShares (whitened, rows, shares, certificate, show)
                                                         : std::optional<Eigen::MatrixXd>();
        shares = active ? *active : limitedShares (whitened, rows, goal, problem.peakRoom, certificate, show);
        certificate.peakRatio = whitened.peakRatio (shares);
    }
    else
        certificate.bound =
            leastNormBound (whitened, rows, Eigen::MatrixXd::Zero (whitened.basis.rows(), shares.cols()), 1);

    const auto voltsSquared = whitened.voltageUnit * whitened.voltageUnit;
    certificate.bound *= voltsSquared;
    certificate.objective = whitened.objective (shares) * voltsSquared;
    certificate.peakVoltage =
        whitened.voltages (shares).topRows (problem.waveforms.cols()).cwiseAbs().maxCoeff() * whitened.voltageUnit;
    certificate.gap = (certificate.objective - certificate.bound) / certificate.objective;
    checkSolved (certificate.gap);
    allocation.matrix = refinedMatrix (problem, whitened, shares);
    certificate.rowResidual = rowResidual (problem, allocation.matrix);
    checkSolved (certificate.rowResidual);
    certificate.milliseconds = 1000 * secondsSince (begin);
    return allocation;
}

Eigen::MatrixXd minimumNormAllocation (const AllocationProblem& problem)
{
    validate (problem);

    if (problem.wanted.isZero (0))
        return nothing (problem).matrix;

    const auto whitened = whiten (problem);
    return whitened.matrix (RowSystem (whitened).leastNormShares());
}

namespace
{
void check (bool isRight, const std::string& wrong)
{
    if (! isRight)
        throw InputError ("allocation", wrong);
}

std::string number (double value)
{
    std::ostringstream stream;
    stream << value;
    return stream.str();
}

std::string size (const Eigen::MatrixXd& matrix)
{
    return std::to_string (matrix.rows()) + " x " + std::to_string (matrix.cols());
}

void checkSize (const char* name, const Eigen::MatrixXd& matrix, Eigen::Index rows, Eigen::Index columns)
{
    check (matrix.rows() == rows && matrix.cols() == columns, std::string (name) + " have size " + size (matrix)
                                                                  + "; allowed: " + std::to_string (rows) + " x "
                                                                  + std::to_string (columns));
    check (matrix.allFinite(), std::string (name) + " contain a value that is not finite");
}

void checkLimits (const char* name, const Eigen::VectorXd& limits, Eigen::Index ceramics, const char* unit)
{
    checkSize ((std::string (name) + " limits").c_str(), limits, ceramics, 1);
    check (limits.minCoeff() > 0, std::string ("has a ") + name + " limit of " + number (limits.minCoeff()) + " " + unit
                                      + "; allowed: above 0 " + unit);
}

/** Samples of the slopes that are limited; neither limits without slopes nor slopes without limits. */
void checkSlopes (const AllocationProblem& problem, Eigen::Index drives, Eigen::Index ceramics)
{
    if (problem.slopes.size() == 0 && problem.slewLimits.size() == 0)
        return;

    checkSize ("slopes", problem.slopes, drives, std::max<Eigen::Index> (1, problem.slopes.cols()));
    checkLimits ("slew", problem.slewLimits, ceramics, "V/s");
}
} // namespace

void validate (const AllocationProblem& problem)
{
    const auto drives = problem.waveforms.rows();
    const auto modes = problem.wanted.size();
    const auto ceramics = problem.voltageLimits.size();
    const auto guards = problem.guardRows.rows();
    check (problem.waveforms.size() > 0, "has no drives or no samples of them; at least one of each is needed");
    check (ceramics > 0, "has no ceramics; at least one is needed");
    checkSize ("waveforms", problem.waveforms, drives, problem.waveforms.cols());
    checkSize ("wanted values", problem.wanted, modes, 1);
    checkSize ("participations", problem.participation, modes, ceramics);
    checkSize ("rows", problem.rows, modes, drives);

    if (guards > 0 || problem.guardParticipation.rows() > 0)
    {
        checkSize ("guard rows", problem.guardRows, guards, drives);
        checkSize ("guard participations", problem.guardParticipation, guards, ceramics);
    }

    if (problem.secondRows.rows() > 0 || problem.secondParticipation.rows() > 0)
    {
        checkSize ("second participations", problem.secondParticipation, modes, ceramics);
        checkSize ("second rows", problem.secondRows, modes, drives);
        checkSize ("second guard rows", problem.secondGuardRows, guards, drives);
        checkSize ("second guard participations", problem.secondGuardParticipation, guards, ceramics);
    }

    checkLimits ("voltage", problem.voltageLimits, ceramics, "V");
    checkSlopes (problem, drives, ceramics);
    check (problem.guardWeight >= 0 && problem.guardWeight <= 1e12,
           "has a guard weight of " + number (problem.guardWeight) + "; allowed: 0 to 1e12");
}
} // namespace antinode
