#include "LowerBound.h"

#include "BoundedWaveform.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
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

void validate (const WaveformBoundProblem& problem)
{
    const auto modes = problem.wanted.size();
    const auto ceramics = problem.voltageLimits.size();
    check (modes > 0 && ceramics > 0, "needs at least one mode and one ceramic");
    check (problem.poles.size() == modes && problem.participation.rows() == modes
               && problem.participation.cols() == ceramics,
           "poles, participations, wanted velocities and voltage limits do not agree in size");
    check (problem.poles.allFinite() && problem.participation.allFinite() && problem.wanted.allFinite()
               && problem.voltageLimits.allFinite(),
           "contains a value that is not finite");
    check (problem.poles.real().maxCoeff() <= 0 && problem.poles.imag().minCoeff() > 0,
           "has a pole that grows or does not oscillate; allowed: damped oscillations");
    check (problem.voltageLimits.minCoeff() > 0, "has a voltage limit of 0 V or less; allowed: above 0 V");
    check (std::isfinite (problem.duration) && problem.duration > 0, "has no duration; allowed: above 0 s");

    for (Eigen::Index k = 0; k < modes; ++k)
        check (problem.wanted[k] == 0 || ! problem.participation.row (k).isZero (0),
               "no ceramic excites controlled mode row " + std::to_string (k + 1) + " (counted from 1)");
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

/** y that makes wanted' y / sum_i limit_i integral |f_i| large: the multipliers of the least peak of samples, each held for a step. */
Eigen::VectorXd goodMultipliers (const WaveformBoundProblem& problem)
{
    constexpr auto samplesPerCycle = 8.0;
    constexpr auto mostSamples = 20000.0;
    constexpr auto fewestSamples = 32.0;
    constexpr auto tolerance = 0.005;
    const auto cycles = problem.duration * problem.poles.cwiseAbs().maxCoeff() / (2 * std::numbers::pi);
    const auto samples = std::clamp (std::ceil (samplesPerCycle * cycles), fewestSamples, mostSamples);
    const auto step = problem.duration / samples;
    BoundedWaveformProblem sampled;
    sampled.weights =
        step
        * sampledModes (problem.poles, velocityWeights (problem), step / 2, step, static_cast<Eigen::Index> (samples));
    sampled.participation = problem.participation;
    sampled.wanted = problem.wanted;
    sampled.compliance = Eigen::VectorXd::Zero (problem.wanted.size());
    sampled.limits = problem.voltageLimits;
    return leastWaveformPeak (sampled, tolerance).multipliers;
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

double anyWaveformPeakBound (const WaveformBoundProblem& problem)
{
    constexpr auto roundingAllowance = 1e-9;
    validate (problem);

    if (problem.wanted.isZero (0))
        return 0;

    const auto y = goodMultipliers (problem);
    return std::max (0.0, (1 - roundingAllowance) * problem.wanted.dot (y) / priceBound (problem, y));
}
} // namespace antinode
