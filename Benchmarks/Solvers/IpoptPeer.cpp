#include "IpoptPeer.h"

#include <antinode_allocation/WhitenedAllocation.h>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpTNLP.hpp>

#include <ctime>

namespace antinode::bench
{
namespace
{
using Ipopt::Index;
using Ipopt::Number;

/** Constraints: the rows, dense, then the samples ceramic by ceramic, N_d entries each. */
class QuadraticProgramme : public Ipopt::TNLP
{
public:
    QuadraticProgramme (const PeerProblem& problemToUse, Eigen::VectorXd& xToFill) : problem (problemToUse), x (xToFill)
    {
    }

    bool get_nlp_info (Index& n, Index& m, Index& jacobian, Index& hessian, IndexStyleEnum& style) override
    {
        n = problem.unknowns();
        m = hardRows() + problem.samples() * ceramics();
        jacobian = hardRows() * n + problem.samples() * n;
        hessian = n;
        style = C_STYLE;
        return true;
    }

    bool get_bounds_info (Index n, Number* xLow, Number* xHigh, Index, Number* low, Number* high) override
    {
        constexpr Number unlimited = 2e19;
        std::fill (xLow, xLow + n, -unlimited);
        std::fill (xHigh, xHigh + n, unlimited);

        for (Index k = 0; k < hardRows(); ++k)
            low[k] = high[k] = problem.whitened.wanted[k];

        for (Index i = 0; i < ceramics(); ++i)
        {
            const auto first = hardRows() + i * problem.samples();
            std::fill (low + first, low + first + problem.samples(), -problem.whitened.limits[i]);
            std::fill (high + first, high + first + problem.samples(), problem.whitened.limits[i]);
        }

        return true;
    }

    bool get_starting_point (Index n, bool, Number* start, bool, Number*, Number*, Index, bool, Number*) override
    {
        const Eigen::MatrixXd shares = RowSystem (problem.whitened).leastNormShares();
        std::copy (shares.data(), shares.data() + n, start);
        return true;
    }

    bool eval_f (Index n, const Number* point, bool, Number& value) override
    {
        value = 0.5 * Eigen::Map<const Eigen::VectorXd> (point, n).squaredNorm();
        return true;
    }

    bool eval_grad_f (Index n, const Number* point, bool, Number* gradient) override
    {
        std::copy (point, point + n, gradient);
        return true;
    }

    bool eval_g (Index n, const Number* point, bool, Index, Number* values) override
    {
        const Eigen::Map<const Eigen::VectorXd> all (point, n);
        Eigen::Map<Eigen::VectorXd> (values, hardRows()) = problem.rows * all;
        Eigen::Map<Eigen::MatrixXd> (values + hardRows(), problem.samples(), ceramics()) =
            problem.whitened.basis * Eigen::Map<const Eigen::MatrixXd> (point, problem.whitened.drives(), ceramics());
        return true;
    }

    bool eval_jac_g (Index n, const Number*, bool, Index, Index, Index* row, Index* column, Number* values) override
    {
        Index entry = 0;
        const auto put = [&] (Index r, Index c, double value)
        {
            if (values == nullptr)
            {
                row[entry] = r;
                column[entry] = c;
            }
            else
                values[entry] = value;

            ++entry;
        };

        for (Index k = 0; k < hardRows(); ++k)
            for (Index c = 0; c < n; ++c)
                put (k, c, problem.rows (k, c));

        const auto drives = static_cast<Index> (problem.whitened.drives());

        for (Index i = 0; i < ceramics(); ++i)
            for (Index s = 0; s < problem.samples(); ++s)
                for (Index l = 0; l < drives; ++l)
                    put (hardRows() + i * problem.samples() + s, i * drives + l, problem.whitened.basis (s, l));

        return true;
    }

    bool eval_h (Index n, const Number*, bool, Number factor, Index, const Number*, bool, Index, Index* row,
                 Index* column, Number* values) override
    {
        for (Index c = 0; c < n; ++c)
        {
            if (values == nullptr)
                row[c] = column[c] = c;
            else
                values[c] = factor;
        }

        return true;
    }

    void finalize_solution (Ipopt::SolverReturn, Index n, const Number* point, const Number*, const Number*, Index,
                            const Number*, const Number*, Number, const Ipopt::IpoptData*,
                            Ipopt::IpoptCalculatedQuantities*) override
    {
        x = Eigen::Map<const Eigen::VectorXd> (point, n);
    }

private:
    Index hardRows() const { return static_cast<Index> (problem.rows.rows()); }
    Index ceramics() const { return static_cast<Index> (problem.whitened.ceramics()); }

    const PeerProblem& problem;
    Eigen::VectorXd& x;
};
} // namespace

PeerResult solveByIpopt (const PeerProblem& problem, double tolerance)
{
    PeerResult result;
    const auto begin = std::clock();
    Ipopt::SmartPtr<Ipopt::TNLP> programme = new QuadraticProgramme (problem, result.x);
    Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication();
    const auto options = application->Options();
    options->SetIntegerValue ("print_level", 0);
    options->SetStringValue ("sb", "yes");
    options->SetStringValue ("mehrotra_algorithm", "yes");
    options->SetStringValue ("jac_c_constant", "yes");
    options->SetStringValue ("jac_d_constant", "yes");
    options->SetStringValue ("hessian_constant", "yes");
    options->SetNumericValue ("tol", tolerance);
    options->SetNumericValue ("bound_relax_factor", 0);
    result.hasEnded = application->Initialize() == Ipopt::Solve_Succeeded
                      && application->OptimizeTNLP (programme) == Ipopt::Solve_Succeeded;
    result.seconds = static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
    return result;
}
} // namespace antinode::bench
