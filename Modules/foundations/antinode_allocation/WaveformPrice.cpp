#include "WaveformPrice.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;
constexpr int terms = 8; // of the polynomials
constexpr Eigen::Index block = 32;
using Polynomial = std::array<double, terms>; // in x = 2 (tau - middle) / step, |x| <= 1

double at (const Polynomial& p, double x)
{
    double value = 0;

    for (int m = terms - 1; m >= 0; --m)
        value = value * x + p[static_cast<std::size_t> (m)];

    return value;
}

/** An upper bound of the integral of |p| over |x| <= 1. */
double absoluteIntegral (const Polynomial& p)
{
    constexpr int parts = 16;
    constexpr auto step = 2.0 / parts;
    double others = 0, curvature = 0, even = 0;

    for (int m = 0; m < terms; ++m)
    {
        const auto size = std::abs (p[static_cast<std::size_t> (m)]);
        others += m > 0 ? size : 0;
        curvature += m * (m - 1) * size;
        even += m % 2 == 0 ? 2 * p[static_cast<std::size_t> (m)] / (m + 1) : 0;
    }

    if (std::abs (p[0]) > others)
        return std::abs (even);

    double sum = 0, left = at (p, -1);

    for (int n = 1; n <= parts; ++n)
    {
        const auto right = at (p, -1 + n * step);
        const auto both = std::abs (left) + std::abs (right);
        sum += left * right >= 0 || both == 0 ? both : (left * left + right * right) / both;
        left = right;
    }

    return step * (0.5 * sum + parts * step * step * curvature / 12);
}

/** What f_i is made of: gains (i, k) Re [weight_k e^{s_k tau}]. */
struct Terms
{
    Eigen::VectorXcd poles, weights;
    Eigen::MatrixXd gains;
    Eigen::VectorXd limits;

    /** sum_i limit_i sum_k |gain weight s^order| e^{-a tau}: never less than what the order-th derivatives sum to from
        tau on. */
    double derivativeBound (double tau, int order) const
    {
        const Eigen::ArrayXd sizes =
            weights.array().abs() * poles.array().abs().pow (order) * (poles.real().array() * tau).exp();
        return limits.dot (gains.cwiseAbs() * sizes.matrix());
    }
};

double factorial (int n)
{
    return std::tgamma (n + 1.0);
}

/** The Taylor coefficients m of all f_i around first + (n + 1/2) step, N_b x block each. */
std::array<Eigen::MatrixXd, terms> taylor (const Terms& sum, double first, double step)
{
    const auto modes = sum.poles.size();
    std::array<Eigen::MatrixXd, terms> result;
    Eigen::MatrixXcd values (modes, block);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        checkWatch();
        const auto turn = std::exp (sum.poles[k] * step);
        values (k, 0) = sum.weights[k] * std::exp (sum.poles[k] * (first + 0.5 * step));

        for (Eigen::Index n = 1; n < block; ++n)
            values (k, n) = values (k, n - 1) * turn;
    }

    for (int m = 0; m < terms; ++m)
    {
        auto& coefficients = result[static_cast<std::size_t> (m)];
        coefficients = Eigen::MatrixXd::Zero (sum.gains.rows(), block);
        addProduct (coefficients, 1, sum.gains, values.real());
        values = (sum.poles * (0.5 * step / (m + 1))).asDiagonal() * values;
    }

    return result;
}
} // namespace

double waveformPrice (const WaveformBoundProblem& problem, const Eigen::VectorXd& y, double about)
{
    constexpr auto remainderPart = 1e-5, widest = 1.0 / 64;
    constexpr auto rounding = 64 * std::numeric_limits<double>::epsilon();
    const auto& poles = problem.poles;
    const Terms sum { poles, (Complex (0, -1) * poles.array() / poles.imag().array().cast<Complex>()).matrix(),
                      (y.asDiagonal() * problem.participation).transpose(), problem.voltageLimits };
    const auto end = problem.duration;
    const auto allowed = remainderPart * std::max (about / end, rounding * sum.derivativeBound (0, 0));
    double price = 0;

    for (double tau = 0; tau < end;)
    {
        const auto missed = sum.derivativeBound (tau, terms) / factorial (terms); // times (step/2)^8
        const auto fits = missed > 0 ? 2 * std::pow (allowed / missed, 1.0 / terms) : end;
        const auto step = std::min ({ fits, widest * end, (end - tau) / block });
        const auto coefficients = taylor (sum, tau, step);

        checkWatch();

        for (Eigen::Index n = 0; n < block; ++n)
            for (Eigen::Index i = 0; i < problem.voltageLimits.size(); ++i)
            {
                Polynomial p;

                for (std::size_t m = 0; m < terms; ++m)
                    p[m] = coefficients[m](i, n);

                price += 0.5 * step * problem.voltageLimits[i] * absoluteIntegral (p);
            }

        const auto length = step * block;
        price += length * (missed * std::pow (0.5 * step, terms) + rounding * sum.derivativeBound (tau, 0));
        tau = end - tau <= length * (1 + rounding) ? end : tau + length;
    }

    return price;
}
} // namespace antinode
