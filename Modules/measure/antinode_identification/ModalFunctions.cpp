#include "ModalFunctions.h"

#include <complex>

namespace antinode
{
Eigen::MatrixXcd evaluateModalFunctions (const ModalBasis& basis, Eigen::Index mode, const Eigen::VectorXd& omega)
{
    using std::complex;
    const auto resonance = basis.angularFrequencies[mode], damping = basis.dampingRatios[mode];
    Eigen::MatrixXcd result (omega.size(), basis.functions);

    for (Eigen::Index f = 0; f < omega.size(); ++f)
    {
        const complex<double> velocity (0, omega[f]);
        const complex<double> denominator ((resonance - omega[f]) * (resonance + omega[f]),
                                           2 * damping * resonance * omega[f]);
        const auto g = velocity * resonance / denominator;
        const auto byDenominator = -g / denominator;
        result (f, 0) = g;
        result (f, 1) = byDenominator * complex<double> (2 * resonance, 2 * damping * omega[f]) * damping * resonance;
        result (f, 2) = byDenominator * complex<double> (0, 2 * resonance * omega[f]) * damping;
        result (f, 3) = -velocity * g / resonance;

        for (Eigen::Index derivative = 1; derivative + 3 < basis.functions; ++derivative)
            result (f, derivative + 3) = -velocity * result (f, derivative) / resonance;
    }

    return result;
}

Eigen::MatrixXcd evaluatePowers (const ModalBasis& basis, const Eigen::VectorXd& omega)
{
    Eigen::MatrixXcd result (omega.size(), static_cast<Eigen::Index> (basis.powers.size()));

    for (Eigen::Index f = 0; f < omega.size(); ++f)
        for (std::size_t n = 0; n < basis.powers.size(); ++n)
            result (f, static_cast<Eigen::Index> (n)) =
                std::pow (std::complex<double> (0, omega[f] / basis.scale), basis.powers[n]);

    return result;
}
} // namespace antinode
