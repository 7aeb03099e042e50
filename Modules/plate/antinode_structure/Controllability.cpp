#include "Controllability.h"

#include <antinode_numerics/Decompositions.h>

#include <cmath>
#include <complex>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** Integral over 0..T of e^{p t}. */
Complex exponentialIntegral (Complex p, double duration)
{
    const auto phase = p * duration;
    return std::abs (phase) < 1e-8 ? Complex (duration) : (std::exp (phase) - 1.0) / p;
}
} // namespace

Eigen::MatrixXd velocityKernel (const Eigen::VectorXd& angularFrequencies, const Eigen::VectorXd& dampingRatios,
                                double duration)
{
    const auto modes = angularFrequencies.size();
    Eigen::VectorXcd poles (modes), amplitudes (modes);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto decay = dampingRatios[k] * angularFrequencies[k];
        const auto damped = angularFrequencies[k] * std::sqrt (1 - dampingRatios[k] * dampingRatios[k]);
        poles[k] = { -decay, damped };
        amplitudes[k] = { 1, decay / damped };
    }

    // h_k = Re [c_k e^{p_k t}], and the product of two real parts is half the real part of both of their products.
    return Eigen::MatrixXd::NullaryExpr (
        modes, modes,
        [&] (Eigen::Index k, Eigen::Index l)
        {
            const auto sum = amplitudes[k] * amplitudes[l] * exponentialIntegral (poles[k] + poles[l], duration);
            const auto difference = amplitudes[k] * std::conj (amplitudes[l])
                                    * exponentialIntegral (poles[k] + std::conj (poles[l]), duration);
            return 0.5 * (sum + difference).real();
        });
}

double worstControllability (const Eigen::MatrixXd& kernel, const Eigen::MatrixXd& participation)
{
    const Eigen::MatrixXd gramian = kernel.cwiseProduct (participation * participation.transpose());
    return symmetricEigenvalues (gramian)[0];
}
} // namespace antinode
