#include "AllocationInput.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace antinode
{
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
