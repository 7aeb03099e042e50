#include "NloptPeer.h"

#include <antinode_allocation/WhitenedAllocation.h>
#include <nlopt.h>

#include <ctime>
#include <vector>

namespace antinode::bench
{
namespace
{
double halfSquare (unsigned count, const double* x, double* gradient, void*)
{
    const Eigen::Map<const Eigen::VectorXd> point (x, count);

    if (gradient != nullptr)
        Eigen::Map<Eigen::VectorXd> (gradient, count) = point;

    return 0.5 * point.squaredNorm();
}

const PeerProblem& problemFrom (void* data)
{
    return *static_cast<const PeerProblem*> (data);
}

/** Gradients are row by row, an unknown a column. */
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void rowErrors (unsigned count, double* errors, unsigned unknowns, const double* x, double* gradient, void* data)
{
    const auto& problem = problemFrom (data);
    Eigen::Map<Eigen::VectorXd> (errors, count) =
        problem.rows * Eigen::Map<const Eigen::VectorXd> (x, unknowns) - problem.whitened.wanted;

    if (gradient != nullptr)
        Eigen::Map<RowMajor> (gradient, count, unknowns) = problem.rows;
}

/** Upper limits of all ceramics, then lower ones. */
void beyondLimits (unsigned count, double* beyond, unsigned unknowns, const double* x, double* gradient, void* data)
{
    const auto& whitened = problemFrom (data).whitened;
    const auto drives = whitened.drives(), samples = whitened.basis.rows();
    const Eigen::MatrixXd voltages =
        whitened.basis * Eigen::Map<const Eigen::MatrixXd> (x, drives, whitened.ceramics());
    const Eigen::MatrixXd limits = whitened.limits.transpose().replicate (samples, 1);
    Eigen::Map<Eigen::MatrixXd> (beyond, samples, 2 * whitened.ceramics()) << voltages - limits, -voltages - limits;

    if (gradient == nullptr)
        return;

    Eigen::Map<RowMajor> all (gradient, count, unknowns);
    all.setZero();

    for (Eigen::Index i = 0; i < whitened.ceramics(); ++i)
    {
        all.block (i * samples, i * drives, samples, drives) = whitened.basis;
        all.block ((whitened.ceramics() + i) * samples, i * drives, samples, drives) = -whitened.basis;
    }
}
} // namespace

PeerResult solveByNlopt (const PeerProblem& problem, double tolerance)
{
    PeerResult result;
    const auto begin = std::clock();
    auto* data = const_cast<PeerProblem*> (&problem); // The interface in C has no const.
    const auto unknowns = static_cast<unsigned> (problem.unknowns());
    const auto limits = static_cast<unsigned> (2 * problem.samples() * problem.whitened.ceramics());
    const std::vector<double> exact (static_cast<std::size_t> (problem.rows.rows()), tolerance);
    const std::vector<double> kept (limits, tolerance);
    auto* search = nlopt_create (NLOPT_LD_SLSQP, unknowns);
    nlopt_set_min_objective (search, halfSquare, nullptr);
    nlopt_add_equality_mconstraint (search, static_cast<unsigned> (exact.size()), rowErrors, data, exact.data());
    nlopt_add_inequality_mconstraint (search, limits, beyondLimits, data, kept.data());
    nlopt_set_ftol_rel (search, tolerance);
    const Eigen::MatrixXd start = RowSystem (problem.whitened).leastNormShares();
    result.x = Eigen::Map<const Eigen::VectorXd> (start.data(), start.size());
    double objective = 0;
    result.hasEnded = nlopt_optimize (search, result.x.data(), &objective) > 0;
    nlopt_destroy (search);
    result.seconds = static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
    return result;
}
} // namespace antinode::bench
