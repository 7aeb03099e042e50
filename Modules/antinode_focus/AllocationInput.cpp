#include "AllocationInput.h"

#include <antinode_model/InputError.h>

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

std::string size (const Eigen::MatrixXd& matrix)
{
    return std::to_string (matrix.rows()) + " x " + std::to_string (matrix.cols());
}

void checkSize (const char* name, const Eigen::MatrixXd& matrix, Eigen::Index rows, Eigen::Index columns)
{
    check (matrix.rows() == rows && matrix.cols() == columns, std::string (name) + " are " + size (matrix)
                                                                  + ", allowed is " + std::to_string (rows) + " x "
                                                                  + std::to_string (columns));
    check (matrix.allFinite(), std::string (name) + " hold a value that is not finite");
}
} // namespace

void validate (const AllocationProblem& problem)
{
    const auto drives = problem.waveforms.rows();
    const auto modes = problem.wanted.size();
    const auto ceramics = problem.voltageLimits.size();
    const auto guards = problem.guardRows.rows();
    check (problem.waveforms.size() > 0, "has no drives or no samples of them, at least one of each is needed");
    check (ceramics > 0, "has no ceramics, at least one is needed");
    checkSize ("waveforms", problem.waveforms, drives, problem.waveforms.cols());
    checkSize ("wanted values", problem.wanted, modes, 1);
    checkSize ("participations", problem.participation, modes, ceramics);
    checkSize ("rows", problem.rows, modes, drives);

    if (guards > 0 || problem.guardParticipation.rows() > 0)
    {
        checkSize ("guard rows", problem.guardRows, guards, drives);
        checkSize ("guard participations", problem.guardParticipation, guards, ceramics);
    }

    checkSize ("voltage limits", problem.voltageLimits, ceramics, 1);
    check (problem.voltageLimits.minCoeff() > 0, "has a voltage limit of "
                                                     + std::to_string (problem.voltageLimits.minCoeff())
                                                     + " V, allowed is more than 0");
    check (problem.guardWeight >= 0 && problem.guardWeight <= 1e12,
           "has a guard weight of " + std::to_string (problem.guardWeight) + ", allowed is 0 to 1e12");
}
} // namespace antinode
