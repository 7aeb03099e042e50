#include "LowerBound.h"

#include <antinode_model/InputError.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

void check (bool isRight, const std::string& wrong)
{
    if (! isRight)
        throw InputError ("lower bound", wrong);
}

void validate (const WaveformBoundProblem& problem, int samples)
{
    const auto modes = problem.wanted.size();
    const auto ceramics = problem.voltageLimits.size();
    check (modes > 0 && ceramics > 0, "needs at least one mode and one ceramic");
    check (problem.poles.size() == modes && problem.participation.rows() == modes
               && problem.participation.cols() == ceramics,
           "poles, participations, wanted velocities and voltage limits do not agree in size");
    check (problem.poles.allFinite() && problem.participation.allFinite() && problem.wanted.allFinite()
               && problem.voltageLimits.allFinite(),
           "holds a value that is not finite");
    check (problem.poles.real().maxCoeff() <= 0 && problem.poles.imag().minCoeff() > 0,
           "has a pole that grows or does not oscillate, allowed are damped oscillations");
    check (problem.voltageLimits.minCoeff() > 0, "has a voltage limit of 0 or less, allowed is more than 0");
    check (std::isfinite (problem.duration) && problem.duration > 0, "has no duration, allowed is more than 0 s");
    check (samples >= 2, "has fewer than 2 samples");

    for (Eigen::Index k = 0; k < modes; ++k)
        check (problem.wanted[k] == 0 || ! problem.participation.row (k).isZero (0),
               "no ceramic moves controlled mode row " + std::to_string (k + 1) + " (counted from 1)");
}

/** The weight c = 1 + j a/b in h = Re[c e^{s tau}]. */
Complex velocityWeight (Complex pole)
{
    return { 1, -pole.real() / pole.imag() };
}

Eigen::VectorXcd velocityWeights (const WaveformBoundProblem& problem)
{
    return problem.poles.unaryExpr (&velocityWeight);
}

/** Re[weight_k e^{s_k tau}] at tau = first, first + step, ..., N_k x count. */
Eigen::MatrixXd sampledModes (const Eigen::VectorXcd& poles, const Eigen::VectorXcd& weights, double first, double step,
                              Eigen::Index count)
{
    constexpr Eigen::Index restart = 64;
    Eigen::MatrixXd values (weights.size(), count);

    for (Eigen::Index k = 0; k < weights.size(); ++k)
    {
        const auto turn = std::exp (poles[k] * step);
        Complex value;

        for (Eigen::Index n = 0; n < count; ++n)
        {
            value = n % restart == 0 ? weights[k] * std::exp (poles[k] * (first + step * static_cast<double> (n)))
                                     : value * turn;
            values (k, n) = value.real();
        }
    }

    return values;
}

/** One step of iteratively reweighted least squares: y that minimises sum of weights f_i^2 at fixed wanted' y. */
Eigen::VectorXd weightedMultipliers (const WaveformBoundProblem& problem, const Eigen::MatrixXd& modes,
                                     const Eigen::MatrixXd& weights)
{
    constexpr auto regularisation = 1e-12;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (modes.rows(), modes.rows());

    for (Eigen::Index i = 0; i < weights.rows(); ++i)
    {
        const Eigen::MatrixXd weighted =
            problem.participation.col (i).asDiagonal() * modes * weights.row (i).cwiseSqrt().asDiagonal();
        gram.selfadjointView<Eigen::Lower>().rankUpdate (weighted);
    }

    gram.diagonal().array() += regularisation * gram.diagonal().maxCoeff();
    return gram.selfadjointView<Eigen::Lower>().ldlt().solve (problem.wanted);
}

/** y that makes wanted' y / sum_i limit_i integral |f_i| large. */
Eigen::VectorXd goodMultipliers (const WaveformBoundProblem& problem, Eigen::Index samples)
{
    constexpr auto iterations = 12;
    constexpr auto smallest = 1e-3;
    const auto step = problem.duration / static_cast<double> (samples - 1);
    const auto modes = sampledModes (problem.poles, velocityWeights (problem), 0, step, samples);
    Eigen::MatrixXd weights = problem.voltageLimits.replicate (1, samples);
    Eigen::VectorXd best = problem.wanted;
    double bestRatio = 0;

    for (int iteration = 0; iteration < iterations; ++iteration)
    {
        const auto y = weightedMultipliers (problem, modes, weights);
        const Eigen::MatrixXd force = (problem.participation.transpose() * y.asDiagonal() * modes).cwiseAbs();
        const auto ratio = problem.wanted.dot (y) / force.rowwise().sum().dot (problem.voltageLimits);

        if (ratio > bestRatio)
        {
            best = y;
            bestRatio = ratio;
        }

        weights = problem.voltageLimits.asDiagonal() * force.cwiseMax (smallest * force.mean()).cwiseInverse();
    }

    return best;
}

/** An upper bound of the integral of |f| over a cell: its values at both ends, the change of its antiderivative, and a bound of |f''|. */
double cellIntegral (double left, double right, double change, double step, double curvature)
{
    const auto chordError = step * step * curvature / 8;

    if (left * right > 0 && std::min (std::abs (left), std::abs (right)) > chordError)
        return std::abs (change);

    const auto sum = std::abs (left) + std::abs (right);
    const auto chord = left * right >= 0 || sum == 0 ? sum : (left * left + right * right) / sum;
    return 0.5 * step * chord + step * chordError * 2 / 3;
}

/** An upper bound of sum_i limit_i integral_0^t_f |f_i|. */
double priceBound (const WaveformBoundProblem& problem, const Eigen::VectorXd& y)
{
    constexpr auto radiansPerStep = 0.15;
    constexpr Eigen::Index block = 64;
    const auto blocks = static_cast<Eigen::Index> (
        std::ceil (problem.duration * problem.poles.cwiseAbs().maxCoeff() / (radiansPerStep * block)));
    const auto step = problem.duration / static_cast<double> (blocks * block);
    const auto weights = velocityWeights (problem);
    const Eigen::VectorXcd integrated = weights.cwiseQuotient (problem.poles);
    const Eigen::VectorXd curvatures = weights.cwiseProduct (problem.poles.cwiseAbs2()).cwiseAbs();
    const Eigen::MatrixXd gains = (y.asDiagonal() * problem.participation).transpose();
    double sum = 0;

    for (Eigen::Index first = 0; first < blocks * block; first += block)
    {
        const auto start = static_cast<double> (first) * step;
        const Eigen::MatrixXd values = gains * sampledModes (problem.poles, weights, start, step, block + 1);
        const Eigen::MatrixXd integrals = gains * sampledModes (problem.poles, integrated, start, step, block + 1);
        const Eigen::VectorXd decays = (problem.poles.real() * start).array().exp();
        const Eigen::VectorXd curvature = gains.cwiseAbs() * curvatures.cwiseProduct (decays);

        for (Eigen::Index i = 0; i < gains.rows(); ++i)
            for (Eigen::Index n = 0; n < block; ++n)
                sum += problem.voltageLimits[i]
                       * cellIntegral (values (i, n), values (i, n + 1), integrals (i, n + 1) - integrals (i, n), step,
                                       curvature[i]);
    }

    return sum;
}
} // namespace

double anyWaveformPeakBound (const WaveformBoundProblem& problem, int samples)
{
    constexpr auto roundingAllowance = 1e-9;
    validate (problem, samples);

    if (problem.wanted.isZero (0))
        return 0;

    const auto y = goodMultipliers (problem, samples);
    return std::max (0.0, (1 - roundingAllowance) * problem.wanted.dot (y) / priceBound (problem, y));
}
} // namespace antinode
