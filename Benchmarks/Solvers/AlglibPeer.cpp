#include "AlglibPeer.h"

#include <libalglib/optimization.h>

#include <ctime>

namespace antinode::bench
{
namespace
{
/** Rows first, then the samples ceramic by ceramic, all written out. */
alglib::real_2d_array makeConstraints (const PeerProblem& problem)
{
    const auto hard = problem.rows.rows();
    const auto drives = problem.whitened.drives();
    alglib::real_2d_array constraints;
    constraints.setlength (hard + problem.samples() * problem.whitened.ceramics(), problem.unknowns());

    for (alglib::ae_int_t r = 0; r < constraints.rows(); ++r)
        for (alglib::ae_int_t c = 0; c < constraints.cols(); ++c)
        {
            const auto isSample = r >= hard && (r - hard) / problem.samples() == c / drives;
            constraints (r, c) = r < hard   ? problem.rows (r, c)
                                 : isSample ? problem.whitened.basis ((r - hard) % problem.samples(), c % drives)
                                            : 0.0;
        }

    return constraints;
}

alglib::real_1d_array makeBounds (const PeerProblem& problem, double sign)
{
    const auto hard = problem.rows.rows();
    alglib::real_1d_array bounds;
    bounds.setlength (hard + problem.samples() * problem.whitened.ceramics());

    for (alglib::ae_int_t r = 0; r < bounds.length(); ++r)
        bounds[r] =
            r < hard ? problem.whitened.wanted[r] : sign * problem.whitened.limits[(r - hard) / problem.samples()];

    return bounds;
}

void solve (const PeerProblem& problem, double tolerance, PeerResult& result)
{
    const auto unknowns = problem.unknowns();
    alglib::minqpstate state;
    alglib::minqpreport report;
    alglib::real_1d_array x;
    alglib::real_2d_array curvature;
    curvature.setlength (unknowns, unknowns);

    for (int r = 0; r < unknowns; ++r)
        for (int c = 0; c < unknowns; ++c)
            curvature (r, c) = r == c ? 1 : 0;

    alglib::minqpcreate (unknowns, state);
    alglib::minqpsetquadraticterm (state, curvature);
    alglib::minqpsetlc2dense (state, makeConstraints (problem), makeBounds (problem, -1), makeBounds (problem, 1));
    alglib::minqpsetalgodenseipm (state, tolerance);
    alglib::minqpoptimize (state);
    alglib::minqpresults (state, x, report);
    result.hasEnded = report.terminationtype > 0;
    result.x = Eigen::Map<const Eigen::VectorXd> (x.getcontent(), x.length());
}
} // namespace

PeerResult solveByAlglib (const PeerProblem& problem, double tolerance)
{
    PeerResult result;
    const auto begin = std::clock();

    try
    {
        solve (problem, tolerance, result);
    }
    catch (const alglib::ap_error&)
    {
        result.hasEnded = false;
    }

    result.seconds = static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
    return result;
}
} // namespace antinode::bench
